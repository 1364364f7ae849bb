// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_HIERARCHIES_H
#define BMR_TEST_HIERARCHIES_H

#include "boomerang/hierarchy.h"
#include "polygons.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Shows a visitor one hierarchy of each kind for each family and size; `rounds` times, with other polygons
/// each time. Returns false if something could not be built.
typedef void (*test_visitor)(const bmr_hierarchy *hierarchy, test_family family, test_random *random,
                             void *context);
bool test_visit_hierarchies(const bmr_compass *compass, const size_t *sizes, size_t size_count, size_t rounds,
                            uint64_t seed, test_visitor visit, void *context);

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
