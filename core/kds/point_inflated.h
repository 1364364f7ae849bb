// SPDX-License-Identifier: MIT
#ifndef BMR_KDS_POINT_INFLATED_H
#define BMR_KDS_POINT_INFLATED_H

#include "kds/point.h"

/// @file
/// What the inflated structures for a point share (section 6).

/// The offsets of the pair's def, over the polygon's diameter.
bmr_inflation bmr_point_inflation(const bmr_kds *kds);
/// The slack that an edge of Q'_j promises: eps_j beyond the margin, and never less than what a certificate
/// needs at all.
double bmr_point_promised(const bmr_kds *kds, const bmr_inflation *inflation, uint32_t j);

/// The least j whose inflated envelope has the point outside, and the edge of most slack of Q_j. Where there
/// is none: j = last + 1 and, near the polygon (bmr_coarse_below), the coarsest edge that separates, else the
/// best edge of Q.
typedef struct bmr_level_choice {
    bmr_edge edge;
    uint32_t j;
    double slack;
} bmr_level_choice;
/// `u`: the closest direction. O(j).
bmr_level_choice bmr_point_most_slack(bmr_kds *kds, bmr_vec2 x, bmr_vec2 u, unsigned *touched);
/// Takes that edge, or the closest direction where no edge will do. False: contact.
bool bmr_point_choose_by_slack(bmr_kds *kds, const bmr_pose *b_in_a, unsigned *touched);
bool bmr_point_inflated_start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report);

/// The frame of a repair: has the certificate failed, and what became of it.
bool bmr_point_inflated_fails(const bmr_kds *kds, bmr_vec2 x, bmr_kds_report *report);
bool bmr_point_inflated_done(const bmr_kds *kds, bool apart, bmr_kds_report *report);

/// The edge of the cell of the inflated complex that the point is in, walking from the edge `from` of Q_j,
/// whose line in Q'_j the point is beyond, or a neighbour: between Q'_(j-1) and Q'_j, or for j = last + 1
/// between the last and the polygon. O(cells walked).
bmr_edge bmr_point_complex_cell(const bmr_kds *kds, bmr_edge from, uint32_t j, bmr_vec2 x, unsigned *touched);

/// One side of a cell of the complex: from the corner (on the inner polygon) to the corner it came from (on
/// the outer one). Both are inflated; j >= 1 as above.
typedef struct bmr_connector {
    bmr_vec2 inner, outer;
} bmr_connector;
bmr_connector bmr_point_complex_connector(const bmr_kds *kds, bmr_corner corner, uint32_t j);

#endif
