// SPDX-License-Identifier: MIT
#ifndef BMR_GEOMETRY_LENGTH_H
#define BMR_GEOMETRY_LENGTH_H

#include <math.h>
#include <stdbool.h>

#include "boomerang/pose.h"

/// The length of a vector, good to a rounding, also where its square is no double. (hypot takes care of that
/// always, in some fifty instructions; and sqrt is the same on every machine.)
static inline double bmr_length(bmr_vec2 v) {
    const double square = v.x * v.x + v.y * v.y;
    return square > 0x1p-960 && square < 0x1p1020 ? sqrt(square) : hypot(v.x, v.y);
}

/// The angle by which q is turned against p, in [-pi, pi].
static inline double bmr_pose_turn(const bmr_pose *p, const bmr_pose *q) {
    return atan2(p->c * q->s - p->s * q->c, p->c * q->c + p->s * q->s);
}

/// Components of a vector below this are too small for products: these may lose bits to underflow, and the
/// product of two such numbers even its sign.
#define BMR_TINY 1e-140
#define BMR_TINY_SCALE 0x1p600

/// A vector of the same direction that is long enough for products. Scaling by a power of two is exact and
/// changes no sign.
static inline bmr_vec2 bmr_scale_up_if_tiny(bmr_vec2 d) {
    return fabs(d.x) < BMR_TINY && fabs(d.y) < BMR_TINY ? bmr_scale(BMR_TINY_SCALE, d) : d;
}

/// A rise below this comes of an edge so short that its products underflow. A climb that went by it would
/// stop there, or go back.
#define BMR_LEAST_RISE 1e-300

/// Does an edge lead farther in a direction that is not tiny? The difference of two doubles has a relative
/// error of half an ulp in each component, however short the edge, so that only edges at right angles to
/// `direction` up to 1e-15 can be misjudged.
static inline bool bmr_ascends(bmr_vec2 edge, bmr_vec2 direction) {
    const double rise = bmr_dot(edge, direction);
    return fabs(rise) >= BMR_LEAST_RISE ? rise > 0.0 : bmr_dot(bmr_scale_up_if_tiny(edge), direction) > 0.0;
}

#endif
