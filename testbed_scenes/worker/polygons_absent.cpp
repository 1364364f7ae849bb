// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "shapes.h"

namespace testbed {

std::unique_ptr<b2Shape> MakeOnePolygon(const Vertices &vertices) {
    const auto count = static_cast<int32>(vertices.size());
    if (count > b2_maxPolygonVertices)
        throw std::runtime_error("stock Box2D has no polygon of " + std::to_string(count) +
                                 " vertices (--bodies many or circle, or the worker with the plugin)");
    auto shape = std::make_unique<b2PolygonShape>();
    shape->Set(vertices.data(), count);
    return shape;
}

Vertices VerticesOf(const b2PolygonShape &polygon) {
    return Vertices(polygon.m_vertices, polygon.m_vertices + polygon.m_count);
}

std::vector<std::unique_ptr<b2Shape>> MakeOutlinePieces(const Concave &, float) {
    throw std::runtime_error("stock Box2D has no outlines (--bodies many, or the worker with the plugin)");
}

std::vector<int> InnerEdgesOf(const b2Fixture &) {
    return {};
}

} // namespace testbed
