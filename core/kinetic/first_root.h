// SPDX-License-Identifier: MIT
#ifndef BMR_KINETIC_FIRST_ROOT_H
#define BMR_KINETIC_FIRST_ROOT_H

#include <stddef.h>

#include "boomerang/error.h"

#ifdef __cplusplus
extern "C" {
#endif

/// The highest degree that bmr_polynomial_first_root takes: that of the condition on two disks under two
/// algebraic motions of the highest degrees (boomerang/motion.h), 2 * 8 + 2 * 8 + 2 * 8.
#define BMR_POLYNOMIAL_MAX_DEGREE 48

/// The first root in [from, to] of the polynomial sum of coefficients[k] t^k, k = 0 .. degree (so
/// `coefficients` has degree + 1 entries; leading zeros are allowed). *root becomes
///   - the least t of the interval at which the polynomial is zero as far as double tells: |p(t)| is within
///     the rounding error of evaluating it there. A polynomial that only touches zero counts, one that is
///     zero all over gives `from`;
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
/// Threads: see boomerang/kinetic.h.
bmr_error bmr_polynomial_first_root(const double *coefficients, size_t degree, double from, double to,
                                    double *root);

#ifdef __cplusplus
}
#endif
#endif
