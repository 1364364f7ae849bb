// SPDX-License-Identifier: MIT
#ifndef BMR_HIERARCHY_TREE_H
#define BMR_HIERARCHY_TREE_H

#include <assert.h>
#include <math.h>

#include "boomerang/hierarchy.h"
#include "geometry/distance.h"
#include "geometry/length.h"

/// @file
/// How a hierarchy lies in memory: what its queries, builders and audit share.
///
/// A node is 16 bytes, four to a cache line, and the nodes are in breadth-first order: the levels above the
/// polygon, which are all that a pair far apart looks at, share a few lines. Nothing that can be had from the
/// polygon or from the shared table of directions is stored: not the offset, not the apex, not the normal of
/// one of the polygon's own edges.

/// The tree's roots, edges of the bounding rectangle.
#define BMR_ROOTS 4u
/// 20 bits: a compass hierarchy has at most 5 n nodes, n < 2^16, and a compass table at most 4 * 2^16
/// directions.
#define BMR_ID_BITS 20
/// Within a node, "none" is 0, the id of root E, which is nobody's child.
#define BMR_NO_CHILD 0u

typedef struct bmr_node {
    uint64_t outer_before : BMR_ID_BITS;
    uint64_t outer_after : BMR_ID_BITS;
    uint64_t touch : 16; ///< first vertex on the line, counter-clockwise
    uint64_t level : 6;  ///< at most 2 * 16
    uint64_t own : 1;    ///< the line is that of the polygon's own edge `touch`
    uint64_t wide : 1;   ///< the line touches vertex touch + 1, too (always so if own)
    uint64_t child_before : BMR_ID_BITS;
    uint64_t child_after : BMR_ID_BITS;
    uint64_t direction : BMR_ID_BITS; ///< unless own: which of the tree's directions the normal is
} bmr_node;

static_assert(sizeof(bmr_node) == 16, "a node is a quarter of a cache line");

struct bmr_hierarchy {
    const bmr_polygon *polygon;
    const bmr_vec2
        *directions; ///< unit normals; the first four are E, N, W, S. The compass's own, or in this block.
    uint32_t count;
    uint32_t direction_count; ///< how many are in this block
    uint16_t depth;
    uint8_t kind;
    uint8_t corner_levels; ///< how many levels cut vertices, too
    uint32_t stamp;        ///< the polygon's when this was built: another may lie at its address by now
    bmr_node nodes[];
};

/// Two lines whose directions agree within this (radians) are one: their meeting point would be noise, and a
/// pair would roll between them for ever. The polygon's own edges go first; the error is at most this times
/// an edge's length.
#define BMR_MERGE_ANGLE 1e-11
/// Two directions equal up to the rounding of two unit normals.
#define BMR_SAME_ANGLE 1e-15

/// Is what lies at `r` from an end of edge i beyond that end, along the edge? However short the edge is.
static inline bool bmr_tree_beyond(const bmr_polygon *p, uint32_t i, bmr_vec2 r) {
    return bmr_ascends(bmr_edge_vector(p, i), bmr_scale_up_if_tiny(r));
}

/// Is the hierarchy of this kind, and was it built over this polygon? The address alone does not tell: the
/// polygon may have been freed, and another made where it was. Reads nothing of the hierarchy's own polygon,
/// which may be gone.
static inline bool bmr_tree_is_of(const bmr_hierarchy *h, int kind, const bmr_polygon *polygon) {
    return (int)h->kind == kind && h->polygon == polygon && h->stamp == polygon->stamp;
}

/// The outer normal of an edge in some positive length, but not so short that products underflow: all that
/// signs and meeting points need.
static inline bmr_vec2 bmr_tree_normal(const bmr_hierarchy *h, const bmr_node *node) {
    if (!node->own)
        return h->directions[node->direction];
    const bmr_vec2 e = bmr_edge_vector(h->polygon, (uint32_t)node->touch);
    return bmr_scale_up_if_tiny(bmr_vec2_make(e.y, -e.x));
}

/// The vertex at which the chain leaves the line counter-clockwise; the one where it arrives is node->touch.
static inline uint32_t bmr_tree_last_touch(const bmr_hierarchy *h, const bmr_node *node) {
    const uint32_t next = (uint32_t)node->touch + (uint32_t)node->wide;
    return next < h->polygon->count ? next : 0;
}

static inline bmr_edge bmr_tree_link(uint64_t child) {
    return child == BMR_NO_CHILD ? BMR_NO_EDGE : (bmr_edge)child;
}

/// 0 for directions in [E, N), 1 in [N, W), 2 in [W, S), 3 in [S, E): the root edge before the direction.
static inline bmr_edge bmr_tree_quadrant(bmr_vec2 d) {
    if (d.y > 0.0)
        return d.x > 0.0 ? 0 : 1;
    if (d.y < 0.0)
        return d.x < 0.0 ? 2 : 3;
    return d.x < 0.0 ? 2 : 0;
}

/// Where the lines of two adjacent edges meet: from p = the last touch of `a` along a's line, so that the
/// error is relative to the distance of the two touch vertices however nearly parallel the lines are.
bmr_vec2 bmr_tree_meet(const bmr_hierarchy *h, const bmr_node *a, const bmr_node *b);

/// The queries of boomerang/hierarchy.h of the same names; `steps` is increased by the nodes looked at.
bmr_corner bmr_tree_corner_after(const bmr_hierarchy *hierarchy, bmr_edge edge, uint32_t level,
                                 unsigned *steps);
bmr_corner bmr_tree_corner_before(const bmr_hierarchy *hierarchy, bmr_edge edge, uint32_t level,
                                  unsigned *steps);
bmr_corner bmr_tree_refine(const bmr_hierarchy *hierarchy, bmr_corner corner, bmr_vec2 direction,
                           uint32_t to_level, unsigned *steps);
bmr_corner bmr_tree_extreme(const bmr_hierarchy *hierarchy, bmr_vec2 direction, uint32_t level,
                            unsigned *steps);

#endif
