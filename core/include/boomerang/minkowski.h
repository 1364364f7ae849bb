// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_MINKOWSKI_H
#define BOOMERANG_MINKOWSKI_H

#include "boomerang/polygon.h"

#ifdef __cplusplus
extern "C" {
#endif

/// The Minkowski difference A - R B = {a - R b}: the places of B's origin, in A's frame, at which B, turned
/// by R, touches or overlaps A (section 5 of the paper: "detecting collisions between a single moving point
/// and the static Minkowski sum"). `rotation` is (cos, sin) of B's angle in A's frame.
///
/// Edges of A and of -R B with exactly parallel vectors (the cross product of the computed vectors is 0)
/// become one edge. No other two edges are merged. Vertices that rounding leaves on or behind the hull of the
/// others are dropped (exact predicates), so the result is strictly convex. It has at most n + m vertices,
/// each off by the rounding of its own coordinates only. O(n + m) time, or O((n + m) log(n + m)) if rounding
/// upsets the order of nearly level edges. Scratch of 32 bytes a vertex is released before this returns.
/// Errors: NULL_ARGUMENT, NOT_FINITE, TOO_MANY_POINTS (n + m > BMR_MAX_VERTICES), OUT_OF_RANGE (coordinates),
/// NO_MEMORY.
bmr_error bmr_minkowski_difference(const bmr_polygon *a, const bmr_polygon *b, bmr_vec2 rotation,
                                   const bmr_allocator *allocator, bmr_polygon **difference);

#ifdef __cplusplus
}
#endif
#endif
