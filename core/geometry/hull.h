// SPDX-License-Identifier: MIT
#ifndef BMR_GEOMETRY_HULL_H
#define BMR_GEOMETRY_HULL_H

#include <stddef.h>

#include "boomerang/vector.h"

/// Sorts `points` (finite, count >= 1) in place and writes their strictly convex hull, counter-clockwise from
/// the lowest (of these the leftmost) point, to `hull`, which has room for count + 1 points. Returns the
/// number of hull vertices. Exact: see bmr_polygon_create. O(n log n), no memory.
size_t bmr_convex_hull(bmr_vec2 *points, size_t count, bmr_vec2 *hull);

#endif
