// SPDX-License-Identifier: MIT
#ifndef BMR_KINETIC_BERNSTEIN_H
#define BMR_KINETIC_BERNSTEIN_H

#include <stdbool.h>
#include <stddef.h>

/// Where in [0, 1] does a polynomial, positive at 0, first stop being positive? Subdivision in the Bernstein
/// basis: a part whose coefficients are all positive has no root; one whose coefficients change sign once has
/// exactly one, which Newton's method ends. Returns false if there is none, else *low, at which the
/// polynomial is positive and after which it is not before *low + max(tolerance, 4 roundings).
///
/// A dip below zero that is no deeper than `noise` and comes back is not told from a touch, and passed over.
/// Depth 0 to BMR_POLYNOMIAL_MAX_DEGREE; O(degree^2) a subdivision; 24 KB of stack.
bool bmr_bernstein_first_root(const double *coefficients, size_t degree, double noise, double tolerance,
                              double *low);

#endif
