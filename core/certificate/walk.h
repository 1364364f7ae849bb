// SPDX-License-Identifier: MIT
#ifndef BMR_CERTIFICATE_WALK_H
#define BMR_CERTIFICATE_WALK_H

#include "boomerang/hierarchy.h"

/// @file
/// Walking from one candidate line to the next between two envelopes P_i and Q_i of the same level.
///
/// For a direction y let F(y) = min over Q_i of <y, .> - max over P_i of <y, .>, the gap that y proves. F is
/// concave and homogeneous, so the directions with F > 0 form one cone, and on it the best of them has no
/// rival: uphill is the way. The candidates are the normals of P_i's edges and the negated ones of Q_i's,
/// merged by angle; between two that follow each other the extreme corners p and q stay the same and F is <y,
/// q - p>.

/// The deepest level that differs from the polygon in either of two hierarchies (P_i = P for i >= depth).
int bmr_walk_deepest(const bmr_hierarchy *const hierarchies[2]);

/// A place on the walk. Directions are in A's frame.
typedef struct bmr_walk {
    const bmr_hierarchy *hierarchies[2]; ///< of A and B
    const bmr_pose *pose;                ///< of B in A's frame
    int level;
    bmr_vec2 direction;   ///< not zero
    bmr_corner corner[2]; ///< of A's envelope, extreme in the direction; of B's, extreme against it
    unsigned steps;       ///< so far: nodes of the hierarchies and candidates looked at
} bmr_walk;

/// A candidate line and what it proves.
typedef struct bmr_candidate {
    double gap;
    int owner; ///< 0: an edge of A's, 1: of B's
    bmr_edge edge;
    bmr_vec2 direction;   ///< from A to B, in A's frame, normal to the edge
    bmr_corner corner[2]; ///< extreme in it, as in bmr_walk; the owner's is one end of the edge
} bmr_candidate;

/// Puts the walk on a level, at the extreme corners in a direction (not zero). O(level).
void bmr_walk_start(bmr_walk *walk, bmr_vec2 direction, int level);

/// Goes to the next level: the corners are cut. O(1).
void bmr_walk_refine(bmr_walk *walk);

/// Walks uphill to the top of F and returns the best candidate met. False: gave up on the way, too far to
/// walk; else no direction within a right angle of the walk's new place separates the two envelopes by more
/// than sqrt(2) times the candidate's gap. O(steps), at most BMR_WALK_STEPS.
bool bmr_walk_climb(bmr_walk *walk, bmr_candidate *best);

/// More steps than this cost more than a start from the closest direction does. Between two samples of a
/// motion that is sampled finely, a walk has one or two.
#define BMR_WALK_STEPS 32

/// A coarser proof (disks instead of a line, a coarser envelope) replaces a finer one only if its gap beyond
/// the need is at least this part of the finer one's. With 0, as in the paper, a level that is apart by
/// nearly nothing is taken and may fail at the next step: roll, coarsen, stab, and again. With this, a stab
/// after a coarsening has cost a motion of this part of the gap. Events hardly depend on it: some percent
/// fewer on orbits with 1/4 than with 0, and no fewer with 1/2.
#define BMR_COARSEN_PART 0.25

/// Makes the caller's proof of a candidate on a level. False: it proves too little, and nothing is changed.
typedef bool bmr_walk_take(void *context, const bmr_candidate *candidate, int level);

/// From a candidate of the walk's level, which is the caller's proof, to coarser levels, one after the other,
/// while a line there proves BMR_COARSEN_PART of the finer one's gap beyond `need`, and more than `reach` (>=
/// need). Each is offered to `take`. On the way up the first line that is good enough is taken: between two
/// neighbouring edges of one body may lie any number of the other's, and a climb to the best line would pass
/// them all. The best one is looked for on the last level, and offered again where it is better.
/// O(levels gained) expected, and one climb.
void bmr_walk_ascend(bmr_walk *walk, bmr_candidate candidate, double need, double reach, bmr_walk_take *take,
                     void *context);

/// The point of a corner, in A's frame.
bmr_vec2 bmr_walk_point(const bmr_walk *walk, int side, bmr_corner corner);
/// The level of a hierarchy that plays in level `level` of the pair.
uint32_t bmr_walk_side_level(const bmr_hierarchy *hierarchy, int level);

// ---- the lazy structure ----
//
// The lazy structure of the paper's section 5, "Two Translating Polygons" and "Rigid Motion": an edge of one
// envelope separates it from the other envelope of the same level, whose nearest corner is watched. pair/
// has it for poses that are sampled, kds/ for motions that are known. Who calls says what a proof is (floats
// in 64 bytes, or conditions in doubles), when it is taken, and what it does where no edge separates.
//
// Walking, pushing, stabbing, rolling and coarsening are all one climb, on one level or on one
// level after the other: the local neighbourhoods that the paper relies on do not always hold the new edge.

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
