// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_CONVEX32_PIECE_FACES_H
#define BOOMERANG_CONVEX32_PIECE_FACES_H

#include "convex32_pieces.h"
#include "edge_search.h"

/// @file
/// Which edges of a piece count: what collide.c and collide_edge.c ask.

/// Sines. Corners of a straight stretch turn by less than the first, whatever the rounding of their floats;
/// of two faces that lie on each other the directions differ by less than the second (which is Box2D's own
/// for edges with neighbours).
static const float rounding_of_turn = 1e-3f, nearly_straight = 0.1f;

/// So many skins deeper than along the nearest axis a tip may be below a face that is to push it out.
static const float deepest_tip = 10.0f;

static inline bool is_face(const bmr_convex32 *polygon, uint32_t edge) {
    return !polygon->seams || !polygon->seams->inner[edge];
}

/// Whose answer it is where a piece and another shape overlap.
typedef enum piece_answer {
    BY_FACES,       ///< the face that separates most of those that may answer
    BY_OTHER_PIECE, ///< there are no points
    AS_ANY_POLYGON  ///< the axis along which they overlap least, whatever is there
} piece_answer;

/// `nearest` is the separation along the axis along which the two overlap least, and `of_faces` what the
/// faces separate that may answer. A face that is deeper by a quarter of the skins is not the one that is
/// touched. Where the two overlap by no more than half of the skins another piece has the answer: by an inner
/// edge the other shape is beside this piece, and of a face that is not admitted it is another piece that is
/// nearest. Where they overlap more, that may be said of each piece, and one has to answer: by a face, but by
/// none that is deeper by more than the skins, for that would throw the two out of each other by a far side.
static inline piece_answer answer_of(float nearest, float of_faces, float radius_sum) {
    if (!(nearest > of_faces + 0.25f * radius_sum))
        return BY_FACES;
    if (nearest > -0.5f * radius_sum)
        return BY_OTHER_PIECE;
    return nearest > of_faces + radius_sum ? AS_ANY_POLYGON : BY_FACES;
}

static inline bool has_faces(const bmr_convex32 *polygon) {
    for (uint32_t i = 0; i < polygon->count; ++i)
        if (is_face(polygon, i))
            return true;
    return false;
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

/// The face of largest separation that the other polygon admits.
typedef struct candidate {
    edge_view view;
    bool found;
} candidate;

static inline bool is_admitted(const edge_search *search, const edge_view *view, float tolerance) {
    return bmr_convex32_admits(search->other, view->vertex, negative(view->normal), tolerance);
}

/// `best` is the edge of largest separation of all, most often a face. Otherwise O(n) edges are looked at.
static inline candidate best_face(const edge_search *search, const edge_view *best, float tolerance) {
    candidate c = {*best, is_face(search->reference, best->edge) && is_admitted(search, best, tolerance)};
    if (c.found)
        return c;
    uint32_t hint = best->vertex;
    for (uint32_t i = 0; i < search->reference->count; ++i) {
        if (!is_face(search->reference, i))
            continue;
        const edge_view view = bmr_convex32_view(search, i, hint);
        hint = view.vertex;
        if ((c.found && !(view.separation > c.view.separation)) || !is_admitted(search, &view, tolerance))
            continue;
        c.view = view;
        c.found = true;
    }
    return c;
}

#endif
