// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_PLAIN_PIECES_H
#define BOOMERANG_TEST_PLAIN_PIECES_H

#include <algorithm>

#include <box2d/b2_body.h>
#include <box2d/b2_fixture.h>

#include "boomerang/outline_shape.h"

/// @file
/// The control of tests of seams: the pieces of an outline as polygons that know of none.

namespace outlines {

/// As it is, also where it is so thin that ConvexShape would refuse it.
inline bmr::ConvexShape PlainPiece(const bmr::OutlineShape &outline, int32 index) {
    const bmr::ConvexShape piece = outline.GetPiece(index);
    const int32 count = piece.GetVertexCount();
    bmr::ConvexShape plain;
    if (plain.SetRaw(piece.GetVertices(), count) == BMR_OK || count > b2_maxPolygonVertices)
        return plain;
    std::copy_n(piece.GetVertices(), count, plain.m_vertices);
    std::copy_n(&piece.GetNormal(0), count, plain.m_normals);
    plain.m_count = count;
    plain.m_centroid = piece.m_centroid;
    return plain;
}

inline void AddPlainPieces(b2Body *body, const b2FixtureDef &def, const bmr::OutlineShape &outline) {
    b2FixtureDef each = def;
    for (int32 i = 0; i < outline.GetPieceCount(); ++i) {
        const bmr::ConvexShape plain = PlainPiece(outline, i);
        each.shape = &plain;
        body->CreateFixture(&each);
    }
}

} // namespace outlines

#endif
