// SPDX-License-Identifier: MIT
#ifndef BMR_GEOMETRY_DISTANCE_H
#define BMR_GEOMETRY_DISTANCE_H

#include "boomerang/distance.h"
#include "geometry/polygon_query.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A support vertex found by climbing from `hint` (< count) for a few steps, else from scratch: O(1) when the
/// answer is near, O(log n) at worst. The direction is not zero.
uint32_t bmr_support_near(const bmr_polygon *polygon, bmr_vec2 direction, uint32_t hint, unsigned *steps);

/// Up to three vertices of the Minkowski difference B - A, each a pair of vertex indices: where the search
/// for the closest points stood. A query that starts where the last one ended takes one or two steps.
typedef struct bmr_simplex {
    uint32_t count; ///< 1 to 3
    uint32_t a[3], b[3];
    unsigned steps; ///< of the queries that it has served
} bmr_simplex;

/// A simplex of one pair of vertices.
bmr_simplex bmr_simplex_make(uint32_t a, uint32_t b);

/// A direction that separates two polygons.
typedef struct bmr_closest {
    bmr_vec2 direction; ///< unit, in A's frame, from A to B
    double separation;  ///< min over B - max over A along it: never more than the distance, up to rounding
    uint32_t a, b;      ///< support vertices of the two in that direction
} bmr_closest;

/// The separation that bmr_closest_direction reports may be this much below the distance, relatively, beside
/// rounding errors. Small against the float rounding (2^-24) that any certificate pays.
#define BMR_DISTANCE_TOLERANCE 2e-8

/// Are the polygons more than `reach` (>= 0) apart? True: *closest is a direction that separates them by more
/// than `reach`, and by what remains of the distance beyond it up to the part `slack` (0: the direction of
/// the closest points). False: the distance is at most `reach`, up to rounding and BMR_DISTANCE_TOLERANCE,
/// and *closest is untouched. `simplex` says where to start and gets where to start next time; the pose must
/// be finite. Gilbert, Johnson and Keerthi's algorithm in the plane, with support vertices from
/// bmr_support_near: O(1) where it starts near the closest points. How often it would iterate from afar is
/// not bounded by the logarithm (vertices (2^-k, 4^-k) at a distance of 1e-10 take 24): so after a few
/// iterations of polygons that are apart it goes on from where bmr_closest_start leads, which makes it
/// O(log n).
bool bmr_closest_direction(const bmr_polygon *a, const bmr_polygon *b, const bmr_pose *b_in_a, double reach,
                           double slack, bmr_simplex *simplex, bmr_closest *closest);

/// Finds the vertices, or the edge and the vertex, that are closest, for bmr_closest_direction to start (and,
/// up to rounding, to end) at. False: the polygons overlap or touch, up to rounding, and *start is vertices
/// anywhere. Edelsbrunner's search over two chains: each look at the middle edges of both discards half of
/// one. O(log n) whatever the polygons look like, O(log k) where the answer is k edges from the vertices of
/// `near`, whose steps *start takes over. The pose must be finite.
bool bmr_closest_start(const bmr_polygon *a, const bmr_polygon *b, const bmr_pose *b_in_a,
                       const bmr_simplex *near, bmr_simplex *start);

/// As bmr_distance.
bmr_error bmr_distance_counted(const bmr_polygon *a, const bmr_pose *pose_a, const bmr_polygon *b,
                               const bmr_pose *pose_b, bmr_closest_points *closest, unsigned *steps);

/// How far a polygon is beyond the line of another one's edge.
typedef struct bmr_edge_gap {
    double separation; ///< < 0: it is not all beyond it; -INFINITY of a point, which has no edge
    bmr_vec2 normal;   ///< the edge's, outwards, its polygon's frame
    bmr_vec2 nearest;  ///< the other polygon's vertex that is deepest, the same frame
} bmr_edge_gap;
/// The largest over the edges of `own`; the other polygon's deepest vertex moves along with them. O(n + m).
bmr_edge_gap bmr_best_edge(const bmr_polygon *own, const bmr_polygon *other, const bmr_pose *other_in_own);

#ifdef __cplusplus
}
#endif
#endif
