// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_EXACT32_LANES_H
#define BOOMERANG_EXACT32_LANES_H

#include "exact32/exact32.h"

#include "float4.h"

/// @file
/// What the files of core/exact32 share: formulas whose parentheses fix their rounding, and the same in
/// lanes. A difference may be a sum with the sign bit of one product's factor turned, which rounds the same.

static inline bmr_vec32 turn(const bmr_transform32 *t, bmr_vec32 v) {
    const bmr_vec32 r = {t->c * v.x - t->s * v.y, t->s * v.x + t->c * v.y};
    return r;
}

static inline bmr_vec32 move(const bmr_transform32 *t, bmr_vec32 v) {
    const bmr_vec32 r = {(t->c * v.x - t->s * v.y) + t->p.x, (t->s * v.x + t->c * v.y) + t->p.y};
    return r;
}

/// Two vectors side by side, each turned a quarter to the left: (x, y) becomes (-y, x).
static inline float4 quarter_left(float4 vectors) {
    return flip_even4(swap4(vectors));
}

/// bmr_exact32_relative on transforms in a register: px, py, s, c. `d`: dx, dy, and the reference's s, c.
static inline float4 relative_of(float4 other, float4 d) {
    const float4 e = flip_inner4(swap4(d)); // d beside dy, -dx, -rc, rs
    return add4(mul4(splat4(other, 3), d), mul4(splat4(other, 2), e));
}
static inline float4 relative(float4 other, float4 reference) {
    return relative_of(other, low_high4(sub4(reference, other), reference));
}

/// Four points, x and y apart.
typedef struct quad {
    float4 x, y;
} quad;

static inline quad load_four(const bmr_vec32 *points) {
    const float4 a = load4(&points[0].x), b = load4(&points[2].x);
    const quad q = {evens4(a, b), odds4(a, b)};
    return q;
}

/// Lanes outside `mask` are zero: what lies past a polygon's count is never computed with.
static inline quad load_quad(const bmr_vec32 *points, mask4 mask) {
    quad q = load_four(points);
    q.x = keep4(mask, q.x);
    q.y = keep4(mask, q.y);
    return q;
}

#endif
