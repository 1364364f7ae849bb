// SPDX-License-Identifier: MIT
#ifndef BMR_KINETIC_PAIR_MOTION_H
#define BMR_KINETIC_PAIR_MOTION_H

#include "boomerang/kds.h"
#include "boomerang/motion.h"

/// @file
/// Two bodies' motions taken together: the relative state, jumps, and when the bodies are apart again.

typedef struct bmr_pair_motion {
    const bmr_motion *a, *b;
    const bmr_polygon *shape_a, *shape_b;
} bmr_pair_motion;

/// B's frame in A's, and its rates.
bmr_instant bmr_pair_instant(const bmr_pair_motion *pair, double time);

/// The first time in (from, to] at which the pose of either body jumps; INFINITY if there is none. O(pieces
/// in between).
double bmr_pair_next_jump(const bmr_pair_motion *pair, double from, double to);
/// Does a piece begin at `time`, and with a jump?
bool bmr_pair_jumps_at(const bmr_pair_motion *pair, double time);

/// How fast any point of one can move as seen from any point of the other, at most, in [from, to]. O(pieces
/// in between).
double bmr_pair_speed(const bmr_pair_motion *pair, double from, double to);

/// The polygons' distance; where they overlap, minus the depth over the normals of all edges. O(n + m).
double bmr_pair_separation(const bmr_pair_motion *pair, double time);

/// The first time in (from, to] at which the separation rises above `target`, or above what it is at `from`
/// if that is more; INFINITY if there is none. The separation changes no faster than the fastest points of
/// the bodies: steps that they cannot make up for are safe. Steps are at least a thousandth of `longest_step`
/// (a pair apart for less than that may be missed) and at most `longest_step`; the time is exact up to the
/// tolerance, and not before the true one. NAN: not found within two million looks. While nothing moves, no
/// look is needed.
double bmr_pair_leaves(const bmr_pair_motion *pair, double from, double to, double target,
                       double longest_step, double tolerance);

#endif
