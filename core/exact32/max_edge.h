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

/// Normals and first vertices of four edges, posed.
typedef struct four_edges {
    float4 nx, ny, vx, vy;
} four_edges;

/// Edges past `count` (of the group's four, and more) come out as zeros.
static inline four_edges pose_edges(const bmr_vec32 *normals, const bmr_vec32 *vertices, int32_t count,
                                    float4 frame) {
    quad n = load_four(normals), v = load_four(vertices);
    if (count < 4) {
        const mask4 mask = first_lanes4(count, 0);
        n.x = keep4(mask, n.x);
        n.y = keep4(mask, n.y);
        v.x = keep4(mask, v.x);
        v.y = keep4(mask, v.y);
    }
    const float4 s = splat4(frame, 2), c = splat4(frame, 3);
    four_edges e;
    e.nx = sub4(mul4(c, n.x), mul4(s, n.y));
    e.ny = add4(mul4(s, n.x), mul4(c, n.y));
    e.vx = add4(sub4(mul4(c, v.x), mul4(s, v.y)), splat4(frame, 0));
    e.vy = add4(add4(mul4(s, v.x), mul4(c, v.y)), splat4(frame, 1));
    return e;
}

/// The smaller of `least` and the separations of one point; a NaN gives `least` back.
static inline float4 lower_by(float4 least, const four_edges *e, float4 x, float4 y) {
    return min4(add4(mul4(e->nx, sub4(x, e->vx)), mul4(e->ny, sub4(y, e->vy))), least);
}

/// Separations of four edges from all points of `other`, two points at a time. Where the count is odd, one is
/// done twice, which changes no minimum.
static inline float4 separate_four(const four_edges *e, const bmr_polygon32 *other) {
    float4 least = all4(FLT_MAX);
    if (other->count < 2) {
        const bmr_vec32 point = other->vertices[0];
        return lower_by(least, e, all4(point.x), all4(point.y));
    }
    const int32_t last = other->count - 2;
    for (int32_t j = 0;; j = j + 2 < last ? j + 2 : last) {
        const float4 two = load4(&other->vertices[j].x);
        least = lower_by(least, e, splat4(two, 0), splat4(two, 1));
        least = lower_by(least, e, splat4(two, 2), splat4(two, 3));
        if (j >= last)
            return least;
    }
}

typedef struct max_edge {
    float separation;
    int32_t edge;
} max_edge;

static inline float4 only_below(int32_t count, float4 separations) {
    return count < 4 ? select4(first_lanes4(count, 0), separations, all4(-FLT_MAX)) : separations;
}

/// Of all edges; -FLT_MAX past the count.
typedef struct separations {
    float4 low, high;
} separations;

/// `frame` as bmr_exact32_max_separation's, in a register.
static inline separations separate_all(const bmr_polygon32 *reference, const bmr_polygon32 *other,
                                       float4 frame) {
    const int32_t count = reference->count;
    const four_edges low = pose_edges(reference->normals, reference->vertices, count, frame);
    separations s = {only_below(count, separate_four(&low, other)), all4(-FLT_MAX)};
    if (count > 4) {
        const four_edges high = pose_edges(reference->normals + 4, reference->vertices + 4, count - 4, frame);
        s.high = only_below(count - 4, separate_four(&high, other));
    }
    return s;
}

/// The largest separation and the first edge that has it, as a plain loop from -FLT_MAX on would find them.
static inline max_edge largest_of(const separations *s) {
    max_edge found;
    found.separation = most_of4(max4(s->low, s->high));
    const float4 all = all4(found.separation);
    const unsigned hits = bits4(equal4(s->low, all)) | bits4(equal4(s->high, all)) << 4;
    found.edge = lowest_bit(hits);
    if (!(found.separation > -FLT_MAX)) { // nothing beats what the loop began with
        found.separation = -FLT_MAX;
        found.edge = 0;
    }
    return found;
}

static inline max_edge find_max_edge(const bmr_polygon32 *reference, const bmr_polygon32 *other,
                                     float4 frame) {
    const separations s = separate_all(reference, other, frame);
    return largest_of(&s);
}

#endif
