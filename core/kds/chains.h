// SPDX-License-Identifier: MIT
#ifndef BMR_KDS_CHAINS_H
#define BMR_KDS_CHAINS_H

#include "kds/point.h"

/// @file
/// The search for the new active triangle by halves (section 5: O(log(log n - i)) after crossing the inner
/// edge).
///
/// The nodes that cut an edge at one of its ends follow each other in the tree, one level deeper each: a
/// chain. The triangles along the edge, from its end to where it touches the polygon, are those of the chain
/// in order. A search needs the chain as an array. Every node is in two chains: 16 bytes a node.
///
/// The search gallops: from the chain's start in steps that double, then by halves. So it takes the logarithm
/// of the levels passed, which are at most log n and, where the point is at distance s, O(log D/s): the
/// minimum of Theorem ptpoly, and less.

struct bmr_chains {
    const bmr_hierarchy *hierarchy;
    uint32_t count; ///< of nodes
    uint32_t reserved;
    uint32_t arrays[]; ///< start[2 (count + 1)], node[2 count]
};

typedef struct bmr_chained_state {
    bmr_point_state point;
    const bmr_chains *chains; ///< the polygon's, or those behind this state
} bmr_chained_state;

size_t bmr_kds_chains_bytes(const bmr_shape *a, const bmr_shape *b, const bmr_kds_def *def);
/// As bmr_point_prepare, and makes the chains if the shape has none. WRONG_HIERARCHY: it has another
/// hierarchy's. O(n), O(1) with the shape's.
bmr_error bmr_kds_chains_prepare(bmr_kds *kds);

/// NULL: the structure has none.
const bmr_chains *bmr_kds_chains_of(const bmr_kds *kds);
/// What bmr_point_descend does, galloping. O(log levels passed).
bmr_edge bmr_kds_chains_search(const bmr_chains *chains, bmr_edge edge, bmr_vec2 x, double need,
                               unsigned *steps);

#endif
