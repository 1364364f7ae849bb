// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_CONVEX32_REFERENCE_H
#define BOOMERANG_TEST_CONVEX32_REFERENCE_H

#include "convex32/convex32_collide.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// Box2D's manifolds of polygons, circles and edges by plain loops over all vertices, in float and in Box2D's
/// order, with the differences past 8 vertices that convex32_collide.h names. Nothing of core's is used, so
/// that what is compared with it stands on its own. For at most 8 vertices it is compared with Box2D itself
/// (test_glue_same_bits).

/// The first edge of largest separation, and that.
float reference_max_separation(const bmr_convex32 *reference, const bmr_transform32 *pose,
                               const bmr_convex32 *other, const bmr_transform32 *other_pose, uint32_t *edge);

/// The least of the other's vertices from one edge.
float reference_edge_separation(const bmr_convex32 *reference, const bmr_transform32 *pose, uint32_t edge,
                                const bmr_convex32 *other, const bmr_transform32 *other_pose);

void reference_collide(bmr_manifold32 *manifold, const bmr_convex32 *a, const bmr_transform32 *pose_a,
                       const bmr_convex32 *b, const bmr_transform32 *pose_b, float radius_sum,
                       float tolerance);
void reference_collide_circle(bmr_manifold32 *manifold, const bmr_convex32 *polygon,
                              const bmr_transform32 *pose_polygon, bmr_vec32 centre,
                              const bmr_transform32 *pose_circle, float radius_sum);
void reference_collide_edge(bmr_manifold32 *manifold, const bmr_edge32 *edge,
                            const bmr_transform32 *pose_edge, const bmr_convex32 *polygon, bmr_vec32 centroid,
                            const bmr_transform32 *pose_polygon, float radius_sum);

/// Is all that Box2D writes of a manifold the same to the bit, the signs of zeros aside? Both were all zero
/// before they were written.
bool reference_same_manifold(const bmr_manifold32 *a, const bmr_manifold32 *b);

// --- questions about one polygon ---

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

#ifdef __cplusplus
}
#endif
#endif
