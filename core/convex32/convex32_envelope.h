// SPDX-License-Identifier: MIT
#ifndef BMR_CONVEX32_CONVEX32_ENVELOPE_H
#define BMR_CONVEX32_CONVEX32_ENVELOPE_H

#include "boomerang/polygon.h"
#include "convex32/convex32.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// Big polygons in float as the structures of the paper see them: polygons in double, small ones around them.

/// Corners of a polygon around the given one, whose edges have `edges` (3 and more) evenly spread directions:
/// the level of the compass hierarchy that has so many, from the polygon alone. Counter-clockwise; where
/// edges meet in one vertex corners agree, to rounding. Certainly outside: moved out by what rounding may
/// take. Writes `edges` corners. O(edges log n).
void bmr_convex32_envelope(const bmr_convex32 *polygon, uint32_t edges, bmr_vec2 *corners);

/// Does `outer` hold the polygon, up to `tolerance` (>= 0) beyond the line of each edge? O(edges log n). No
/// polygon is held by a point or a segment.
bool bmr_convex32_held(const bmr_convex32 *polygon, const bmr_polygon *outer, double tolerance);

#ifdef __cplusplus
}
#endif
#endif
