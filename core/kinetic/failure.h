// SPDX-License-Identifier: MIT
#ifndef BMR_KINETIC_FAILURE_H
#define BMR_KINETIC_FAILURE_H

#include <float.h>
#include <math.h>

#include "boomerang/condition.h"
#include "boomerang/failure.h"
#include "kinetic/motion.h"
#include "kinetic/roots.h"

/// @file
/// The searches for the time at which a condition fails: on polynomials, for algebraic motions; by safe
/// steps, for any.

// ---- how a condition that is about zero where a search begins is judged; the same for every method ----

/// Within this many bounds of its rounding error a value is zero. (A condition and its opposite are computed
/// from different corners; the sum of their errors must not look like a failure.)
#define BMR_START_NOISES 2.0

/// An event is up to one tolerance early, and then the opposite of the condition that failed is still below
/// zero, until the true time. One that is positive after this much is growing.
static inline double bmr_start_grace(double time, double tolerance) {
    return 4.0 * fmax(tolerance, DBL_EPSILON * fabs(time));
}

// ---- many conditions ----

/// The first failure of any of `count` conditions in (from, to], and which one fails; INFINITY: none, and
/// *failing is as it was. Errors: those of bmr_failure_time.
bmr_error bmr_first_failure(const bmr_condition *conditions, size_t count, const bmr_motion *a,
                            const bmr_motion *b, double from, double to, const bmr_failure_options *options,
                            double *time, size_t *failing);

/// From where a failing condition is no longer positive, at or a little after `time`: its failure is reported
/// up to a tolerance (here: absolute) early, and structures take a positive condition for a call that comes
/// too early. No sample after the second is farther from `time` than `longest`.
double bmr_repair_time(const bmr_pair_motion *motion, const bmr_condition *condition, double time,
                       double tolerance, double longest);

// ---- polynomials ----

/// A polynomial in u, from 0 to 1 over an interval of time, that has the sign of a condition there.
typedef struct bmr_condition_polynomial {
    double c[BMR_POLYNOMIAL_MAX_DEGREE + 1];
    size_t degree;
    double width; ///< of the interval that 0 to 1 stands for
    double noise; ///< bound of the rounding error of its values on [0, 1]
} bmr_condition_polynomial;

/// The condition under two algebraic pieces on [from, from + width], width <= longest > 0 chosen such that
/// the polynomial's coefficients say no more than what happens there: in powers around a far origin, or on
/// too long an interval, the digits of the near values are lost. The condition is multiplied by the two
/// denominators (a^2 + b^2), which are positive, and DISKS is squared. (Its offset must be positive.) With
/// position of degree d and rotations of degrees r and q: BEYOND has degree d + 2r + 2q, TURN 2r + 2q, DISKS
/// 2d + 2r + 2q; at most 48.
void bmr_condition_expand(const bmr_condition *condition, const bmr_motion_piece *owner,
                          const bmr_motion_piece *other, double from, double longest,
                          bmr_condition_polynomial *polynomial);

#endif
