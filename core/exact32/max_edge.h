// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_EXACT32_MAX_EDGE_H
#define BOOMERANG_EXACT32_MAX_EDGE_H

#include <float.h>

#include "lanes.h"

/// @file
/// The largest edge separation, lanes over edges.
///
/// A search that starts from last step's winner was measured: its separation first, then vertex after vertex
/// until each other edge has one below it, which gives the same winner. In lanes it costs more than it saves:
/// four edges come for the price of one, and the winner's own separation takes as long as two vertices do for
/// all. Instructions of bmr_exact32_collide, all told: pyramid +17 %, vertical stack +17 %, piled coins +8 %,
/// gears +28 %; used for five edges and more alone, coins +5 %, gears +12 %.

#if defined(__SSE2__)

/// Normals and first vertices of four edges, posed.
typedef struct four_edges {
    __m128 nx, ny, vx, vy;
} four_edges;

/// Edges past `count` (of the group's four, and more) come out as zeros.
static inline four_edges pose_edges(const bmr_vec32 *normals, const bmr_vec32 *vertices, int32_t count,
                                    __m128 frame) {
    quad n = load_four(normals), v = load_four(vertices);
    if (count < 4) {
        const __m128 mask = lanes(count, 0);
        n.x = _mm_and_ps(n.x, mask);
        n.y = _mm_and_ps(n.y, mask);
        v.x = _mm_and_ps(v.x, mask);
        v.y = _mm_and_ps(v.y, mask);
    }
    const __m128 s = SPLAT(frame, 2), c = SPLAT(frame, 3);
    four_edges e;
    e.nx = _mm_sub_ps(_mm_mul_ps(c, n.x), _mm_mul_ps(s, n.y));
    e.ny = _mm_add_ps(_mm_mul_ps(s, n.x), _mm_mul_ps(c, n.y));
    e.vx = _mm_add_ps(_mm_sub_ps(_mm_mul_ps(c, v.x), _mm_mul_ps(s, v.y)), SPLAT(frame, 0));
    e.vy = _mm_add_ps(_mm_add_ps(_mm_mul_ps(s, v.x), _mm_mul_ps(c, v.y)), SPLAT(frame, 1));
    return e;
}

/// The smaller of `least` and the separations of one point; a NaN gives `least` back.
static inline __m128 lower_by(__m128 least, const four_edges *e, __m128 x, __m128 y) {
    return _mm_min_ps(
        _mm_add_ps(_mm_mul_ps(e->nx, _mm_sub_ps(x, e->vx)), _mm_mul_ps(e->ny, _mm_sub_ps(y, e->vy))), least);
}

/// Separations of four edges from all points of `other`, two points at a time. Where the count is odd, one is
/// done twice, which changes no minimum.
static inline __m128 separate_four(const four_edges *e, const bmr_polygon32 *other) {
    __m128 least = _mm_set1_ps(FLT_MAX);
    if (other->count < 2) {
        const bmr_vec32 point = other->vertices[0];
        return lower_by(least, e, _mm_set1_ps(point.x), _mm_set1_ps(point.y));
    }
    const int32_t last = other->count - 2;
    for (int32_t j = 0;; j = j + 2 < last ? j + 2 : last) {
        const __m128 two = _mm_loadu_ps(&other->vertices[j].x);
        least = lower_by(least, e, SPLAT(two, 0), SPLAT(two, 1));
        least = lower_by(least, e, SPLAT(two, 2), SPLAT(two, 3));
        if (j >= last)
            return least;
    }
}

typedef struct max_edge {
    float separation;
    int32_t edge;
} max_edge;

static inline __m128 only_below(int32_t count, __m128 separations) {
    return count < 4 ? blend(lanes(count, 0), separations, _mm_set1_ps(-FLT_MAX)) : separations;
}

/// The largest separation and the first edge that has it, as a plain loop from -FLT_MAX on would find them.
/// `frame` as bmr_exact32_max_separation's, in a register.
static inline max_edge find_max_edge(const bmr_polygon32 *reference, const bmr_polygon32 *other,
                                     __m128 frame) {
    const int32_t count = reference->count;
    const four_edges low = pose_edges(reference->normals, reference->vertices, count, frame);
    const __m128 lows = only_below(count, separate_four(&low, other));
    __m128 highs = _mm_set1_ps(-FLT_MAX);
    if (count > 4) {
        const four_edges high = pose_edges(reference->normals + 4, reference->vertices + 4, count - 4, frame);
        highs = only_below(count - 4, separate_four(&high, other));
    }
    __m128 most = _mm_max_ps(lows, highs);
    most = _mm_max_ps(most, _mm_movehl_ps(most, most));
    most = _mm_max_ss(most, SPLAT(most, 1));
    const __m128 all = SPLAT(most, 0);
    const int hits = _mm_movemask_ps(_mm_cmpeq_ps(lows, all)) | _mm_movemask_ps(_mm_cmpeq_ps(highs, all))
                                                                    << 4;
    max_edge found;
    found.separation = _mm_cvtss_f32(most);
    found.edge = __builtin_ctz((unsigned)hits);
    if (!(found.separation > -FLT_MAX)) { // nothing beats what the loop began with
        found.separation = -FLT_MAX;
        found.edge = 0;
    }
    return found;
}

#endif

#endif
