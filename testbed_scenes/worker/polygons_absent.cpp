// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "any_size.h"

namespace testbed {

std::unique_ptr<b2Shape> MakeOnePolygon(const Outline &outline) {
    const auto count = static_cast<int32>(outline.size());
    if (count > b2_maxPolygonVertices)
        throw std::runtime_error("stock Box2D has no polygon of " + std::to_string(count) +
                                 " vertices (--bodies many or circle, or the worker with the plugin)");
    auto shape = std::make_unique<b2PolygonShape>();
    shape->Set(outline.data(), count);
    return shape;
}

Outline VerticesOf(const b2PolygonShape &polygon) {
    return Outline(polygon.m_vertices, polygon.m_vertices + polygon.m_count);
}

} // namespace testbed
