// SPDX-License-Identifier: MIT
#ifndef BMR_KDS_HELD_CELL_H
#define BMR_KDS_HELD_CELL_H

#include "hierarchy/mixed_cells.h"
#include "kds/structure.h"

/// @file
/// A cell of the mixed hierarchy as conditions and as a proof.
///
/// A point that moves along a border of two cells, or hierarchies with edges in common directions that never
/// turn, would make conditions that are zero and stay zero. So the cell is one of A and of B displaced by a
/// fixed tiny rigid motion: by design nothing is aligned with A then. All lines are moved outwards by as
/// much, and by half the margin each: what is proved holds for B itself, with the margin.

/// The pose for which a cell is chosen may differ from that of the event by this part of the extents, and by
/// as many radians.
#define BMR_HELD_SLACK 1e-9
/// Level of what is outside of M_0.
#define BMR_HELD_OUTSIDE_LEVEL (-1)

typedef struct bmr_held_cell {
    bmr_mixed mixed;       ///< at the rotation of the last event, a little ahead
    bmr_pose displacement; ///< of B in its own frame
    double scale;          ///< the extents
    double room;           ///< how far B's points are from where the displacement has them, at most
    bmr_mixed_cell cell;   ///< a cell, or an edge of M_0
} bmr_held_cell;

/// What the conditions are labelled: the roles of the sides, and the two orders.
enum { BMR_HELD_SIDE = 8, BMR_HELD_PAGE = BMR_HELD_SIDE + 4, BMR_HELD_COLLAPSE };

/// No cell yet, but all that does not depend on the pose.
bmr_held_cell bmr_held_make(const bmr_kds *kds);
/// The pose of the displaced B, given that of B.
bmr_pose bmr_held_displaced(const bmr_held_cell *held, const bmr_pose *pose);

static inline bool bmr_held_is_cell(const bmr_held_cell *held) {
    return held->cell.kind < BMR_MIXED_OUTSIDE;
}
/// The level of the edge that made the cell.
int bmr_held_level(const bmr_held_cell *held);
/// The edge whose line is the proof, and its body.
bmr_edge bmr_held_edge(const bmr_held_cell *held, int *owner);

/// One BEYOND for each side, then, if the pair may turn, two TURNs.
size_t bmr_held_conditions(const bmr_held_cell *held, bool turns, bmr_condition *conditions);
void bmr_held_proof(const bmr_held_cell *held, bmr_kds_proof *proof);
/// Up to BMR_HELD_SLACK: are all conditions true? And is the tuple one of its stage: were the other body's
/// edges there when e was inserted, a triangle's two adjacent?
bmr_error bmr_held_audit(const bmr_held_cell *held, const bmr_pose *b_in_a);

#endif
