// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_POSE_H
#define BOOMERANG_POSE_H

#include <math.h>

#include "boomerang/vector.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A rigid motion x -> (c x - s y, s x + c y) + position, (c, s) = (cos, sin). Core computes with the matrix
/// as it stands: (c, s) must be of unit length only as far as the caller needs exactness.
typedef struct bmr_pose {
    bmr_vec2 position;
    double c, s;
} bmr_pose;

static inline bmr_pose bmr_pose_identity(void) {
    bmr_pose q = {{0.0, 0.0}, 1.0, 0.0};
    return q;
}
/// The pose at a place, turned counter-clockwise by an angle in radians. A NaN or an infinity in the
/// arguments gives a pose with a NaN or an infinity, which every call refuses.
static inline bmr_pose bmr_pose_from_angle(bmr_vec2 position, double angle) {
    bmr_pose q;
    q.position = position;
    q.c = cos(angle);
    q.s = sin(angle);
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
