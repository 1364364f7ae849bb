// SPDX-License-Identifier: MIT
#ifndef BMR_CERTIFICATE_LAZY_H
#define BMR_CERTIFICATE_LAZY_H

#include "certificate/walk.h"

/// @file
/// The lazy structure of the paper's section 5, "Two Translating Polygons" and "Rigid Motion": an edge of one
/// envelope separates it from the other envelope of the same level, whose nearest corner is watched. pair/
/// has it for poses that are sampled, kds/ for motions that are known. Who calls says what a proof is (floats
/// in 64 bytes, or conditions in doubles), when it is taken, and what it does where no edge separates.
///
/// Walking, pushing, stabbing, rolling and coarsening are all one climb (walk.h), on one level or on one
/// level after the other: the local neighbourhoods that the paper relies on do not always hold the new edge.

/// Where a proof stands.
typedef struct bmr_lazy_place {
    bmr_corner corner; ///< of the other body's envelope, the nearest
    bmr_edge edge;     ///< the owner's
    int level;         ///< of both envelopes
    int owner;
} bmr_lazy_place;

/// A start or a repair at work.
typedef struct bmr_lazy {
    bmr_walk walk;
    bmr_candidate found; ///< what the proof was made of, on the walk's level
    double reach;        ///< a candidate of a larger gap than this is offered to `take`
    double roll_reach;   ///< and after a roll one of a larger gap than this
    bool roll_after;     ///< a roll goes on from the corner after its edge; else from the one of the edge's
                         ///< two that rounding makes extreme
    bmr_walk_take *take;
    void *context;
} bmr_lazy;

/// What a repair ended with. After a roll or a push coarser levels may be apart, too: bmr_walk_ascend from
/// `found`.
typedef enum bmr_lazy_end {
    BMR_LAZY_NONE, ///< no edge separates
    BMR_LAZY_ROLL, ///< the edge stays, its corner is another one
    BMR_LAZY_PUSH, ///< another edge of the same level
    BMR_LAZY_STAB  ///< an edge of a deeper level
} bmr_lazy_end;

/// From the extreme corners in a direction: the best edge of the level, or of the first deeper one that
/// separates. False: none.
bool bmr_lazy_start(bmr_lazy *lazy, bmr_vec2 direction, int level);
/// From a place whose proof failed. `turned`: the direction has left the corner's cone.
bmr_lazy_end bmr_lazy_repair(bmr_lazy *lazy, bmr_lazy_place at, bool turned);
/// Is there such an edge on the level, and such a corner?
bool bmr_lazy_is_place(const bmr_hierarchy *const hierarchies[2], const bmr_lazy_place *at);

#endif
