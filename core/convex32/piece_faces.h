// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_CONVEX32_PIECE_FACES_H
#define BOOMERANG_CONVEX32_PIECE_FACES_H

#include "convex32_pieces.h"
#include "edge_search.h"

/// @file
/// Which edges of a piece count: what the three files that make manifolds ask.

/// Sines. Corners of a straight stretch turn by less than the first, whatever the rounding of their floats;
/// of two faces that lie on each other the directions differ by less than the second (which is Box2D's own
/// for edges with neighbours).
static const float rounding_of_turn = 1e-3f, nearly_straight = 0.1f;

static inline bool is_face(const bmr_convex32 *polygon, uint32_t edge) {
    return !polygon->seams || !polygon->seams->inner[edge];
}

/// A quarter of the skins: a face that is deeper by this than another edge is not the one that is touched.
static inline float enough_deeper(float radius_sum) {
    return 0.25f * radius_sum;
}

/// `best` separates most of a polygon's edges, and `of_faces` is what the faces separate that may answer. Is
/// the answer another piece's? It is where the two overlap along `best` by no more than half of the skins: by
/// an inner edge the other shape is beside this piece, and of a face that is not admitted it is another piece
/// that is nearest. (Where they overlap more, that may be said of each piece, and one has to answer.)
static inline bool is_behind(const edge_view *best, float of_faces, float radius_sum) {
    return best->separation > of_faces + enough_deeper(radius_sum) && best->separation > -0.5f * radius_sum;
}

/// `best` is the edge whose normal is most opposed to `normal` (the polygon's frame). Where it is an inner
/// one: of the faces that meet at `vertex`, which is the least separated, the more opposed; where there is
/// none, `best`.
static inline uint32_t face_facing(const bmr_convex32 *polygon, uint32_t best, uint32_t vertex,
                                   bmr_vec32 normal) {
    if (is_face(polygon, best))
        return best;
    const uint32_t last = convex32_previous(polygon, vertex);
    const bool face_last = is_face(polygon, last), face_next = is_face(polygon, vertex);
    if (!face_last && !face_next)
        return best;
    if (face_last && face_next)
        return dot(polygon->normals[last], normal) < dot(polygon->normals[vertex], normal) ? last : vertex;
    return face_last ? last : vertex;
}

#endif
