// SPDX-License-Identifier: MIT
#ifndef BMR_KDS_POINT_H
#define BMR_KDS_POINT_H

#include "boomerang/inflated.h"
#include "kds/structure.h"

/// @file
/// What all structures for a point outside a polygon share (section 5, "One Point, One Polygon", and section
/// 6). The point is B's vertex, or, where a structure runs on the explicit Minkowski sum of two translating
/// polygons, the origin of B's frame (kds/sum.c); the polygon is A, or that sum.
///
/// All lines are moved outwards by the margin, so that a failed certificate is a point on the margin. Edges
/// alone are not enough there: past a sharp vertex no edge's line is as far from the point as the polygon is.
/// A point near the margin at such a place is certified by the closest direction itself, a free line, until
/// that fails.

typedef struct bmr_point_state {
    const bmr_hierarchy *hierarchy; ///< of the polygon
    bmr_vec2 point;                 ///< B's frame
    bmr_line free_line;             ///< A's frame, when `edge` is BMR_NO_EDGE
    bmr_edge edge;                  ///< the separating edge
    uint32_t near_a, near_b;        ///< support vertices of the last distance query
    bmr_pose turned;                ///< B's rotation, of use where B is a polygon
} bmr_point_state;

/// The state comes first in that of every structure for points.
static inline bmr_point_state *bmr_point_get(bmr_kds *kds) {
    return (bmr_point_state *)(void *)kds->state;
}
static inline const bmr_point_state *bmr_point_view(const bmr_kds *kds) {
    return (const bmr_point_state *)(const void *)kds->state;
}

/// A's hierarchy of the info's kind, and B's vertex.
bmr_error bmr_point_prepare(bmr_kds *kds);

/// The point in A's frame.
bmr_vec2 bmr_point_at(const bmr_kds *kds, const bmr_pose *b_in_a);
/// Two lines are told apart by this: more than the rounding of a slack, and small beside what a contact may
/// be early by.
double bmr_point_tolerance(const bmr_kds *kds);
/// The slack from which on a line is taken for a certificate: the margin, the hysteresis for a pair that
/// leaves contact, and the tolerance. It fails at the margin, so that no certificate fails where it was made.
double bmr_point_need(const bmr_kds *kds);
/// A condition's value from which on it counts as failed: half the tolerance, so that the caller's rounding
/// and ours can not disagree on a failure.
double bmr_point_failing(const bmr_kds *kds);

/// The direction from the polygon's closest point to the point, by the exact distance. False: no farther than
/// bmr_point_need. O(log n), less when the point has not gone far since the last query.
bool bmr_point_closest(bmr_kds *kds, const bmr_pose *b_in_a, bmr_vec2 *direction);
/// The certificate of the closest direction itself. False: contact.
bool bmr_point_take_free(bmr_kds *kds, const bmr_pose *b_in_a);

/// The line that certifies: the edge's, or the free one.
bmr_line bmr_point_line(const bmr_kds *kds);
/// The hierarchy's level of the certificate; its depth for a free line.
int bmr_point_level(const bmr_kds *kds);
/// The point's slack beyond the certificate's line, less the margin.
double bmr_point_value(const bmr_kds *kds, bmr_vec2 x);
/// Is that value beyond bmr_point_failing?
bool bmr_point_holds(const bmr_kds *kds, bmr_vec2 x);

/// The certificate's condition alone, for structures that wait for nothing else.
size_t bmr_point_conditions(const bmr_kds *kds, bmr_condition *conditions);
void bmr_point_proof(const bmr_kds *kds, bmr_kds_proof *proof);

/// Is the point on the counter-clockwise side of where the edge touches the polygon?
bool bmr_point_is_after(const bmr_hierarchy *hierarchy, bmr_edge edge, bmr_vec2 x);

/// Of the point just inside `edge`, which it crossed: the node whose triangle it is in now, found among those
/// that cut the edge on the side where the point is, one level after the other. BMR_NO_EDGE: it is not beyond
/// any, that is, at the polygon or at a sharp vertex. *steps counts nodes. O(levels between).
bmr_edge bmr_point_descend(const bmr_hierarchy *hierarchy, bmr_edge edge, bmr_vec2 x, double need,
                           unsigned *steps);

/// The active triangle's own functions, for the one on an explicit Minkowski sum.
bool bmr_triangle_start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report);
bool bmr_triangle_repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report);
size_t bmr_triangle_conditions(const bmr_kds *kds, bmr_condition *conditions);
bmr_error bmr_triangle_audit(const bmr_kds *kds, const bmr_pose *b_in_a);

#endif
