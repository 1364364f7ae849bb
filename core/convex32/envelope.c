// SPDX-License-Identifier: MIT
#include "convex32/convex32_envelope.h"

#include <math.h>

#include "boomerang/vector.h"

/// What the arithmetic of a corner may be off by, relatively to the reach along its two edges: some roundings
/// of 2^-53, over the sine of an edge's turn, which is a tenth where there are 64.
#define CORNER_ROUNDING 0x1p-46

static double along(const bmr_convex32 *polygon, uint32_t vertex, bmr_vec2 direction) {
    const bmr_vec32 v = polygon->vertices[vertex];
    return (double)v.x * direction.x + (double)v.y * direction.y;
}

/// How far the polygon reaches in a direction, in double: a support that was chosen in float may be off by
/// more than the rounding of double, but the true one is not far from it.
static double reach_along(const bmr_convex32 *polygon, bmr_vec2 direction) {
    const bmr_vec32 narrow = {(float)direction.x, (float)direction.y};
    const uint32_t count = polygon->count, start = bmr_convex32_support(polygon, narrow);
    double best = along(polygon, start, direction);
    for (uint32_t step = 0; step < 2; ++step) { // both ways around
        for (uint32_t i = 1, vertex = start; i < count; ++i) {
            vertex = step == 0 ? (vertex + 1 == count ? 0 : vertex + 1) : (vertex == 0 ? count : vertex) - 1;
            const double next = along(polygon, vertex, direction);
            if (!(next > best))
                break;
            best = next;
        }
    }
    return best;
}

static bmr_vec2 direction_of(uint32_t edge, uint32_t edges) {
    const double angle = 6.283185307179586 * (double)edge / (double)edges;
    return bmr_vec2_make(cos(angle), sin(angle));
}

void bmr_convex32_envelope(const bmr_convex32 *polygon, uint32_t edges, bmr_vec2 *corners) {
    bmr_vec2 before = direction_of(edges - 1, edges);
    double reach_before = reach_along(polygon, before);
    for (uint32_t edge = 0; edge < edges; ++edge) {
        const bmr_vec2 normal = direction_of(edge, edges);
        const double reach = reach_along(polygon, normal);
        const double sine = before.x * normal.y - before.y * normal.x;
        const double out = CORNER_ROUNDING * (fabs(reach) + fabs(reach_before));
        // Where the two lines meet.
        corners[edge].x = ((reach_before + out) * normal.y - (reach + out) * before.y) / sine;
        corners[edge].y = ((reach + out) * before.x - (reach_before + out) * normal.x) / sine;
        before = normal;
        reach_before = reach;
    }
}

bool bmr_convex32_held(const bmr_convex32 *polygon, const bmr_polygon *outer, double tolerance) {
    if (outer->count < 3)
        return false;
    for (uint32_t edge = 0; edge < outer->count; ++edge) {
        const bmr_vec2 normal = bmr_polygon_normal(outer, edge), on = outer->vertices[edge];
        // (Not the other way around: what is not a number is not held.)
        if (!(reach_along(polygon, normal) - (normal.x * on.x + normal.y * on.y) <= tolerance))
            return false;
    }
    return true;
}
