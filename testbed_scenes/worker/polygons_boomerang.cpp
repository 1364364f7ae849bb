// SPDX-License-Identifier: MIT
#include <stdexcept>

#include <boomerang/box2d.h>

#include "shapes.h"

namespace testbed {

std::unique_ptr<b2Shape> MakeOnePolygon(const Vertices &vertices) {
    auto shape = std::make_unique<bmr::ConvexShape>();
    const bmr_error error = shape->Set(vertices.data(), static_cast<int32>(vertices.size()));
    if (error != BMR_OK)
        throw std::runtime_error("no polygon of " + std::to_string(vertices.size()) +
                                 " vertices: " + bmr_error_describe(error));
    return shape;
}

Vertices VerticesOf(const b2PolygonShape &polygon) {
    const bmr::ConvexShape *shape = bmr::ConvexShape::From(&polygon);
    if (shape == nullptr)
        return Vertices(polygon.m_vertices, polygon.m_vertices + polygon.m_count);
    return Vertices(shape->GetVertices(), shape->GetVertices() + shape->GetVertexCount());
}

std::vector<std::unique_ptr<b2Shape>> MakeOutlinePieces(const Concave &concave, float tolerance) {
    std::vector<bmr::OutlineHole> holes;
    for (const Vertices &hole : concave.holes)
        holes.push_back({hole.data(), static_cast<int32>(hole.size())});
    bmr::OutlineShape outline;
    const bmr_error error = outline.Set(concave.ring.data(), static_cast<int32>(concave.ring.size()),
                                        holes.data(), static_cast<int32>(holes.size()), tolerance);
    if (error != BMR_OK)
        throw std::runtime_error(std::string("no outline: ") + bmr_error_describe(error));
    std::vector<std::unique_ptr<b2Shape>> pieces;
    for (int32 i = 0; i < outline.GetPieceCount(); ++i)
        pieces.push_back(std::make_unique<bmr::ConvexShape>(outline.GetPiece(i)));
    return pieces;
}

std::vector<int> InnerEdgesOf(const b2Fixture &fixture) {
    std::vector<int> inner;
    const bmr::OutlineShape outline = bmr::OutlineShape::From(&fixture);
    for (int32 i = 0; i < outline.GetPieceCount(); ++i) {
        const bmr::ConvexShape piece = outline.GetPiece(i);
        if (piece.GetVertices() != bmr::ConvexShape::From(fixture.GetShape())->GetVertices())
            continue;
        for (int32 edge = 0; edge < piece.GetVertexCount(); ++edge)
            if (outline.IsInnerEdge(i, edge))
                inner.push_back(edge);
    }
    return inner;
}

} // namespace testbed
