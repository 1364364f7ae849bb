// SPDX-License-Identifier: MIT
#include "geometry/predicates.h"
#include "outline/rings.h"

#define NONE BMR_OUTLINE_NONE

/// Once around, turning left or not at all, and somewhere left?
static bool is_convex(const bmr_outline_pieces *o, uint32_t piece) {
    const uint32_t begin = o->first[piece], count = o->first[piece + 1] - begin;
    uint32_t rises = 0; // edges that begin to go right after one that went left: one, once around
    bool turned = false;
    for (uint32_t i = 0; i < count; ++i) {
        bmr_vec2 p[3];
        for (uint32_t k = 0; k < 3; ++k)
            p[k] = o->points[o->edges[begin + (i + k) % count].point];
        const int turn = bmr_orientation(p[0], p[1], p[2]);
        const int ahead = bmr_sweep_compare(p[0], p[1]), on = bmr_sweep_compare(p[1], p[2]);
        // A corner that is no turn goes straight on, and not back.
        if (turn < 0 || ahead == 0 || (turn == 0 && ahead != on))
            return false;
        turned = turned || turn > 0;
        rises += ahead > 0 && on < 0;
    }
    return count >= 3 && turned && rises == 1;
}

static bool is_whole(const bmr_outline_pieces *o) {
    if (o->piece_count == 0 || o->first[0] != 0 || o->first[o->piece_count] != o->edge_count)
        return false;
    for (uint32_t p = 0; p < o->piece_count; ++p) {
        if (o->first[p] >= o->first[p + 1] || o->first[p + 1] > o->edge_count)
            return false;
        for (uint32_t e = o->first[p]; e < o->first[p + 1]; ++e) {
            const bmr_outline_edge *it = &o->edges[e];
            if (it->point >= o->point_count || it->piece != p ||
                (it->outline == NONE) == (it->twin == NONE) ||
                (it->outline != NONE && it->outline >= o->point_count) ||
                (it->twin != NONE && it->twin >= o->edge_count))
                return false;
        }
    }
    return true;
}

static uint32_t end_of(const bmr_outline_pieces *o, uint32_t edge) {
    const uint32_t piece = o->edges[edge].piece;
    return o->edges[edge + 1 < o->first[piece + 1] ? edge + 1 : o->first[piece]].point;
}

bmr_error bmr_outline_pieces_audit(const bmr_outline_pieces *pieces) {
    if (!pieces)
        return BMR_ERROR_NULL_ARGUMENT;
    if (!is_whole(pieces))
        return BMR_ERROR_INVALID_STRUCTURE;
    for (uint32_t e = 0; e < pieces->edge_count; ++e) {
        const uint32_t twin = pieces->edges[e].twin;
        if (twin != NONE &&
            (pieces->edges[twin].twin != e || pieces->edges[twin].piece == pieces->edges[e].piece ||
             pieces->edges[twin].point != end_of(pieces, e) ||
             pieces->edges[e].point != end_of(pieces, twin)))
            return BMR_ERROR_INVALID_STRUCTURE;
    }
    for (uint32_t p = 0; p < pieces->piece_count; ++p)
        if (!is_convex(pieces, p))
            return BMR_ERROR_NOT_CONVEX;
    return BMR_OK;
}
