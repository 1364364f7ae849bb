// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_HIERARCHIES_H
#define BMR_TEST_HIERARCHIES_H

#include "boomerang/hierarchy.h"
#include "polygons.h"

#ifdef __cplusplus
extern "C" {
#endif

/// For polygons of any size, for the life of the program.
const bmr_compass *test_compass(void);

/// With the directions of test_compass, by malloc. Aborts on failure: a test without memory is none.
bmr_hierarchy *test_hierarchy(bmr_hierarchy_kind kind, const bmr_polygon *polygon);

/// Shows a visitor one hierarchy of each kind for each family and size; `rounds` times, with other polygons
/// each time.
typedef void (*test_visitor)(const bmr_hierarchy *hierarchy, test_family family, test_random *random,
                             void *context);
void test_visit_hierarchies(const size_t *sizes, size_t size_count, size_t rounds, uint64_t seed,
                            test_visitor visit, void *context);

/// By looking at all pairs of vertices.
double test_diameter(const bmr_polygon *polygon);
/// Of a convex polygon.
double test_area(const bmr_vec2 *points, size_t count);
/// The largest <direction, point>.
double test_farthest(const bmr_vec2 *points, uint32_t count, bmr_vec2 direction);
/// A third of the time the normal of an edge (a tie), else anything.
bmr_vec2 test_direction(const bmr_hierarchy *hierarchy, test_random *random);

#ifdef __cplusplus
}
#endif
#endif
