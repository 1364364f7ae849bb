// SPDX-License-Identifier: MIT
// What core's makers of polygons say to bad points.
#include "boomerang/polygon.h"
#include "convex32/convex32.h"
#include "error_name.h"
#include "points.h"
#include "table.h"

using namespace bad_input;

namespace {

std::vector<bmr_vec2> Doubles(const Points &points) {
    std::vector<bmr_vec2> made;
    for (size_t i = 0; i + 1 < points.xy.size(); i += 2)
        made.push_back({points.xy[i], points.xy[i + 1]});
    return made;
}

std::vector<bmr_vec32> Floats(const Points &points) {
    std::vector<bmr_vec32> made;
    for (const bmr_vec2 &p : Doubles(points))
        made.push_back({static_cast<float>(p.x), static_cast<float>(p.y)});
    return made;
}

std::string Made(size_t count, const Points &given, bmr_error audit) {
    return CountOf(count, given) + (audit == BMR_OK ? "" : ", audit: " + NameOf(audit));
}

using MakePolygon = bmr_error (*)(const bmr_vec2 *, size_t, const bmr_allocator *, bmr_polygon **);

std::string Polygon(const Points &points, MakePolygon make) {
    const std::vector<bmr_vec2> given = Doubles(points);
    bmr_polygon untouched = {}, *polygon = &untouched;
    const bmr_error error = make(points.null ? nullptr : given.data(), points.count, nullptr, &polygon);
    if (error != BMR_OK)
        return NameOf(error) + (polygon == &untouched ? "" : ", and the output is written");
    const std::string made = Made(polygon->count, points, bmr_polygon_audit(polygon));
    bmr_polygon_destroy(polygon, nullptr);
    return made;
}

using MakeConvex = bmr_error (*)(const bmr_vec32 *, size_t, const bmr_allocator *, bmr_convex32_block **);

std::string Convex(const Points &points, MakeConvex make) {
    const std::vector<bmr_vec32> given = Floats(points);
    bmr_convex32_block untouched = {}, *block = &untouched;
    const bmr_error error = make(points.null ? nullptr : given.data(), points.count, nullptr, &block);
    if (error != BMR_OK)
        return NameOf(error) + (block == &untouched ? "" : ", and the output is written");
    const std::string made = Made(block->polygon.count, points, bmr_convex32_audit(&block->polygon));
    bmr_convex32_destroy(block, nullptr);
    return made;
}

} // namespace

int main(int argc, char **argv) {
    const std::vector<Points> all = AllBadPoints();
    const Table points = {"points in core",
                          {"`bmr_polygon_create`", "`bmr_polygon_create_raw`", "`bmr_convex32_create`",
                           "`bmr_convex32_create_raw`"},
                          NamesOf(all),
                          [&all](size_t row, size_t column) {
                              switch (column) {
                              case 0:
                                  return Polygon(all[row], bmr_polygon_create);
                              case 1:
                                  return Polygon(all[row], bmr_polygon_create_raw);
                              case 2:
                                  return Convex(all[row], bmr_convex32_create);
                              default:
                                  return Convex(all[row], bmr_convex32_create_raw);
                              }
                          }};
    return Main(argc, argv, {points});
}
