// SPDX-License-Identifier: MIT
#ifndef BMR_KDS_FAILING_H
#define BMR_KDS_FAILING_H

#include "boomerang/kds.h"

/// A value within this part of its magnitudes of zero may be a failure that was found a little early or
/// late; farther from zero, its sign alone counts.
#define BMR_FAILING_PART 1e-10

/// d/dt of bmr_condition_value under the instant's rates. O(1).
double bmr_condition_rate(const bmr_condition *condition, const bmr_instant *now);

/// Has the condition failed at this instant? Where its value is zero up to `tolerance`, it has if it is
/// falling, or not positive and not growing.
bool bmr_condition_fails(const bmr_condition *condition, const bmr_instant *now, double tolerance);

#endif
