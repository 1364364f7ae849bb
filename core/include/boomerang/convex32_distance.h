// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_CONVEX32_DISTANCE_H
#define BOOMERANG_CONVEX32_DISTANCE_H

#include "boomerang/convex32.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// How far convex shapes of any size are apart, and when they meet. A shape is a bmr_convex32 or, where it
/// has no normals, 1 to 8 points (a circle's centre, an edge, a polygon of Box2D's).

/// What is asked about, as Box2D's b2DistanceProxy.
typedef struct bmr_proxy32 {
    bmr_convex32 polygon; ///< or points: normals and buckets NULL, count 1 to 8
    float radius;
} bmr_proxy32;

/// The vertices that were closest: where the next search begins. All zero at first. Never decides the
/// answer.
typedef struct bmr_closest32 {
    uint32_t a, b;
} bmr_closest32;

/// Closest points (world), their distance and the simplex's vertices. Radii are left to the caller. 0 where
/// they overlap. GJK; a support costs O(log n) or the steps from the last one. Correct to 1e-5 of the larger
/// of the distance and the reach of the shapes.
typedef struct bmr_distance32 {
    bmr_vec32 point_a, point_b;
    float distance;
    int32_t iterations;
    int32_t count;                     ///< of the simplex: 1 to 3
    uint32_t vertex_a[3], vertex_b[3]; ///< its vertices
} bmr_distance32;
bmr_distance32 bmr_convex32_distance(const bmr_proxy32 *a, const bmr_transform32 *pose_a,
                                     const bmr_proxy32 *b, const bmr_transform32 *pose_b,
                                     bmr_closest32 *closest);

/// Box2D's b2Sweep.
typedef struct bmr_sweep32 {
    bmr_vec32 local_center, c0, c;
    float a0, a, alpha0;
} bmr_sweep32;

typedef enum bmr_impact32 {
    BMR_IMPACT_FAILED,
    BMR_IMPACT_OVERLAPPED,
    BMR_IMPACT_TOUCHING,
    BMR_IMPACT_SEPARATED
} bmr_impact32;

/// When the two come within Box2D's target distance of each other (b2TimeOfImpact's contract: target
/// max(slop, radii - 3 slop), tolerance slop / 4), in [0, t_max]; t_max where they do not. Nothing is missed:
/// conservative advancement along separating axes. Cost: a few distances.
bmr_impact32 bmr_convex32_impact(const bmr_proxy32 *a, const bmr_sweep32 *sweep_a, const bmr_proxy32 *b,
                                 const bmr_sweep32 *sweep_b, float t_max, float linear_slop, float *t);

/// When b, moved by `translation` without turning, comes into touch with a: Box2D's b2ShapeCast. False where
/// it does not, or overlaps at the beginning.
bool bmr_convex32_cast(const bmr_proxy32 *a, const bmr_transform32 *pose_a, const bmr_proxy32 *b,
                       const bmr_transform32 *pose_b, bmr_vec32 translation, float linear_slop,
                       bmr_vec32 *point, bmr_vec32 *normal, float *lambda, int32_t *iterations);

#ifdef __cplusplus
}
#endif
#endif
