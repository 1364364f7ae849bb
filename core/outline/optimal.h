// SPDX-License-Identifier: MIT
#ifndef BMR_OUTLINE_OPTIMAL_H
#define BMR_OUTLINE_OPTIMAL_H

#include <stdbool.h>

#include "boomerang/allocator.h"
#include "boomerang/outline.h"

/// @file
/// The fewest convex pieces of a polygon without holes, cut from corner to corner: Keil and Snoeyink's
/// dynamic programme, with straight runs and touching corners handled exactly.

/// A polygon of at most BMR_OUTLINE_OPTIMAL_POINTS corners, counter-clockwise. It may touch itself.
#define BMR_LOOP_MOST BMR_OUTLINE_OPTIMAL_POINTS
typedef struct bmr_loop {
    uint32_t count;
    bmr_vec2 corners[BMR_LOOP_MOST];
    bool is_notch[BMR_LOOP_MOST]; ///< takes more than half a turn
    /// Can one corner see another one inside of the loop: the open segment between the two is in its open
    /// inside? To be set, both ways, for all pairs of which one is a notch.
    bool sees[BMR_LOOP_MOST][BMR_LOOP_MOST];
    /// May a notch have corners behind one that it sees, on the same ray and not beyond the loop?
    bool has_line[BMR_LOOP_MOST];
} bmr_loop;

typedef struct bmr_cut {
    uint16_t from, to; ///< corners
} bmr_cut;

/// Memory for the programme: grows as it needs, and is kept from one loop to the next.
typedef struct bmr_optimal bmr_optimal;
bmr_error bmr_optimal_create(const bmr_allocator *allocator, bmr_optimal **optimal);
void bmr_optimal_destroy(bmr_optimal *optimal);

/// Writes the fewest cuts that leave convex pieces only: at most BMR_LOOP_MOST - 3, no two of which cross.
/// O(n^2 r) orientations at worst for n corners and r notches. Errors: NO_MEMORY.
bmr_error bmr_optimal_cuts(bmr_optimal *optimal, const bmr_loop *loop, bmr_cut *cuts, uint32_t *count);

#endif
