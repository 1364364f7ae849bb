// SPDX-License-Identifier: MIT
#ifndef BMR_CONVEX32_DIRECTIONS_H
#define BMR_CONVEX32_DIRECTIONS_H

#include <float.h>
#include <math.h>

#include "boomerang/vector.h"
#include "convex32/convex32.h"

/// @file
/// Directions, their buckets, and how far floats can be trusted: what this folder's files share.
///
/// The pseudo-angle of a direction runs from 0 at (0, -1) counter-clockwise to 4: 1 + y / (|x| + |y|) on the
/// right, 3 - y / (|x| + |y|) on the left. Each of its halves is a multiple of 45 degrees, so with at least 8
/// buckets these are boundaries of buckets.

#define BMR_CONVEX32_LEAST_BITS 5u
/// More vertices than this between a bucket's ends are searched by halving.
#define BMR_CONVEX32_SHORT_WALK 4u

static inline bmr_vec2 convex32_wide(bmr_vec32 v) {
    return bmr_vec2_make((double)v.x, (double)v.y);
}

/// Sign of the turn from a to b, exact: products of floats are exact in double, and so is the sign of their
/// difference.
static inline double convex32_turn(bmr_vec32 a, bmr_vec32 b) {
    return (double)a.x * (double)b.y - (double)a.y * (double)b.x;
}

static inline uint32_t convex32_next(const bmr_convex32 *p, uint32_t i) {
    return i + 1 < p->count ? i + 1 : 0;
}

static inline uint32_t convex32_previous(const bmr_convex32 *p, uint32_t i) {
    return i > 0 ? i - 1 : p->count - 1;
}

/// |x| + |y|.
static inline float convex32_size(bmr_vec32 d) {
    return fabsf(d.x) + fabsf(d.y);
}

/// The bucket of a finite direction of this size > 0. At a boundary rounding may give a neighbour.
static inline uint32_t convex32_bucket(const bmr_convex32 *p, bmr_vec32 d, float size) {
    const float quarter = (float)(1u << (p->bucket_bits - 2));
    const float t = d.y / size;
    const uint32_t bucket = (uint32_t)((d.x < 0.0f ? 3.0f - t : 1.0f + t) * quarter);
    return bucket & ((1u << p->bucket_bits) - 1u);
}

/// The direction at which a bucket begins; |x| + |y| = 1, exact.
static inline bmr_vec32 convex32_bucket_begin(uint32_t bucket, uint32_t bits) {
    const float angle = (float)bucket / (float)(1u << (bits - 2));
    const float y = angle <= 2.0f ? angle - 1.0f : 3.0f - angle;
    const float x = 1.0f - fabsf(y);
    const bmr_vec32 begin = {angle <= 2.0f ? x : -x, y};
    return begin;
}

/// Is vertex i where the direction leaves the polygon, from normals[i - 1] on and before normals[i]? For one
/// vertex exactly.
static inline bool convex32_leaves_at(const bmr_convex32 *p, uint32_t i, bmr_vec32 direction) {
    return convex32_turn(p->normals[convex32_previous(p, i)], direction) >= 0.0 &&
           convex32_turn(direction, p->normals[i]) > 0.0;
}

/// Near the vertex where the direction of this size > 0 leaves the polygon, by the table and halving: some
/// steps off.
static inline uint32_t convex32_near_leaving(const bmr_convex32 *p, bmr_vec32 d, float size) {
    const uint32_t bucket = convex32_bucket(p, d, size);
    const uint32_t first = p->buckets[bucket];
    const uint32_t last = p->buckets[(bucket + 1) & ((1u << p->bucket_bits) - 1u)];
    uint32_t low = 0, high = last >= first ? last - first : last + p->count - first;
    if (high <= BMR_CONVEX32_SHORT_WALK)
        return first;
    while (low < high) {
        const uint32_t middle = (low + high) / 2;
        const uint32_t edge = first + middle < p->count ? first + middle : first + middle - p->count;
        if (convex32_turn(p->normals[edge], d) >= 0.0)
            low = middle + 1;
        else
            high = middle;
    }
    return first + low < p->count ? first + low : first + low - p->count;
}

/// If the float dot products of two vertices with d differ by more than this, so do the real ones, and no
/// other vertex that is really below the lower one comes out above the higher one. A product is wrong by
/// 2^-24 of itself, and so is a sum: 2 * 2^-24 of the largest |x dx| + |y dy| for each of two vertices, and
/// half as much again for the roundings in here and in the comparison. What is flushed to zero is below
/// FLT_MIN.
static inline float convex32_noise(const bmr_convex32 *p, bmr_vec32 d) {
    return 0x1.8p-22f * (p->extent.x * fabsf(d.x) + p->extent.y * fabsf(d.y)) + 8.0f * FLT_MIN;
}

#endif
