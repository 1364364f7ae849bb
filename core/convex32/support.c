// SPDX-License-Identifier: MIT
#include "convex32/convex32.h"
#include "convex32/directions.h"

/// Steps from a hint after which the table is asked: about what it costs.
#define HINT_STEPS 8u

static uint32_t support_of_all(const bmr_convex32 *p, bmr_vec32 d) {
    uint32_t best = 0;
    float most = -INFINITY; // products that overflow may be NaN, and lose
    for (uint32_t i = 0; i < p->count; ++i) {
        const float dot = convex32_dot(p->vertices[i], d);
        if (dot > most) {
            most = dot;
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
        const float dot = convex32_dot(p->vertices[i], d);
        if (dot > *most) {
            *most = dot;
            *best = i;
        } else if (dot < *most - noise)
            return true;
    }
    return false;
}

/// From `start` to both sides for as long as a larger product may come; UINT32_MAX where a side has no end.
static uint32_t climb(const bmr_convex32 *p, bmr_vec32 d, float noise, uint32_t start, uint32_t limit) {
    uint32_t best = start;
    float most = convex32_dot(p->vertices[start], d);
    const bool ends = climb_one_side(p, d, noise, start, limit, true, &best, &most) &&
                      climb_one_side(p, d, noise, start, limit, false, &best, &most);
    return ends ? best : UINT32_MAX;
}

static uint32_t support_by_table(const bmr_convex32 *p, bmr_vec32 d, float size, float noise) {
    const uint32_t best = climb(p, d, noise, convex32_near_leaving(p, d, size), p->count);
    return best != UINT32_MAX ? best : support_of_all(p, d); // products so small that none is below another
}

uint32_t bmr_convex32_support(const bmr_convex32 *polygon, bmr_vec32 direction) {
    if (!polygon->buckets)
        return support_of_all(polygon, direction);
    const float size = convex32_size(direction), noise = convex32_noise(polygon, direction);
    if (!(size > 0.0f))
        return 0;
    if (!(size < FLT_MAX) || !(noise < FLT_MAX * 0x1p-24f))
        return support_of_all(polygon, direction);
    return support_by_table(polygon, direction, size, noise);
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
        const uint32_t best = climb(polygon, direction, noise, hint, HINT_STEPS);
        if (best != UINT32_MAX)
            return best;
    }
    return support_by_table(polygon, direction, size, noise);
}
