// SPDX-License-Identifier: MIT
#ifndef BMR_KDS_CHAINS_H
#define BMR_KDS_CHAINS_H

#include "kds/point.h"

/// @file
/// Binary search for the new active triangle (section 5: O(log(log n - i)) after crossing the inner edge).
///
/// The nodes that cut an edge at one of its ends follow each other in the tree, one level deeper each: a
/// chain. The triangles along the edge, from its end to where it touches the polygon, are those of the chain
/// in order, so that a binary search finds the one that the point is in. A search needs the chain as an
/// array. Every node is in two chains: 16 bytes a node, O(n) for the pair, in the structure's own block.

typedef struct bmr_kds_chains {
    uint32_t count;    ///< of nodes; what follows: start[2 (count + 1)], node[2 count]
    uint32_t reserved; ///< keeps what follows aligned
} bmr_kds_chains;

typedef struct bmr_chained_state {
    bmr_point_state point;
    bmr_kds_chains chains; ///< the arrays follow
} bmr_chained_state;

size_t bmr_kds_chains_bytes_compass(const bmr_shape *a, const bmr_shape *b, const bmr_kds_def *def);
size_t bmr_kds_chains_bytes_dudley(const bmr_shape *a, const bmr_shape *b, const bmr_kds_def *def);
/// As bmr_point_prepare, and fills the chains. O(n).
bmr_error bmr_kds_chains_prepare(bmr_kds *kds);

/// NULL: the structure has none.
const bmr_kds_chains *bmr_kds_chains_of(const bmr_kds *kds);
/// What bmr_point_descend does, by binary search. O(log levels).
bmr_edge bmr_kds_chains_search(const bmr_kds_chains *chains, const bmr_hierarchy *hierarchy, bmr_edge edge,
                               bmr_vec2 x, double need, unsigned *steps);

#endif
