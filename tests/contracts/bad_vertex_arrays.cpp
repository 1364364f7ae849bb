// SPDX-License-Identifier: MIT
// What core's makers of polygons say to bad vertex arrays. (Box2D shapes: shapes.cpp.)
#include "bad_vertex_arrays.h"

using namespace contracts;

namespace {

std::string Made(const Vertices &vertices, size_t count, bmr_error audit) {
    return CountOf(count, vertices.count) + (audit == BMR_OK ? "" : ", audit: " + Said(audit));
}

template <bmr_error (*Make)(const bmr_vec2 *, size_t, const bmr_allocator *, bmr_polygon **)>
std::string InDouble(const Vertices &vertices) {
    bmr_polygon *polygon = Untouched<bmr_polygon>();
    const bmr_error error =
        Make(vertices.null ? nullptr : vertices.points.data(), vertices.count, nullptr, &polygon);
    if (error != BMR_OK)
        return Said(error, polygon != Untouched<bmr_polygon>());
    const std::string made = Made(vertices, polygon->count, bmr_polygon_audit(polygon));
    bmr_polygon_destroy(polygon, nullptr);
    return made;
}

template <bmr_error (*Make)(const bmr_vec32 *, size_t, const bmr_allocator *, bmr_convex32_block **)>
std::string InFloat(const Vertices &vertices) {
    const std::vector<bmr_vec32> points = Floats(vertices.points);
    bmr_convex32_block *block = Untouched<bmr_convex32_block>();
    const bmr_error error = Make(vertices.null ? nullptr : points.data(), vertices.count, nullptr, &block);
    if (error != BMR_OK)
        return Said(error, block != Untouched<bmr_convex32_block>());
    const std::string made = Made(vertices, block->polygon.count, bmr_convex32_audit(&block->polygon));
    bmr_convex32_destroy(block, nullptr);
    return made;
}

const Table kTable("bad vertex arrays", [] {
    return VertexArrayTable({{"`bmr_polygon_create`", InDouble<bmr_polygon_create>},
                             {"`bmr_polygon_create_raw`", InDouble<bmr_polygon_create_raw>},
                             {"`bmr_convex32_create`", InFloat<bmr_convex32_create>},
                             {"`bmr_convex32_create_raw`", InFloat<bmr_convex32_create_raw>}});
});

} // namespace
