// SPDX-License-Identifier: MIT
#include "edge_search.h"

/// Steps from the hint before the table is asked; from where the table says, before bmr_convex32_support is.
enum { HINT_STEPS = 3, TABLE_STEPS = 8 };

/// Uphill along u, to one side, by at most so many steps: true where that was enough.
static bool walk(const bmr_convex32 *polygon, bmr_vec32 u, uint32_t *at, uint32_t most) {
    const bmr_vec32 *const v = polygon->vertices;
    uint32_t steps = 0;
    for (uint32_t next = convex32_next(polygon, *at); dot(u, minus(v[next], v[*at])) > 0.0f;
         next = convex32_next(polygon, next)) {
        if (++steps > most)
            return false;
        *at = next;
    }
    if (steps > 0)
        return true;
    for (uint32_t last = convex32_previous(polygon, *at); dot(u, minus(v[last], v[*at])) > 0.0f;
         last = convex32_previous(polygon, last)) {
        if (++steps > most)
            return false;
        *at = last;
    }
    return true;
}

uint32_t bmr_convex32_find_farthest(const bmr_convex32 *polygon, bmr_vec32 u, uint32_t start) {
    uint32_t at = start;
    const float size = convex32_size(u);
    if (polygon->buckets && size > 0.0f && size <= FLT_MAX) {
        at = polygon->buckets[convex32_bucket(polygon, u, size)];
        if (walk(polygon, u, &at, TABLE_STEPS))
            return at;
        at = bmr_convex32_support(polygon, u);
    }
    walk(polygon, u, &at, polygon->count); // from there on the last edges, whose products are all noise
    return at;
}

uint32_t bmr_convex32_walk_farthest(const bmr_convex32 *polygon, bmr_vec32 u, uint32_t start) {
    uint32_t at = start;
    return walk(polygon, u, &at, HINT_STEPS) ? at : bmr_convex32_find_farthest(polygon, u, at);
}
