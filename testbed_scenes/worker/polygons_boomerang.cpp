// SPDX-License-Identifier: MIT
#include <stdexcept>

#include <boomerang/box2d.h>

#include "any_size.h"

namespace testbed {

std::unique_ptr<b2Shape> MakeOnePolygon(const Outline &outline) {
    auto shape = std::make_unique<bmr::ConvexShape>();
    const bmr_error error = shape->Set(outline.data(), static_cast<int32>(outline.size()));
    if (error != BMR_OK)
        throw std::runtime_error("no polygon of " + std::to_string(outline.size()) +
                                 " vertices: " + bmr_error_describe(error));
    return shape;
}

Outline VerticesOf(const b2PolygonShape &polygon) {
    const bmr::ConvexShape *shape = bmr::ConvexShape::From(&polygon);
    if (shape == nullptr)
        return Outline(polygon.m_vertices, polygon.m_vertices + polygon.m_count);
    return Outline(shape->GetVertices(), shape->GetVertices() + shape->GetVertexCount());
}

} // namespace testbed
