// SPDX-License-Identifier: MIT
#ifndef BMR_CERTIFICATE_CONE_H
#define BMR_CERTIFICATE_CONE_H

#include "boomerang/polygon.h"
#include "boomerang/pose.h"

/// The end, counter-clockwise (`side` 1) or clockwise (-1), of the directions that separate two polygons by
/// at least `least` (>= 0), starting from one that separates them by more. All are of unit length, in A's
/// frame, from A to B; the separation at the end is `least`, up to rounding. `support` are vertices near the
/// support vertices of `inside`. O(log n): a step halves what is left of either polygon. `*steps` counts
/// them.
bmr_vec2 bmr_cone_end(const bmr_polygon *a, const bmr_polygon *b, const bmr_pose *b_in_a, bmr_vec2 inside,
                      double least, int side, const uint32_t support[2], unsigned *steps);

#endif
