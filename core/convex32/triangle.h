// SPDX-License-Identifier: MIT
#ifndef BMR_CONVEX32_TRIANGLE_H
#define BMR_CONVEX32_TRIANGLE_H

#include "exact32/exact32.h"

/// Twice the area of a triangle, positive if it is counter-clockwise: within 4e-9 of its value however thin
/// it is, and 0 only where it is 0. Coordinates are finite; rounding is to nearest (in other modes a needle's
/// may be lost). 10 ns, some 45 for needles.
double convex32_twice_area(bmr_vec32 a, bmr_vec32 b, bmr_vec32 c);

#endif
