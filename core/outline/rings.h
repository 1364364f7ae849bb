// SPDX-License-Identifier: MIT
#ifndef BMR_OUTLINE_RINGS_H
#define BMR_OUTLINE_RINGS_H

#include <stdbool.h>

#include "boomerang/outline.h"

/// The rings of an outline, linked: what follows a point, what comes before it, which ring it is of. One
/// block.
typedef struct bmr_ring_links {
    const bmr_vec2 *points;
    uint32_t count; ///< of all points, and so of all edges: edge i goes from point i to next[i]
    uint32_t ring_count;
    uint32_t *next, *previous, *ring;
    size_t bytes;
} bmr_ring_links;

/// Checks what can be seen from the numbers alone: counts, finiteness. *count becomes the number of points.
bmr_error bmr_rings_check(const bmr_rings *rings, uint32_t *count);

/// Rings without the points that repeat the one before them in their ring (the last ones also: the first). Of
/// equal points in a row the one with the lowest index is kept. One block.
typedef struct bmr_distinct_rings {
    bmr_rings rings;
    uint32_t count; ///< of all points
    uint32_t *kept; ///< their indices in the rings that were given
    void *block;
    size_t bytes;
} bmr_distinct_rings;

/// Bytes of one block for points, an index of each, and the counts of the rings, in this order.
static inline size_t bmr_rings_bytes(uint32_t points, uint32_t rings) {
    return points * (sizeof(bmr_vec2) + sizeof(uint32_t)) + rings * sizeof(uint32_t);
}

/// Of rings that bmr_rings_check has passed. O(n). Errors: NO_MEMORY.
bmr_error bmr_distinct_rings_make(const bmr_rings *rings, uint32_t count, const bmr_allocator *allocator,
                                  bmr_distinct_rings *distinct);
void bmr_distinct_rings_free(bmr_distinct_rings *distinct, const bmr_allocator *allocator);

/// Links distinct rings that bmr_rings_find_short has passed. Errors: NO_MEMORY.
bmr_error bmr_ring_links_make(const bmr_rings *rings, uint32_t count, const bmr_allocator *allocator,
                              bmr_ring_links *links);
void bmr_ring_links_free(bmr_ring_links *links, const bmr_allocator *allocator);

/// A ring of fewer than three points, as a fault; BMR_OK where there is none.
bmr_error bmr_rings_find_short(const bmr_rings *rings, bmr_outline_fault *fault);

/// -1, 0, 1: does the sweep from left to right come to a before b, at once, or behind? Of places above each
/// other it comes to the lower one first.
static inline int bmr_sweep_compare(bmr_vec2 a, bmr_vec2 b) {
    if (a.x != b.x)
        return a.x < b.x ? -1 : 1;
    return a.y < b.y ? -1 : a.y > b.y;
}

/// Sorts, stably, in O(n log n) whatever the order was. `scratch` is as large as `items`.
typedef bool bmr_index_before(const void *context, uint32_t a, uint32_t b);
void bmr_sort_indices(uint32_t *items, uint32_t count, uint32_t *scratch, bmr_index_before *before,
                      const void *context);

/// The work of bmr_outline_simplify, of rings that are linked. Errors: those of bmr_sweep (a fault, which
/// goes to *fault; NO_MEMORY).
bmr_error bmr_simplify(const bmr_ring_links *links, double tolerance, const bmr_allocator *allocator,
                       uint32_t *kept, uint32_t *counts, bmr_outline_fault *fault);

#endif
