// SPDX-License-Identifier: MIT
#ifndef BMR_OUTLINE_SWEEP_H
#define BMR_OUTLINE_SWEEP_H

#include "outline/rings.h"

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

/// What the sweep meets at one place: all strands that end there, and all that start there, both from below.
/// The gap above a strand is solid where its `solid_above` says so.
typedef struct bmr_sweep_event {
    uint32_t point; ///< of those in this place, the first
    uint32_t below; ///< the strand next below the place that goes past it; NONE where there is none
    const uint32_t *ends, *starts;
    uint32_t end_count, start_count;
} bmr_sweep_event;

/// Called at each place, with all strands so far. It may write to the `gap` of those that the event names.
typedef void bmr_sweep_visit(void *context, bmr_strand *strands, const bmr_sweep_event *event);

/// The most strands and the most places that a sweep over so many points comes to: a place splits one edge in
/// two at most, since two edges that both went through it would cross or overlap.
static inline uint32_t bmr_sweep_most_strands(uint32_t points) {
    return 2 * points;
}

/// Sweeps a line from left to right over an outline that bmr_rings_find_short has passed: finds the first
/// crossing, overlap or hole that is not one (Shamos and Hoey, "Geometric intersection problems", 1976, with
/// points on edges let through), and tells the visitor (NULL: nobody) of all places before it. O(n log n).
/// Errors: that of the fault, which it writes to *fault; NO_MEMORY.
bmr_error bmr_sweep(const bmr_ring_links *links, const bmr_allocator *allocator, bmr_sweep_visit *visit,
                    void *context, bmr_outline_fault *fault);

#endif
