// SPDX-License-Identifier: MIT
#ifndef BMR_HIERARCHY_BUILDER_H
#define BMR_HIERARCHY_BUILDER_H

#include "hierarchy/tree.h"

/// @file
/// What all three hierarchies are built from: a list of edges in angular order, each boomerang cut by the
/// median one of those that lie in it. A compass hierarchy cuts its upper levels by directions of a table
/// instead.

/// An edge that a boomerang may be cut by.
typedef struct bmr_item {
    bmr_vec2 normal; ///< unit length
    uint32_t touch;  ///< own: the polygon's edge; else the vertex the degenerate edge touches
    uint32_t own; ///< 1: an edge of the polygon (several items may stand for one edge); 0: a degenerate edge
} bmr_item;

struct bmr_compass {
    uint32_t levels;
    uint32_t reserved;
    /// Level by level: E, N, W, S; then for level i >= 1 the odd multiples of 90 / 2^i degrees at 4 * 2^(i-1)
    /// and on. So the directions of the upper levels, which all polygons use, lie together.
    bmr_vec2 directions[];
};

typedef struct bmr_build {
    const bmr_polygon *polygon;
    bmr_hierarchy_kind kind;
    const bmr_item *items; ///< sorted by the angle of the normal, from E on
    uint32_t item_count;
    const bmr_compass *compass; ///< NULL: no compass levels
    uint32_t compass_levels;    ///< how many levels bisect the angle
    uint32_t
        corner_levels; ///< of those, how many cut the corners that are vertices already: zero-length edges
} bmr_build;

/// The most edges, the roots left out, that a tree over so many items has.
size_t bmr_most_cuts(size_t items, uint32_t compass_levels, uint32_t corner_levels);

/// Turns a list that is in counter-clockwise order into one that starts at direction E.
void bmr_items_start_at_east(bmr_item *items, uint32_t count);

/// The hierarchy's one block. The median's levels take O(items), the compass's O(items + nodes log items).
bmr_error bmr_build_tree(const bmr_build *build, const bmr_allocator *allocator, bmr_hierarchy **hierarchy);
/// The same over the polygon's own edges: `build` comes without items.
bmr_error bmr_build_of_edges(bmr_build build, const bmr_allocator *allocator, bmr_hierarchy **hierarchy);

/// The depth that the hierarchy's kind promises. A quadrant never holds all edges, so a balanced tree of them
/// is no deeper than their logarithm.
uint32_t bmr_tree_most_levels(const bmr_hierarchy *hierarchy);
/// The most edges that the kind promises, zero-length edges at vertices included.
uint32_t bmr_tree_most_edges(const bmr_hierarchy *hierarchy);

/// The smallest k with 2^k >= n, for n >= 1.
uint32_t bmr_ceil_log2(uint32_t n);

#endif
