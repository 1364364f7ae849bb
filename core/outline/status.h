// SPDX-License-Identifier: MIT
#ifndef BMR_OUTLINE_STATUS_H
#define BMR_OUTLINE_STATUS_H

#include <stdbool.h>

#include "boomerang/outline.h"

/// A strand is an edge of the outline from left to right, or the part of one between two touches. What the
/// sweep's line meets are strands, from below to above; the gap between two of them is solid or void.

/// Of a solid gap, for the triangulation: nodes of the chain between what is cut into triangles and what is
/// not.
typedef struct bmr_gap {
    uint32_t low, high, newest;
} bmr_gap;

typedef struct bmr_strand {
    uint32_t left, right; ///< points; of points that coincide, the first
    /// Which passage of the outline through its left and its right point it is: a point's own index, or that
    /// of the edge plus the number of points where the edge goes on beyond the point.
    uint32_t left_passage, right_passage;
    uint32_t edge;         ///< of the outline
    uint32_t lower, upper; ///< the tree: its two subtrees
    uint32_t priority;     ///< in the tree none below has a higher one
    bool solid_above;
    bmr_gap gap; ///< the one above, where it is solid
} bmr_strand;

/// The strands that the sweep's line meets: a treap, ordered from below to above. O(log n) expected a call,
/// whatever the outline: priorities are a hash of the strand's number.
typedef struct bmr_status {
    const bmr_vec2 *points;
    bmr_strand *strands;
    uint32_t root;
} bmr_status;

/// Takes the tree apart at a point: strands below, through and above it. BMR_OUTLINE_NONE: an empty tree.
typedef struct bmr_status_parts {
    uint32_t below, through, above;
} bmr_status_parts;
bmr_status_parts bmr_status_split(bmr_status *status, bmr_vec2 point);

/// The topmost and the lowest strand of a tree; BMR_OUTLINE_NONE of an empty one.
uint32_t bmr_status_top(const bmr_status *status, uint32_t tree);
uint32_t bmr_status_bottom(const bmr_status *status, uint32_t tree);

/// Writes the strands of a tree to `list`, from below; returns how many.
uint32_t bmr_status_list(const bmr_status *status, uint32_t tree, uint32_t *list);

/// Makes the whole of what is below, of new strands from below to above, and of what is above.
void bmr_status_join(bmr_status *status, uint32_t below, const uint32_t *strands, uint32_t count,
                     uint32_t above);

#endif
