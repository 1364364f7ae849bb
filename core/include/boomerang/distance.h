// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_DISTANCE_H
#define BOOMERANG_DISTANCE_H

#include "boomerang/polygon.h"
#include "boomerang/pose.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// Distance and penetration of two posed polygons, asked once. No state is kept, and nothing is allocated. To
/// ask about the same two polygons again and again, use boomerang/pair.h, which remembers a proof.
///
/// A pose takes a polygon from its own frame to the world; NULL means bmr_pose_identity(). Its (c, s) is
/// first made of unit length. Points and normals of the answers are in the world's frame. Either polygon may
/// be a point or a segment.
///
/// Rounding: every length in an answer is right up to BMR_DISTANCE_ROUNDING times the sum of both extents and
/// of the magnitudes of both positions. (And up to 1e-150, where squares underflow: two points that near may
/// have distance 0.) Two polygons that are nearer to touching than that may be called apart or overlapping. A
/// normal between closest points is off by an angle of at most twice that error over the distance.
///
/// Errors of both functions: NULL_ARGUMENT; NOT_FINITE (a pose with a NaN or an infinity); OUT_OF_RANGE (a
/// position beyond BMR_MAX_COORDINATE, a (c, s) whose square is off 1 by more than BMR_DISTANCE_UNIT). Then
/// the answer is untouched.
#define BMR_DISTANCE_ROUNDING 1e-14
#define BMR_DISTANCE_UNIT 1e-3

/// Two closest points. If the polygons touch or overlap, every member is zero: ask bmr_penetration.
typedef struct bmr_closest_points {
    double distance; ///< of the two points; > 0
    bmr_vec2 point_a, point_b;
    /// From A to B, unit length. The lines across it through the two points separate the polygons: the gap
    /// lies between these lines.
    bmr_vec2 normal;
} bmr_closest_points;

/// The distance of two polygons and a pair of closest points: any one of them, if there are many (two
/// parallel sides). O(log n + log m) time for n and m vertices, without a hierarchy: each step halves one of
/// the two polygons. Up to some fifty times as much if doubles can hardly tell vertices apart, or if the
/// polygons nearly touch: then it makes one search for each bit of a direction.
bmr_error bmr_distance(const bmr_polygon *a, const bmr_pose *pose_a, const bmr_polygon *b,
                       const bmr_pose *pose_b, bmr_closest_points *closest);

/// How deep two polygons are in each other. If they are apart, every member is zero: ask bmr_distance.
typedef struct bmr_overlap {
    double depth; ///< length of the shortest translation that parts them; >= 0
    /// The direction of that translation of B, unit length: moved by depth * normal, B touches A. Zero if
    /// both polygons are points at one place: any direction will do.
    bmr_vec2 normal;
    /// A's point that is deepest in B and B's point that is deepest in A, along the normal: point_a - point_b
    /// = depth * normal. One of them is a vertex, the other lies on the line of an edge.
    bmr_vec2 point_a, point_b;
} bmr_overlap;

/// The penetration depth of two polygons: the least over the normals of all edges of both. At worst O((n + m)
/// log) time; a few steps an edge if the other polygon's edges are spread alike. It cannot be logarithmic as
/// bmr_distance is, even with a hierarchy: a depth may have as many local minima as there are edges (a
/// regular polygon about a point at its centre has n that are equal), so no edge can be skipped. For polygons
/// that are apart it takes O(log n + log m).
bmr_error bmr_penetration(const bmr_polygon *a, const bmr_pose *pose_a, const bmr_polygon *b,
                          const bmr_pose *pose_b, bmr_overlap *overlap);

#ifdef __cplusplus
}
#endif
#endif
