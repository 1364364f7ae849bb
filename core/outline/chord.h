// SPDX-License-Identifier: MIT
#ifndef BMR_OUTLINE_CHORD_H
#define BMR_OUTLINE_CHORD_H

#include <float.h>
#include <math.h>

#include "boomerang/vector.h"

/// How much the distance below may be off, as a part of the way from the segment's end to the point: two
/// differences, two products, a sum, a length and a quotient of half an ulp each are 4 epsilon at most.
#define BMR_CHORD_ERROR (8.0 * DBL_EPSILON)

/// What the distances below are made of: the vectors from a to b and to p, scaled so that products neither
/// overflow nor lose more than a denormal. All finite coordinates, but for those whose difference is none.
typedef struct bmr_chord {
    bmr_vec2 along, to;
    double length, way;
    int exponent;
} bmr_chord;

static inline bmr_chord bmr_chord_make(bmr_vec2 p, bmr_vec2 a, bmr_vec2 b) {
    bmr_chord c = {bmr_sub(b, a), bmr_sub(p, a), 0.0, 0.0, 0};
    frexp(fmax(fmax(fabs(c.along.x), fabs(c.along.y)), fmax(fabs(c.to.x), fabs(c.to.y))), &c.exponent);
    c.along = bmr_vec2_make(ldexp(c.along.x, -c.exponent), ldexp(c.along.y, -c.exponent));
    c.to = bmr_vec2_make(ldexp(c.to.x, -c.exponent), ldexp(c.to.y, -c.exponent));
    c.length = hypot(c.along.x, c.along.y);
    c.way = hypot(c.to.x, c.to.y);
    return c;
}

/// A computed distance, rounded up; infinite where it is no number.
static inline double bmr_chord_up(const bmr_chord *c, double distance) {
    const double up = ldexp(distance + BMR_CHORD_ERROR * c->way + 4.0 * DBL_MIN, c->exponent) + 0x1p-1074;
    return up >= 0.0 ? up : (double)INFINITY;
}

/// At least the distance of p from the segment from a to b, and hardly more.
static inline double bmr_chord_distance(bmr_vec2 p, bmr_vec2 a, bmr_vec2 b) {
    const bmr_chord c = bmr_chord_make(p, a, b);
    const bmr_vec2 rest = bmr_sub(c.to, c.along);
    const double part = bmr_dot(c.to, c.along);
    if (!(part > 0.0))
        return bmr_chord_up(&c, c.way);
    return bmr_chord_up(&c, part < c.length * c.length ? fabs(bmr_cross(c.along, c.to)) / c.length
                                                       : hypot(rest.x, rest.y));
}

/// The same from the whole line through a and b; from a where the two are one.
static inline double bmr_chord_line_distance(bmr_vec2 p, bmr_vec2 a, bmr_vec2 b) {
    const bmr_chord c = bmr_chord_make(p, a, b);
    return bmr_chord_up(&c, c.length > 0.0 ? fabs(bmr_cross(c.along, c.to)) / c.length : c.way);
}

#endif
