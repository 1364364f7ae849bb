// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_KINETIC_H
#define BOOMERANG_KINETIC_H

#include <stddef.h>

#include "boomerang/error.h"
#include "boomerang/vector.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// Rigid motions as functions of time, and when something that depends on one fails for the first time
/// (section 2 of the paper: a certificate's failure time is the root of a polynomial).
///
/// These functions are in the library boomerang::kinetic, which links the GNU Scientific Library and so falls
/// under the GPL-3 wherever it is distributed. Nothing in boomerang::core or boomerang::box2d needs it.

/// A body whose frame's origin moves along a straight line while the body turns about that origin at a
/// constant rate: what a body without forces does when the origin is its centre of mass. Spin 0 is a
/// translation.
typedef struct bmr_screw_motion {
    bmr_pose start;    ///< the pose at time 0
    bmr_vec2 velocity; ///< of the origin, length units per unit of time
    double spin;       ///< counter-clockwise, radians per unit of time
} bmr_screw_motion;

/// The pose at `time`, which may be negative. (c, s) is as far from unit length as the start's, up to two
/// roundings; the angle turned is spin * time, rounded once. A NaN or an infinity comes out as NaN. O(1).
bmr_pose bmr_screw_motion_pose(const bmr_screw_motion *motion, double time);

/// The highest degree that bmr_polynomial_first_root takes: that of the condition on two disks under two
/// algebraic motions of the highest degrees (boomerang/motion.h), 2 * 8 + 2 * 8 + 2 * 8.
#define BMR_POLYNOMIAL_MAX_DEGREE 48

/// The first root in [from, to] of the polynomial sum of coefficients[k] t^k, k = 0 .. degree (so
/// `coefficients` has degree + 1 entries; leading zeros are allowed). *root becomes
///   - the least t of the interval at which the polynomial is zero as far as double tells: |p(t)| is within
///   the rounding
///     error of evaluating it there. A polynomial that only touches zero counts, one that is zero all over
///     gives `from`;
///   - INFINITY when there is none: it never happens.
/// Where p has different signs at `from` and `to`, some root is always found. Two roots nearer to each other
/// than the square root of double's precision (relative to max(|from|, |to|)) may come out as one. Put the
/// origin of time near the interval: in powers of t, accuracy is relative to max(|from|, |to|), not to the
/// interval's length.
///
/// Degree <= 2 in closed form, else gsl_poly_complex_solve: O(degree^3), some microseconds at degree 4 to 8.
/// No allocation: 20 KB of stack. Errors: NULL_ARGUMENT; NOT_FINITE (a coefficient or an end of the
/// interval); OUT_OF_RANGE (degree above BMR_POLYNOMIAL_MAX_DEGREE, from > to, or GSL's QR iteration did not
/// converge). Then *root is untouched.
///
/// Threads: GSL has one error handler for the whole process, and its default aborts. It is switched off while
/// a call that needs the solver runs and put back by the last such call to end; calls of this function may
/// run on any number of threads at once. What it cannot protect are others: a GSL error on another thread in
/// that time goes unreported, and a handler installed by another thread in that time is replaced by the one
/// before it. A program that calls gsl_set_error_handler_off() at its start has neither problem.
bmr_error bmr_polynomial_first_root(const double *coefficients, size_t degree, double from, double to,
                                    double *root);

#ifdef __cplusplus
}
#endif
#endif
