// SPDX-License-Identifier: MIT
#include "convex_paths.h"

#include <math.h>
#include <stdlib.h>

/// How far the polygons reach below their chains.
#define BELOW 2.0

static bmr_vec2 turned(bmr_vec2 v, double angle) {
    const bmr_pose turn = {{0.0, 0.0}, cos(angle), sin(angle)};
    return bmr_rotate(&turn, v);
}

/// Whose is edge i? The body's number.
static int dealt(const test_chain_def *def, uint32_t i, test_random *random) {
    if (def->deal == TEST_DEAL_POINT)
        return 0;
    return (int)(def->deal == TEST_DEAL_RANDOM ? test_random_below(random, 2) : i % 2);
}

/// The body under the chain `points` (of `count`), in a frame that is turned against it; `sign` -1: the
/// negative of it, for what is subtracted.
static test_kds_body body_of(bmr_vec2 *points, uint32_t count, double turn, double sign) {
    if (count > 1) {
        points[count] = bmr_vec2_make(points[count - 1].x, points[0].y - BELOW);
        points[count + 1] = bmr_vec2_make(points[0].x, points[0].y - BELOW);
        count += 2;
    }
    for (uint32_t i = 0; i < count; ++i)
        points[i] = turned(bmr_scale(sign, points[i]), -turn);
    bmr_polygon *polygon = NULL;
    if (bmr_polygon_create(points, count, NULL, &polygon) != BMR_OK)
        abort();
    return test_kds_body_make(polygon);
}

test_chain test_chain_make(const test_chain_def *def, test_random *random) {
    bmr_vec2 points[2][TEST_CHAIN_MOST];
    uint32_t count[2] = {1, 1};
    if (def->edges + 3 > TEST_CHAIN_MOST)
        abort();
    points[0][0] = bmr_vec2_make(0.0, -1.0);
    points[1][0] = bmr_vec2_make(0.0, 0.0);
    for (uint32_t i = 0; i < def->edges; ++i) {
        const bmr_vec2 edge = {1.0, pow(def->ratio, -(double)i) - pow(def->ratio, -(double)(i + 1))};
        const int whose = dealt(def, i, random);
        points[whose][count[whose]] = bmr_add(points[whose][count[whose] - 1], edge);
        ++count[whose];
    }
    test_chain chain = {
        {body_of(points[0], count[0], def->turn[0], 1.0), body_of(points[1], count[1], def->turn[1], -1.0)},
        {.cubic = {{0.0, 0.0}}}};
    // All that is seen from A's frame is turned back by its turn.
    const double k = def->edges;
    const bmr_vec2 cubic[3] = {{0.0, def->bend}, {k, -2.0 * def->bend}, {0.0, def->bend}};
    for (int i = 0; i < 3; ++i)
        chain.path.cubic[i] = turned(cubic[i], -def->turn[0]);
    chain.path.angle = def->turn[1] - def->turn[0];
    return chain;
}

void test_chain_destroy(test_chain *chain) {
    for (int i = 0; i < 2; ++i)
        test_kds_body_destroy(&chain->body[i]);
}

unsigned test_tree_depth(const bmr_polygon *polygon) {
    unsigned depth = 0;
    while (((uint64_t)1 << depth) < (uint64_t)polygon->count + 1)
        ++depth;
    return depth;
}
