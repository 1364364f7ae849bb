// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_EXACT32_LANES_H
#define BOOMERANG_EXACT32_LANES_H

#include "boomerang/exact32.h"

/// @file
/// What the files of core/exact32 share: formulas whose parentheses fix their rounding, and the same in SSE2.
/// A difference may be a sum with the sign bit of one product's factor turned, which rounds the same.

static inline bmr_vec32 turn(const bmr_transform32 *t, bmr_vec32 v) {
    const bmr_vec32 r = {t->c * v.x - t->s * v.y, t->s * v.x + t->c * v.y};
    return r;
}

static inline bmr_vec32 move(const bmr_transform32 *t, bmr_vec32 v) {
    const bmr_vec32 r = {(t->c * v.x - t->s * v.y) + t->p.x, (t->s * v.x + t->c * v.y) + t->p.y};
    return r;
}

#if defined(__SSE2__)
#    include <emmintrin.h>

/// All four lanes hold lane `lane` of v.
#    define SPLAT(v, lane) _mm_shuffle_ps(v, v, _MM_SHUFFLE(lane, lane, lane, lane))

/// All bits set in the lanes below `count` of two groups of four.
static const int32_t lane_masks[9][8] = {
    {0, 0, 0, 0, 0, 0, 0, 0},       {-1, 0, 0, 0, 0, 0, 0, 0},       {-1, -1, 0, 0, 0, 0, 0, 0},
    {-1, -1, -1, 0, 0, 0, 0, 0},    {-1, -1, -1, -1, 0, 0, 0, 0},    {-1, -1, -1, -1, -1, 0, 0, 0},
    {-1, -1, -1, -1, -1, -1, 0, 0}, {-1, -1, -1, -1, -1, -1, -1, 0}, {-1, -1, -1, -1, -1, -1, -1, -1},
};

static inline __m128 lanes(int32_t count, int32_t group) {
    return _mm_castsi128_ps(_mm_loadu_si128((const __m128i *)(const void *)&lane_masks[count][4 * group]));
}

static inline __m128 blend(__m128 mask, __m128 inside, __m128 outside) {
    return _mm_or_ps(_mm_and_ps(mask, inside), _mm_andnot_ps(mask, outside));
}

/// The sign bits of the even lanes.
static inline __m128 even_signs(void) {
    return _mm_castsi128_ps(_mm_set_epi32(0, (int)0x80000000u, 0, (int)0x80000000u));
}

/// Two vectors side by side, each turned a quarter to the left: (x, y) becomes (-y, x).
static inline __m128 quarter_left(__m128 vectors) {
    return _mm_xor_ps(_mm_shuffle_ps(vectors, vectors, _MM_SHUFFLE(2, 3, 0, 1)), even_signs());
}

/// bmr_exact32_relative on transforms in a register: px, py, s, c.
static inline __m128 relative(__m128 other, __m128 reference) {
    const __m128 second_third = _mm_castsi128_ps(_mm_set_epi32(0, (int)0x80000000u, (int)0x80000000u, 0));
    const __m128 d = _mm_shuffle_ps(_mm_sub_ps(reference, other), reference, _MM_SHUFFLE(3, 2, 1, 0));
    // dx, dy, rs, rc beside dy, -dx, -rc, rs
    const __m128 e = _mm_xor_ps(_mm_shuffle_ps(d, d, _MM_SHUFFLE(2, 3, 0, 1)), second_third);
    return _mm_add_ps(_mm_mul_ps(SPLAT(other, 3), d), _mm_mul_ps(SPLAT(other, 2), e));
}

/// Four points, x and y apart.
typedef struct quad {
    __m128 x, y;
} quad;

static inline quad load_four(const bmr_vec32 *points) {
    const __m128 a = _mm_loadu_ps(&points[0].x), b = _mm_loadu_ps(&points[2].x);
    quad q;
    q.x = _mm_shuffle_ps(a, b, _MM_SHUFFLE(2, 0, 2, 0));
    q.y = _mm_shuffle_ps(a, b, _MM_SHUFFLE(3, 1, 3, 1));
    return q;
}

/// Lanes outside `mask` are zero: what lies past a polygon's count is never computed with.
static inline quad load_quad(const bmr_vec32 *points, __m128 mask) {
    quad q = load_four(points);
    q.x = _mm_and_ps(q.x, mask);
    q.y = _mm_and_ps(q.y, mask);
    return q;
}
#endif

#endif
