// SPDX-License-Identifier: MIT
#ifndef BMR_KDS_CONE_H
#define BMR_KDS_CONE_H

#include "kds/structure.h"

/// The end, counter-clockwise (`side` 1) or clockwise (-1), of the directions that separate the two polygons
/// by at least `least` (> 0), starting from one of them. All are of unit length, in A's frame, from A to B.
/// The separation there is `least` up to rounding, or a little more where the search gave up early. `support`
/// are vertices near the support vertices of `inside`. A step for every pair of support vertices looked at:
/// O(log n), few where the cone is narrow.
bmr_vec2 bmr_cone_end(const bmr_kds *kds, const bmr_pose *b_in_a, bmr_vec2 inside, double least, int side,
                      const uint32_t support[2]);

#endif
