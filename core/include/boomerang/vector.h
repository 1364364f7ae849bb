// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_VECTOR_H
#define BOOMERANG_VECTOR_H

#ifdef __cplusplus
extern "C" {
#endif

/// A point or a direction of the plane.
typedef struct bmr_vec2 {
    double x, y;
} bmr_vec2;

static inline bmr_vec2 bmr_vec2_make(double x, double y) {
    bmr_vec2 v = {x, y};
    return v;
}
static inline bmr_vec2 bmr_add(bmr_vec2 a, bmr_vec2 b) {
    return bmr_vec2_make(a.x + b.x, a.y + b.y);
}
static inline bmr_vec2 bmr_sub(bmr_vec2 a, bmr_vec2 b) {
    return bmr_vec2_make(a.x - b.x, a.y - b.y);
}
static inline bmr_vec2 bmr_neg(bmr_vec2 a) {
    return bmr_vec2_make(-a.x, -a.y);
}
static inline bmr_vec2 bmr_scale(double k, bmr_vec2 a) {
    return bmr_vec2_make(k * a.x, k * a.y);
}
static inline double bmr_dot(bmr_vec2 a, bmr_vec2 b) {
    return a.x * b.x + a.y * b.y;
}
/// Positive when b lies counter-clockwise of a.
static inline double bmr_cross(bmr_vec2 a, bmr_vec2 b) {
    return a.x * b.y - a.y * b.x;
}
/// a turned by +90 degrees.
static inline bmr_vec2 bmr_left(bmr_vec2 a) {
    return bmr_vec2_make(-a.y, a.x);
}

#ifdef __cplusplus
}
#endif
#endif
