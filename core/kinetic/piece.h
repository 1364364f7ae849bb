// SPDX-License-Identifier: MIT
#ifndef BMR_KINETIC_PIECE_H
#define BMR_KINETIC_PIECE_H

#include "boomerang/kds.h"
#include "boomerang/motion.h"

/// @file
/// One piece of a motion, as the searches for event times need it: its state at a time, its expansion around
/// one, and bounds of its derivatives over an interval.

/// OK, NOT_FINITE or OUT_OF_RANGE: see bmr_motion_create.
bmr_error bmr_piece_check(const bmr_motion_piece *piece);
/// Pose, velocity and spin at a time.
bmr_instant bmr_piece_instant(const bmr_motion_piece *piece, double time);
/// Is the relative motion of this piece and another one of this kind a matter of polynomials?
bool bmr_piece_is_algebraic(const bmr_motion_piece *piece);
/// An algebraic piece, or a screw without spin, written in powers of t - time.
bmr_algebraic_piece bmr_piece_expand(const bmr_motion_piece *piece, double time);

/// p(u) becomes p(u + by). O(degree^2).
void bmr_taylor_shift(double *coefficients, size_t degree, double by);

/// Upper bounds over an interval; INFINITY where none is known.
typedef struct bmr_piece_rates {
    double speed, acceleration; ///< of the frame's origin
    double spin_low, spin_high; ///< range of the rate of the angle
    double spin_change;         ///< the largest magnitude of that rate's derivative
} bmr_piece_rates;
/// `to` - `from` finite. O(degree) and, where the rotation comes near a pole, as many subdivisions as that
/// takes (at most 2^POLE_DEPTH of them). Adds to *intervals how many it looked at.
bmr_piece_rates bmr_piece_bounds(const bmr_motion_piece *piece, double from, double to, size_t *intervals);
/// The largest magnitude of the spin.
static inline double bmr_rates_spin(const bmr_piece_rates *rates) {
    return rates->spin_high > -rates->spin_low ? rates->spin_high : -rates->spin_low;
}

#endif
