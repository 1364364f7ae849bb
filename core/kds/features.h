// SPDX-License-Identifier: MIT
#ifndef BMR_KDS_FEATURES_H
#define BMR_KDS_FEATURES_H

#include "geometry/distance.h"
#include "kds/structure.h"
#include "kds/windowed_line.h"

/// @file
/// The closest features of two convex polygons, tracked by Voronoi regions (Lin and Canny; V-Clip), as state
/// that a structure holds. Conditions let each region reach a rounding's width over its border, so that two
/// neighbouring pairs of features are never both about to fail.
///
/// A segment's ends have cones of half a turn, which two conditions cannot let overlap. Where it lies
/// parallel to an edge and stays so, no pair of features holds: the closest direction does, as a line fixed
/// in A.

/// Two vertices, or an edge (from its body's vertex to the next) and a vertex, or none and a line instead.
typedef struct bmr_feature_pair {
    uint32_t vertex[2]; ///< of A, of B
    int edge_owner;     ///< whose feature is the edge; -1: none's
    bool by_line;       ///< no pair holds: `line` does
    bmr_windowed_line line;
} bmr_feature_pair;

/// The pair at a pose, from nothing. False: within the margin.
bool bmr_features_start(const bmr_kds *kds, const bmr_instant *now, bmr_feature_pair *pair,
                        unsigned *touched);
/// Condition 0 is that of the distance, the others those of the regions; or those of the line.
size_t bmr_features_conditions(const bmr_kds *kds, const bmr_feature_pair *pair, bmr_condition *conditions);
/// Walks on from the failure of one condition. False: within the margin.
bool bmr_features_repair(const bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_feature_pair *pair,
                         unsigned *touched);
/// The line that the features prove at a pose: the edge's, or that across the closest points; or the line
/// held.
void bmr_features_proof(const bmr_kds *kds, const bmr_feature_pair *pair, const bmr_pose *b_in_a,
                        bmr_kds_proof *proof);
/// Are these the closest ones? Against the distance computed from nothing. For a line: does it stand for B?
bmr_error bmr_features_audit(const bmr_kds *kds, const bmr_feature_pair *pair, const bmr_pose *b_in_a);

/// The width by which regions overlap (length units).
double bmr_features_overlap(const bmr_kds *kds);
/// Has the condition failed, found a little early or not? For the one that a repair is called for.
bool bmr_features_failed(const bmr_kds *kds, const bmr_condition *condition, const bmr_instant *now);
/// Is the condition of a distance violated, so that a walk must go on? It is if it is below zero by more than
/// rounding, or if it is not positive and does not grow.
bool bmr_features_violated(const bmr_kds *kds, const bmr_condition *condition, const bmr_instant *now);
/// Is the condition of a region, a side or a cone violated, so that a walk must go on? It is unless it is
/// above zero by more than the rounding of a sine. That it grows is not enough: the search for failures takes
/// one that grows slowly for failed. And a neighbour that overlaps can always be gone to.
bool bmr_features_outside(const bmr_condition *condition, const bmr_pose *b_in_a);

/// The angle by which the cone of a vertex's normals is widened: so little that its vertex is the support up
/// to rounding.
#define BMR_CONE_OVERLAP 1e-13

/// Is the cone of a vertex's normals half a turn wide, up to about the angle by which it would be widened?
/// Two conditions cannot describe a cone of more than half a turn. Up to that angle the polygon is then a
/// segment.
bool bmr_cone_is_half_turn(const bmr_polygon *p, uint32_t i);
/// What the cone of that vertex's normals is widened by: nothing where it is half a turn.
double bmr_cone_overlap(const bmr_polygon *p, uint32_t i);

static inline bmr_vec2 bmr_turned_slightly(bmr_vec2 v, double angle) {
    return bmr_add(v, bmr_scale(angle, bmr_left(v)));
}

#endif
