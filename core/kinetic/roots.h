// SPDX-License-Identifier: MIT
#ifndef BMR_KINETIC_ROOTS_H
#define BMR_KINETIC_ROOTS_H

#include <stdbool.h>
#include <stddef.h>

#include "boomerang/error.h"

#ifdef __cplusplus
extern "C" {
#endif

/// The highest degree of a polynomial here: that of the condition on two disks under two
/// algebraic motions of the highest degrees (boomerang/motion.h), 2 * 8 + 2 * 8 + 2 * 8.
#define BMR_POLYNOMIAL_MAX_DEGREE 48

/// c[0] + c[1] x + .. + c[degree] x^degree.
static inline double bmr_polynomial_value(const double *c, size_t degree, double x) {
    double value = c[degree];
    for (size_t k = degree; k-- > 0;)
        value = value * x + c[k];
    return value;
}

/// Where in [0, 1] does a polynomial, positive at 0, first stop being positive? Subdivision in the Bernstein
/// basis: a part whose coefficients are all positive has no root; one whose coefficients change sign once has
/// exactly one, which GSL's Newton ends. Returns false if there is none, else *low, at which the
/// polynomial is positive and after which it is not before *low + max(tolerance, 4 roundings).
///
/// A dip below zero that is no deeper than `noise` and comes back is not told from a touch, and passed over.
/// Depth 0 to BMR_POLYNOMIAL_MAX_DEGREE; O(degree^2) a subdivision; 24 KB of stack.
bool bmr_bernstein_first_root(const double *coefficients, size_t degree, double noise, double tolerance,
                              double *low);

/// GSL reports some errors through a handler that is global to the process and aborts by default; core never
/// aborts. Between enter and leave the handler is off; errors then come back as codes. Any number of threads
/// may be inside at once: the first switches the handler off, the last puts back what the first found.
void bmr_gsl_guard_enter(void);
void bmr_gsl_guard_leave(void);

#ifdef __cplusplus
}
#endif
#endif
