// SPDX-License-Identifier: MIT
#ifndef BMR_GEOMETRY_HULL_H
#define BMR_GEOMETRY_HULL_H

#include <stdbool.h>
#include <stddef.h>

#include "boomerang/vector.h"

/// Sorts `points` (finite, count >= 1) in place and writes their strictly convex hull, counter-clockwise from
/// the lowest (of these the leftmost) point, to `hull`, which has room for count + 1 points. Returns the
/// number of hull vertices. Exact: see bmr_polygon_create. O(n log n), no memory.
size_t bmr_convex_hull(bmr_vec2 *points, size_t count, bmr_vec2 *hull);

/// From bottom to top, and from left to right on one height: the sweep of the monotone chain.
bool bmr_hull_sweeps_before(bmr_vec2 a, bmr_vec2 b);

/// Appends a point to a chain whose first `fixed` points may not be popped; keeps strict left turns only.
/// Returns the chain's new size.
size_t bmr_hull_append(bmr_vec2 *hull, size_t size, size_t fixed, bmr_vec2 point);

#endif
