// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_CONVEX32_GJK_H
#define BOOMERANG_CONVEX32_GJK_H

#include "boomerang/pose.h"
#include "convex32/convex32_distance.h"

/// @file
/// The search of Gilbert, Johnson and Keerthi for the closest points, which distance, cast and impact share.
/// Vertices are float, poses and all that is computed from them double: only the choice of a support is made
/// in float.

/// A shape at a pose.
typedef struct bmr_posed32 {
    const bmr_proxy32 *proxy;
    bmr_pose pose;
} bmr_posed32;

static inline bmr_vec2 bmr_widen(bmr_vec32 v) {
    return bmr_vec2_make((double)v.x, (double)v.y);
}

static inline bmr_vec32 bmr_narrow(bmr_vec2 v) {
    const bmr_vec32 r = {(float)v.x, (float)v.y};
    return r;
}

static inline bmr_posed32 bmr_posed32_at(const bmr_proxy32 *proxy, const bmr_transform32 *pose) {
    const bmr_posed32 r = {proxy, {bmr_widen(pose->p), (double)pose->c, (double)pose->s}};
    return r;
}

static inline bmr_vec2 bmr_posed32_vertex(const bmr_posed32 *shape, uint32_t vertex) {
    return bmr_transform(&shape->pose, bmr_widen(shape->proxy->polygon.vertices[vertex]));
}

/// The vertex farthest along a direction of the world, of about unit length.
uint32_t bmr_posed32_support(const bmr_posed32 *shape, bmr_vec2 direction);

/// How far b lies beyond a along a direction of unit length; less than nothing where they overlap along it.
double bmr_posed32_beyond(const bmr_posed32 *a, const bmr_posed32 *b, bmr_vec2 direction);

/// What choosing supports in float may make of a distance: the reach of both times this.
#define BMR_SUPPORT32_ROUNDING 0x1p-21

/// A vertex of the difference b - a.
typedef struct bmr_difference32 {
    bmr_vec2 w;
    uint32_t a, b;
    double weight; ///< its part of the closest point
} bmr_difference32;

/// What the search ended with. 3 vertices: they surround the origin, the shapes overlap.
typedef struct bmr_gjk32 {
    bmr_difference32 vertices[3];
    int count;
    bmr_vec2 closest; ///< of b - a; zero where they overlap
    double distance;  ///< its length
    int iterations;   ///< pairs of supports looked for
} bmr_gjk32;

/// `closest` is where to begin, any numbers, and where it ended.
void bmr_gjk32_search(bmr_gjk32 *search, const bmr_posed32 *a, const bmr_posed32 *b, bmr_closest32 *closest);

/// The closest points in the world.
void bmr_gjk32_points(const bmr_gjk32 *search, const bmr_posed32 *a, const bmr_posed32 *b, bmr_vec2 *point_a,
                      bmr_vec2 *point_b);

#endif
