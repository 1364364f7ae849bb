// SPDX-License-Identifier: MIT
#ifndef BMR_GEOMETRY_BOUNDING_DISK_H
#define BMR_GEOMETRY_BOUNDING_DISK_H

#include <stddef.h>

#include "boomerang/vector.h"

typedef struct bmr_disk {
    bmr_vec2 center;
    double radius;
} bmr_disk;

/// A disk that holds all points (count >= 1), its radius rounded up; the smallest one up to rounding, so that
/// its centre lies in their hull and the diameter of the points is between sqrt(3) and 2 radii. O(n) in
/// practice.
bmr_disk bmr_bounding_disk(const bmr_vec2 *points, size_t count);

#endif
