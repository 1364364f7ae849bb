// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_CONVEX32_LOOPS_H
#define BOOMERANG_TEST_CONVEX32_LOOPS_H

#include "convex32/convex32.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// What is asked of a polygon in float, answered by a loop over all vertices, in float and in Box2D's order.
/// Nothing of core's is used.

/// The largest product of a vertex and the direction.
float loop_support(const bmr_convex32 *polygon, bmr_vec32 direction);
bool loop_contains(const bmr_convex32 *polygon, bmr_vec32 point);
/// As Box2D goes through the edges. `skip` is an edge left out (UINT32_MAX: none).
bool loop_ray(const bmr_convex32 *polygon, bmr_vec32 p1, bmr_vec32 p2, float max_fraction, uint32_t skip,
              float *fraction, uint32_t *edge);
void loop_box(const bmr_convex32 *polygon, const bmr_transform32 *pose, bmr_vec32 *lower, bmr_vec32 *upper);

/// What bodies are made of, in long double; inertia about the centroid.
typedef struct loop_mass {
    long double area, x, y, inertia;
} loop_mass;
loop_mass loop_measure(const bmr_convex32 *polygon);

/// From the point to the polygon of these vertices, in double; 0 inside.
double loop_distance(const bmr_vec32 *vertices, size_t count, bmr_vec32 point);

#ifdef __cplusplus
}
#endif
#endif
