// SPDX-License-Identifier: MIT
#ifndef BMR_GEOMETRY_STAMP_H
#define BMR_GEOMETRY_STAMP_H

#include "boomerang/polygon.h"

/// The stamp that the vertices as they are now make. O(n).
uint32_t bmr_polygon_stamp_of(const bmr_polygon *polygon);

#endif
