// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_INFLATED_H
#define BOOMERANG_INFLATED_H

#include "boomerang/hierarchy.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// Inflated hierarchies (section 6 of the paper): Q'_j = Q_j[eps_j] is the envelope Q_j with every edge moved
/// outwards by eps_j. Nothing of them is stored: an edge of Q'_j is an edge of Q_j with another offset. The
/// polygons Q'_0, Q'_1, ... are nested because both the envelopes and the offsets shrink.
///
/// A point beyond an edge of Q'_j is beyond the parallel edge of Q_j by eps_j or more. That slack gives
/// hysteresis. `slack` below always means the signed distance beyond the uninflated line.

/// The offsets eps_j = first * ratio^j, and the envelope of each: Q_j is level root_level + j of the
/// hierarchy (the paper's tuning: a richer root polygon). Plain data.
typedef struct bmr_inflation {
    double first; ///< eps_0, length units
    double ratio; ///< in (0, 1)
    uint32_t root_level;
} bmr_inflation;

/// Makes eps_j = alpha * diameter * ratio^j. For two polygons `diameter` is the sum of both. With alpha =
/// ratio = 1/2 and a compass hierarchy, eps_j is at least the height of every boomerang that Q_j leaves
/// (Lemma compass (a)), for j <= ceil(log2 n).
bmr_inflation bmr_inflation_make(double diameter, double alpha, double ratio, uint32_t root_level);
/// The diameter of the polygon's bounding disk: at least the polygon's own, at most 1.155 times it. O(1).
double bmr_inflation_diameter(const bmr_polygon *polygon);

/// eps_j. O(1).
double bmr_inflation_offset(const bmr_inflation *inflation, uint32_t j);
/// The level of the hierarchy whose envelope is Q_j: at most the depth, where Q_j = Q.
uint32_t bmr_inflation_level(const bmr_inflation *inflation, const bmr_hierarchy *hierarchy, uint32_t j);
/// The least j with Q_j = Q.
uint32_t bmr_inflation_last(const bmr_inflation *inflation, const bmr_hierarchy *hierarchy);

/// How far a point is beyond an edge's line; < 0 if it is behind. O(1).
double bmr_edge_slack(const bmr_hierarchy *hierarchy, bmr_edge edge, bmr_vec2 point);

/// A corner of the inflated envelope: the point where the lines of two adjacent edges meet, both moved
/// outwards by `offset`. At most offset * sqrt 2 from the uninflated corner. O(1).
bmr_vec2 bmr_inflated_corner(const bmr_hierarchy *hierarchy, bmr_corner corner, double offset);

/// Of the two edges that meet in a corner, the one with more slack at a point. Let u be the direction from
/// the polygon's closest point to `point`, and `corner` the extreme corner of some level in u
/// (bmr_hierarchy_extreme, _refine). If `point` is beyond any edge of that level, then this edge has the most
/// slack of all edges of that level. (The slack of a line of normal y is F(y) = <y, x> - max over Q of <y,
/// .>. F grows towards u from both sides of the cone where it is positive, and every edge of every level is a
/// support line of Q itself.) O(1).
bmr_edge bmr_corner_widest_edge(const bmr_hierarchy *hierarchy, bmr_corner corner, bmr_vec2 point,
                                double *slack);

/// The place where a line enters the inflated envelope P_level[offset].
typedef struct bmr_entry {
    bmr_edge edge;    ///< the edge that it enters through
    double parameter; ///< the entry is start + parameter * direction; > 0: the start is outside
    uint32_t steps;   ///< levels descended
} bmr_entry;
/// The entry of the line from `start` along `direction` (not zero), which must pass through the polygon
/// itself or touch it. It is the breakpoint of the paper, found on the fly. O(level).
bmr_entry bmr_inflated_entry(const bmr_hierarchy *hierarchy, uint32_t level, double offset, bmr_vec2 start,
                             bmr_vec2 direction);

#ifdef __cplusplus
}
#endif
#endif
