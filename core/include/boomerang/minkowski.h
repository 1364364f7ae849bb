// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_MINKOWSKI_H
#define BOOMERANG_MINKOWSKI_H

#include "boomerang/polygon.h"

#ifdef __cplusplus
extern "C" {
#endif

/// The Minkowski difference A - R B = {a - R b}: the places of B's origin, in A's frame, where B, turned by
/// R, touches or overlaps A (section 5 of the paper: "detecting collisions between a single moving point and
/// the static Minkowski sum"). `rotation` is (cos, sin) of B's angle in A's frame. Edges of A and of -R B
/// with exactly parallel vectors (the cross product of the computed vectors is 0) become one edge; no other
/// two are merged, but for vertices that rounding leaves on or behind the hull of the others (exact
/// predicates), so that the result is strictly convex. At most n + m vertices; each is off by the rounding of
/// its own coordinates only. O(n + m) time (O((n + m) log(n + m)) where rounding upsets the order of nearly
/// level edges); scratch of 32 bytes a vertex, given back before this returns. Errors: NULL_ARGUMENT,
/// NOT_FINITE, TOO_MANY_POINTS (n + m > BMR_MAX_VERTICES), OUT_OF_RANGE (coordinates), NO_MEMORY.
bmr_error bmr_minkowski_difference(const bmr_polygon *a, const bmr_polygon *b, bmr_vec2 rotation,
                                   const bmr_allocator *allocator, bmr_polygon **difference);

#ifdef __cplusplus
}
#endif
#endif
