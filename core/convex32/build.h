// SPDX-License-Identifier: MIT
#ifndef BMR_CONVEX32_BUILD_H
#define BMR_CONVEX32_BUILD_H

#include <math.h>

#include "boomerang/vector.h"
#include "convex32/convex32.h"
#include "convex32/directions.h"
#include "geometry/memory.h"

/// @file
/// What polygons of any size (build.c), pieces of outlines (pieces.c) and choices of their vertices
/// (simplify.c) are made with.

/// The outward unit normal of the edge, rounded once. Rounding keeps the order of directions, and does not
/// depend on where the edge lies.
static inline bmr_vec32 convex32_edge_normal(bmr_vec32 from, bmr_vec32 to) {
    const double x = (double)to.x - (double)from.x, y = (double)to.y - (double)from.y;
    const double length = sqrt(x * x + y * y);
    const bmr_vec32 normal = {(float)(y / length), (float)(-x / length)};
    return normal;
}

/// Do the normals of the edges from a to b and from b to c turn by more than rounding? Opposite normals turn
/// too, by half a turn to rounding: b is the tip of a needle.
static inline bool convex32_turns(bmr_vec32 a, bmr_vec32 b, bmr_vec32 c) {
    const bmr_vec32 before = convex32_edge_normal(a, b), after = convex32_edge_normal(b, c);
    return convex32_turn(before, after) > 0.0 ||
           (double)before.x * (double)after.x + (double)before.y * (double)after.y < 0.0;
}

/// Twice the area of a triangle, positive if it is counter-clockwise: within 4e-9 of its value however thin
/// it is, and 0 only where it is 0. Coordinates are finite; rounding is to nearest (in other modes a needle's
/// may be lost). 10 ns, some 45 for needles.
double convex32_twice_area(bmr_vec32 a, bmr_vec32 b, bmr_vec32 c);

/// Drops the vertices of a strictly convex polygon that turn by no more than rounding, in place, and with
/// them their numbers, unless these are NULL. How many are left: they may be fewer than three.
size_t convex32_drop_straight(bmr_vec32 *v, uint32_t *numbers, size_t count);

/// BMR_OK, BMR_ERROR_NOT_FINITE or BMR_ERROR_OUT_OF_RANGE.
bmr_error convex32_check_points(const bmr_vec32 *points, size_t count);

/// The larger side of the bounding box.
double convex32_box_side(const bmr_vec32 *v, size_t count);

/// A block of these vertices, which are 3 or more, finite and within range, and of `more` bytes behind what
/// it needs itself (bmr_convex32_bytes); `*block` is written last.
bmr_error convex32_make(const bmr_vec32 *vertices, size_t count, size_t more, const bmr_allocator *allocator,
                        bmr_convex32_block **block);

#endif
