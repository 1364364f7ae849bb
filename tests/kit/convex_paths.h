// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_CONVEX_PATHS_H
#define BMR_TEST_CONVEX_PATHS_H

#include "kds_driver.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// Convex translations at mu = n: two polygons whose Minkowski difference is a chain of k edges that comes
/// geometrically nearer to the path, (i, -ratio^-i), and the path along it.

typedef enum test_deal {
    TEST_DEAL_POINT,       ///< all edges to A; B is a point
    TEST_DEAL_ALTERNATELY, ///< to A and B in turn
    TEST_DEAL_RANDOM,      ///< each to one of them
    TEST_DEAL_COUNT
} test_deal;

typedef struct test_chain_def {
    uint32_t edges; ///< k
    double ratio;
    test_deal deal;
    double turn[2]; ///< of A's frame, and of B's, against the chain
    double bend;    ///< the path is (t, bend (t/k - 1)^2 ), 0 <= t <= k: it bends away from the chain
} test_chain_def;

typedef struct test_chain {
    test_kds_body body[2];
    test_path path;
} test_chain;

test_chain test_chain_make(const test_chain_def *def, test_random *random);
void test_chain_destroy(test_chain *chain);
/// The most vertices of a chain's polygon.
#define TEST_CHAIN_MOST 64

/// ceil(log2(n + 1)): how deep the tree of a polygon of n edges is (kds/coarse_line.h).
unsigned test_tree_depth(const bmr_polygon *polygon);

#ifdef __cplusplus
}
#endif
#endif
