// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_FAILURE_H
#define BOOMERANG_FAILURE_H

#include "boomerang/condition.h"
#include "boomerang/motion.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// The time at which a condition first fails while the two bodies move (section 2 of the paper: "we can
/// compute the next time t when F(t) = 0"). In boomerang::kinetic.

/// Under algebraic motions the function is a polynomial. Subdivision in the Bernstein basis separates its
/// first root from the others, and gsl_root_fdfsolver_newton finds the last digits. (If a spinning screw
/// motion takes part, the search takes steps over which a bound of the second derivative keeps the condition
/// positive, and gsl_root_fsolver_brent finds the last digits.)
typedef struct bmr_failure_options {
    /// > 0. A failure may be reported early by at most this much time, times max(1, |time|) and not less than
    /// a few roundings of the time. It is never reported late: until the returned time the condition's true
    /// value is >= 0, up to the rounding of evaluating it (some 1e-14 of the magnitudes involved, more for
    /// rotations of high degree: see core/kinetic/failure.h). A dip below zero that is no deeper
    /// than that, and a touch, may be passed over or reported.
    double tolerance;
} bmr_failure_options;
/// A tolerance of 1e-12.
bmr_failure_options bmr_default_failure_options(void);

/// The first time in (after, until] at which the condition is no longer positive while A and B move as given;
/// INFINITY if there is none. If the condition is not positive at `after`:
///   - zero up to rounding and growing: it does not fail; the function must first come back to zero;
///   - below zero by more, but above it after four tolerances: it grows, too. (An event comes up to a
///   tolerance early. Until its true time the opposite of the failed condition is below zero.)
///   - anything else, zero and flat included: it fails at `after` itself.
/// The search covers all pieces of both motions from `after` on, a jump between two of them included, but not
/// a piece that begins at `until`.
///
/// Cost: under two algebraic motions some microseconds for each interval on which their terms keep their size
/// (one, unless the motion is followed far); with a spin some ten samples of 100 ns for a root and five for
/// each turn. No allocation; 32 KB of stack. Errors: NULL_ARGUMENT; NOT_FINITE (an argument, or a number that
/// follows from it); OUT_OF_RANGE (after > until, a tolerance that is not positive, no such condition, or
/// a search over two pieces does not end within the steps below: ask for a shorter time). Then *time is
/// untouched.
bmr_error bmr_failure_time(const bmr_condition *condition, const bmr_motion *a, const bmr_motion *b,
                           double after, double until, const bmr_failure_options *options, double *time);
/// The most steps of a search over two pieces, one of them spinning: enough for some 50,000 turns, which
/// takes a few hundredths of a second. If the other piece is algebraic and its a and b have a common root
/// (motion.h), the search spends its steps around that root and takes up to a second. (There each sample of
/// the bounds of the rates counts as a quarter of a step.)
#define BMR_FAILURE_MAX_STEPS ((size_t)1 << 18)
/// The most intervals of a search under two algebraic pieces, at some microseconds each.
#define BMR_FAILURE_MAX_INTERVALS ((size_t)1 << 14)

#ifdef __cplusplus
}
#endif
#endif
