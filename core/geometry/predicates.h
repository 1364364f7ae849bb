// SPDX-License-Identifier: MIT
#ifndef BMR_GEOMETRY_PREDICATES_H
#define BMR_GEOMETRY_PREDICATES_H

#include "boomerang/vector.h"

#ifdef __cplusplus
extern "C" {
#endif

/// The side of c as seen from a towards b: +1 left (a, b, c counter-clockwise), -1 right, 0 exactly on the
/// line. Exact for all finite doubles, denormals and 1e308 alike. Laws, all of them exact too:
///   orientation(a, b, c) = orientation(b, c, a) = -orientation(b, a, c); 0 if two of the points are equal.
/// A few ns where floating point is sure of the sign, about 100 ns where it is not.
int bmr_orientation(bmr_vec2 a, bmr_vec2 b, bmr_vec2 c);

#ifdef __cplusplus
}
#endif
#endif
