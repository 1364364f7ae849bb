// SPDX-License-Identifier: MIT
#ifndef BMR_KINETIC_FAILURE_START_H
#define BMR_KINETIC_FAILURE_START_H

#include <float.h>
#include <math.h>

/// @file
/// How a condition that is about zero where a search begins is judged; the same for every method.

/// Within this many bounds of its rounding error a value is zero. (A condition and its opposite are computed
/// from different corners; the sum of their errors must not look like a failure.)
#define BMR_START_NOISES 2.0

/// An event is up to one tolerance early, and then the opposite of the condition that failed is still below
/// zero, until the true time. One that is positive after this much is growing.
static inline double bmr_start_grace(double time, double tolerance) {
    return 4.0 * fmax(tolerance, DBL_EPSILON * fabs(time));
}

#endif
