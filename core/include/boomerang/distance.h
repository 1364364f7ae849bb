// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_DISTANCE_H
#define BOOMERANG_DISTANCE_H

#include "boomerang/polygon.h"
#include "boomerang/pose.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// How two posed polygons lie to each other, asked once and from nothing: no state is kept, nothing is
/// allocated. Who asks about the same two again and again wants boomerang/pair.h, which remembers a proof.
///
/// A pose takes a polygon from its own frame to the world; NULL stands for bmr_pose_identity(). Its (c, s) is
/// made of unit length first. Points and normals of the answers are the world's. Both polygons may be points
/// or segments.
///
/// What rounding costs: every length in an answer is right up to BMR_DISTANCE_ROUNDING times the sum of both
/// extents and of the magnitudes of both positions (and up to 1e-150, where squares underflow: two points
/// that near may have distance 0). Polygons that are nearer to touching than that may be called apart or
/// overlapping. A normal between closest points is off by an angle of at most twice that over the distance.
///
/// Errors of both functions: NULL_ARGUMENT; NOT_FINITE (a pose with a NaN or an infinity); OUT_OF_RANGE (a
/// position beyond BMR_MAX_COORDINATE, a (c, s) whose square is off 1 by more than BMR_DISTANCE_UNIT). Then
/// the answer is untouched.
#define BMR_DISTANCE_ROUNDING 1e-14
#define BMR_DISTANCE_UNIT 1e-3

/// Two closest points. Where the polygons touch or overlap, all of it is zero: ask bmr_penetration.
typedef struct bmr_closest_points {
    double distance; ///< > 0: that of the two points
    bmr_vec2 point_a, point_b;
    /// From A to B, unit length. The lines through the two points at right angles to it have the polygons on
    /// either side of the gap between them.
    bmr_vec2 normal;
} bmr_closest_points;

/// The distance of two polygons and a pair of closest points. Of many such pairs (two parallel sides) it is
/// any one. O(log n + log m) time for n and m vertices, with no hierarchy: each step leaves out half of what
/// is left of one of the two polygons. (Of vertices that lie together as far as doubles tell, and of polygons
/// that all but touch, up to some fifty times as much: one search for each bit of a direction.)
bmr_error bmr_distance(const bmr_polygon *a, const bmr_pose *pose_a, const bmr_polygon *b,
                       const bmr_pose *pose_b, bmr_closest_points *closest);

/// How deep two polygons are in each other. Where they are apart, all of it is zero: ask bmr_distance.
typedef struct bmr_overlap {
    double depth; ///< >= 0: the length of the shortest translation that takes them out of each other
    /// Which way B goes then, unit length: moved by depth * normal it touches A. Zero where both polygons are
    /// points at one place: any way will do.
    bmr_vec2 normal;
    /// A's point that is deepest in B and B's that is deepest in A, along the normal: point_a - point_b =
    /// depth * normal. One of them is a vertex, the other lies on the line of an edge.
    bmr_vec2 point_a, point_b;
} bmr_overlap;

/// The penetration depth of two polygons: least over the normals of all edges of both. O((n + m) log) time at
/// worst, and a few steps an edge where the other polygon's edges are spread alike. Not logarithmic as
/// bmr_distance is, nor would it be with a hierarchy: a depth may have as many local minima as there are
/// edges (a regular polygon about a point at its centre has n that are equal), so that no part of the edges
/// can be left out unseen. Polygons that are apart are told so in O(log n + log m).
bmr_error bmr_penetration(const bmr_polygon *a, const bmr_pose *pose_a, const bmr_polygon *b,
                          const bmr_pose *pose_b, bmr_overlap *overlap);

#ifdef __cplusplus
}
#endif
#endif
