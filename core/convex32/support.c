// SPDX-License-Identifier: MIT
#include "edge_search.h"

/// Steps from a hint after which the table is asked: about what it costs.
#define SUPPORT_HINT_STEPS 8u

static uint32_t support_of_all(const bmr_convex32 *p, bmr_vec32 d) {
    uint32_t best = 0;
    float most = -INFINITY; // products that overflow may be NaN, and lose
    for (uint32_t i = 0; i < p->count; ++i) {
        const float product = dot(p->vertices[i], d);
        if (product > most) {
            most = product;
            best = i;
        }
    }
    return best;
}

/// The real products rise along a side to the top and then fall, so once one is surely below the best, it and
/// those behind it may be left. False when that has not been seen after `limit` steps from `start`.
static inline bool climb_one_side(const bmr_convex32 *p, bmr_vec32 d, float noise, uint32_t start,
                                  uint32_t limit, bool onward, uint32_t *best, float *most) {
    for (uint32_t i = start; limit > 0; limit--) {
        i = onward ? convex32_next(p, i) : convex32_previous(p, i);
        const float product = dot(p->vertices[i], d);
        if (product > *most) {
            *most = product;
            *best = i;
        } else if (product < *most - noise)
            return true;
    }
    return false;
}

/// From `start` to both sides for as long as a larger product may come; UINT32_MAX where a side has no end.
static uint32_t climb(const bmr_convex32 *p, bmr_vec32 d, float noise, uint32_t start, uint32_t limit) {
    uint32_t best = start;
    float most = dot(p->vertices[start], d);
    const bool ends = climb_one_side(p, d, noise, start, limit, true, &best, &most) &&
                      climb_one_side(p, d, noise, start, limit, false, &best, &most);
    return ends ? best : UINT32_MAX;
}

uint32_t bmr_convex32_support_from(const bmr_convex32 *polygon, bmr_vec32 direction, uint32_t hint) {
    if (!polygon->buckets)
        return support_of_all(polygon, direction);
    const float size = convex32_size(direction), noise = convex32_noise(polygon, direction);
    if (!(size > 0.0f))
        return 0;
    if (!(size < FLT_MAX) || !(noise < FLT_MAX * 0x1p-24f))
        return support_of_all(polygon, direction);
    if (hint < polygon->count) {
        const uint32_t best = climb(polygon, direction, noise, hint, SUPPORT_HINT_STEPS);
        if (best != UINT32_MAX)
            return best;
    }
    const uint32_t best =
        climb(polygon, direction, noise, convex32_near_leaving(polygon, direction, size), polygon->count);
    // Products so small that none is below another have no end.
    return best != UINT32_MAX ? best : support_of_all(polygon, direction);
}

uint32_t bmr_convex32_support(const bmr_convex32 *polygon, bmr_vec32 direction) {
    return bmr_convex32_support_from(polygon, direction, polygon->count);
}

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
