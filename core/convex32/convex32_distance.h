// SPDX-License-Identifier: MIT
#ifndef BMR_CONVEX32_CONVEX32_DISTANCE_H
#define BMR_CONVEX32_CONVEX32_DISTANCE_H

#include "convex32/convex32.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// How far convex shapes of any size are apart, and when they meet. Vertices are float; what is computed from
/// them is double, so the answers are as good as the poses. A shape is a bmr_convex32 or, where it has no
/// normals, a few points (a circle's centre, an edge, a polygon of Box2D's), all of which are looked at.

/// What is asked about, as Box2D's b2DistanceProxy. A view: it owns nothing.
typedef struct bmr_proxy32 {
    bmr_convex32 polygon; ///< or points: normals and buckets NULL, any count from 1 up
    float radius;         ///< of the skin around it
    float reach;          ///< no vertex is farther from the origin of its frame
} bmr_proxy32;

static inline bmr_proxy32 bmr_proxy32_polygon(const bmr_convex32_block *block, float radius) {
    const bmr_proxy32 proxy = {block->polygon, radius, block->reach};
    return proxy;
}
/// O(count).
bmr_proxy32 bmr_proxy32_points(const bmr_vec32 *points, uint32_t count, float radius);

/// The vertices that were closest: where the next search begins. All zero at first. Never decides the answer.
typedef struct bmr_closest32 {
    uint32_t a, b;
} bmr_closest32;

/// Closest points (world), their distance and the simplex's vertices. Radii are left to the caller. 0 where
/// they overlap, and where they are so near that rounding decides on which side they are: within 2^-40
/// (1e-12) of the sum of their reaches and of the coordinates of both poses' positions. GJK: O(log n)
/// supports. Correct to 1e-6 of the larger of the distance and the reach of the shapes (an iteration chooses
/// supports in float).
typedef struct bmr_distance32 {
    bmr_vec32 point_a, point_b;
    float distance;
    int32_t iterations;                ///< pairs of supports
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

/// When the two first come within Box2D's target distance of each other (b2TimeOfImpact's contract: target
/// max(slop, radii - 3 slop), tolerance slop / 4), in [0, t_max]; t_max where they do not. Above 1 sweeps go
/// on as they went, as Box2D's do; below 0 it is the poses at 0 that are looked at. TOUCHING: at t they are
/// nearer than target + tolerance, and before they never were nearer than target, all but for rounding;
/// SEPARATED: they never are nearer than target. FAILED: up to t they never were nearer than target, but 400
/// directions were not enough to go on, or a number is none. No motion is known that needs so many where each
/// shape turns by up to 6 radians (fuzzed, not proved). Unlike Box2D's, this misses nothing up to t however
/// fast the shapes turn: a direction is left for another where it does not prove the whole of the way.
///
/// `direction`, zero or of unit length, is tried first, for all of the motion: a pair that stays apart costs
/// four supports. It becomes the one that kept them apart. It never decides the answer. Otherwise the cost is
/// that of a few distances, and at most of 400 with three dozen times each (shapes that turn by very
/// many radians).
bmr_impact32 bmr_convex32_impact(const bmr_proxy32 *a, const bmr_sweep32 *sweep_a, const bmr_proxy32 *b,
                                 const bmr_sweep32 *sweep_b, float t_max, float linear_slop,
                                 bmr_vec32 *direction, float *t);

/// b, moved by lambda times a translation, lambda from 0 to 1, without turning.
typedef struct bmr_cast32 {
    bmr_vec32 point;  ///< on a's skin
    bmr_vec32 normal; ///< from a to b
    float lambda;     ///< 1 without a hit
    int32_t iterations;
} bmr_cast32;

/// When does b come into touch with a? Box2D's b2ShapeCast: skins are at least twice the slop thick, the
/// distance looked for is that of both less twice the slop, up to half a slop more counts as reached.
/// Newton's iteration on a convex function: it never steps past the first touch.
///
/// False (point and normal zero) where they do not meet, and in two cases at the beginning, even if they meet
/// later: without skins they overlap (their bmr_convex32_distance is 0); or, as Box2D has it, a's vertex
/// farthest against the translation and b's farthest along it (of equal ones any) are so near that they count
/// as reached. Where others do at the beginning, in front of a side for instance, that is a hit at lambda 0,
/// whichever way b goes. (Box2D may miss them, or go on a little, where what is reached is only the half slop
/// more: as its vertices fall.)
bool bmr_convex32_cast(const bmr_proxy32 *a, const bmr_transform32 *pose_a, const bmr_proxy32 *b,
                       const bmr_transform32 *pose_b, bmr_vec32 translation, float linear_slop,
                       bmr_cast32 *cast);

#ifdef __cplusplus
}
#endif
#endif
