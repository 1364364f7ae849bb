// SPDX-License-Identifier: MIT
#ifndef BMR_CERTIFICATE_COARSE_H
#define BMR_CERTIFICATE_COARSE_H

#include "boomerang/polygon.h"
#include "boomerang/pose.h"

/// The coarse line: across the normal of the edge of least rank that separates two polygons. The rank is that
/// of a tree over each polygon's edges that is nowhere stored: the four directions of its own frame's axes
/// (edges of length 0) come first; then, in each quadrant between them, the middle one of its edges in the
/// sorted array, then the middle ones of both halves, and so on. Of equal depth A's come before B's.
typedef struct bmr_coarse {
    int owner;       ///< 0: A, 1: B
    uint32_t edge;   ///< the owner's, or BMR_COARSE_AXIS and 0 to 3 for an axis
    bmr_vec2 normal; ///< unit, owner's frame, outwards
} bmr_coarse;

/// More than the number of any edge.
#define BMR_COARSE_AXIS UINT32_C(0x10000)

/// `closest` is the direction of the closest points (unit, A's frame, from A to B), `support` are vertices
/// near the support vertices in it. False: no edge separates by more than `least`. At least one does where
/// the distance is more than sqrt(2) times that, for the normals of both are at most 90 degrees apart. O(log
/// n); `*steps` counts.
bool bmr_coarse_pick(const bmr_polygon *a, const bmr_polygon *b, const bmr_pose *b_in_a, bmr_vec2 closest,
                     double least, const uint32_t support[2], bmr_coarse *coarse, unsigned *steps);
/// The normal that `edge` of a bmr_coarse stands for; false if the polygon has no such edge.
bool bmr_coarse_normal(const bmr_polygon *owner, uint32_t edge, bmr_vec2 *normal);

/// The end, counter-clockwise (`side` 1) or clockwise (-1), of the directions that separate two polygons by
/// at least `least` (>= 0), starting from one that separates them by more. All are of unit length, in A's
/// frame, from A to B; the separation at the end is `least`, up to rounding. `support` are vertices near the
/// support vertices of `inside`. O(log n): a step halves what is left of either polygon. `*steps` counts
/// them.
bmr_vec2 bmr_cone_end(const bmr_polygon *a, const bmr_polygon *b, const bmr_pose *b_in_a, bmr_vec2 inside,
                      double least, int side, const uint32_t support[2], unsigned *steps);

#endif
