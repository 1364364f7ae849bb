// SPDX-License-Identifier: MIT
#ifndef BMR_KINETIC_MOTION_H
#define BMR_KINETIC_MOTION_H

#include "boomerang/kds.h"
#include "boomerang/motion.h"

/// @file
/// Motions, as the searches for event times need them: what a motion is made of, one piece of it, and the
/// motions of two bodies taken together.

// ---- what a motion is made of ----

typedef struct bmr_timed_piece {
    double from;
    bmr_motion_piece piece;
} bmr_timed_piece;

struct bmr_motion {
    const bmr_allocator *allocator;
    size_t count, capacity;
    bmr_timed_piece *pieces; ///< ascending; the first is from -INFINITY
};

/// Copies a piece that bmr_piece_check found nothing wrong with, and makes its rotation of unit length.
void bmr_timed_piece_set(bmr_timed_piece *timed, double from, const bmr_motion_piece *piece);

/// The motion of this one piece, for all time, without memory of its own: not to be changed or destroyed.
static inline bmr_motion bmr_motion_of_piece(bmr_timed_piece *timed) {
    const bmr_motion motion = {NULL, 1, 1, timed};
    return motion;
}

/// What the motion is from `time` on, in blocks of `allocator`. Errors: NO_MEMORY.
bmr_error bmr_motion_copy_from(const bmr_motion *motion, double time, const bmr_allocator *allocator,
                               bmr_motion **copy);

// ---- one piece: its state at a time, its expansion around one, bounds of its derivatives ----

/// OK, NOT_FINITE or OUT_OF_RANGE: see bmr_motion_create.
bmr_error bmr_piece_check(const bmr_motion_piece *piece);
/// Pose, velocity and spin at a time.
bmr_instant bmr_piece_instant(const bmr_motion_piece *piece, double time);
/// Is the relative motion of this piece and another one of this kind a matter of polynomials?
bool bmr_piece_is_algebraic(const bmr_motion_piece *piece);
/// An algebraic piece, or a screw without spin, written in powers of t - time.
bmr_algebraic_piece bmr_piece_expand(const bmr_motion_piece *piece, double time);

/// Upper bounds over an interval; INFINITY where none is known.
typedef struct bmr_piece_rates {
    double speed, acceleration; ///< of the frame's origin
    double spin_low, spin_high; ///< range of the rate of the angle
    double spin_change;         ///< the largest magnitude of that rate's derivative
} bmr_piece_rates;
/// `to` - `from` finite. O(degree) and, where the rotation comes near a pole, as many subdivisions as that
/// takes (at most 2^POLE_DEPTH of them). Adds to *intervals how many it bounded.
bmr_piece_rates bmr_piece_bounds(const bmr_motion_piece *piece, double from, double to, size_t *intervals);
/// The largest magnitude of the spin.
static inline double bmr_rates_spin(const bmr_piece_rates *rates) {
    return rates->spin_high > -rates->spin_low ? rates->spin_high : -rates->spin_low;
}

// ---- two bodies: the relative state, jumps, and when they are apart again ----

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
/// tolerance, and not before the true one. NAN: not found within two million samples. While nothing moves, no
/// sample is needed.
double bmr_pair_leaves(const bmr_pair_motion *pair, double from, double to, double target,
                       double longest_step, double tolerance);

#endif
