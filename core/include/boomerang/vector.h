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

/// A rigid motion x -> (c x - s y, s x + c y) + position. (c, s) = (cos, sin) need be of unit length only as
/// far as the caller needs exactness: core computes with the matrix as it stands.
typedef struct bmr_pose {
    bmr_vec2 position;
    double c, s;
} bmr_pose;

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

static inline bmr_pose bmr_pose_identity(void) {
    bmr_pose q = {{0.0, 0.0}, 1.0, 0.0};
    return q;
}
/// Turns a direction from the pose's frame outwards.
static inline bmr_vec2 bmr_rotate(const bmr_pose *q, bmr_vec2 v) {
    return bmr_vec2_make(q->c * v.x - q->s * v.y, q->s * v.x + q->c * v.y);
}
/// Turns a direction into the pose's frame (the transposed matrix).
static inline bmr_vec2 bmr_unrotate(const bmr_pose *q, bmr_vec2 v) {
    return bmr_vec2_make(q->c * v.x + q->s * v.y, -q->s * v.x + q->c * v.y);
}
/// Takes a point from the pose's frame outwards.
static inline bmr_vec2 bmr_transform(const bmr_pose *q, bmr_vec2 v) {
    return bmr_add(bmr_rotate(q, v), q->position);
}
/// The pose of b's frame as seen from a's frame: a^-1 b.
static inline bmr_pose bmr_pose_relative(const bmr_pose *a, const bmr_pose *b) {
    bmr_pose q;
    q.position = bmr_unrotate(a, bmr_sub(b->position, a->position));
    q.c = a->c * b->c + a->s * b->s;
    q.s = a->c * b->s - a->s * b->c;
    return q;
}
/// The pose of a's frame as seen from b's, given that of b's frame as seen from a's.
static inline bmr_pose bmr_pose_inverse(const bmr_pose *q) {
    bmr_pose r;
    r.position = bmr_neg(bmr_unrotate(q, q->position));
    r.c = q->c;
    r.s = -q->s;
    return r;
}

#ifdef __cplusplus
}
#endif
#endif
