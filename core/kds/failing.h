// SPDX-License-Identifier: MIT
#ifndef BMR_KDS_FAILING_H
#define BMR_KDS_FAILING_H

#include "boomerang/kds.h"

/// Failure times are found a little early. So a condition that is still positive counts as failed where its
/// value is less than this part of the magnitudes that it is computed from, and falling.
#define BMR_FAILING_PART 1e-10

/// d/dt of bmr_condition_value under the instant's rates. O(1).
double bmr_condition_rate(const bmr_condition *condition, const bmr_instant *now);

/// Has the condition failed at this instant? It has if it is not positive, or if it is at most `tolerance`
/// and falling. A condition below zero has failed even if it grows: where a motion turns round just after the
/// failure, the search for failures reports this one for as long as the value is below zero.
bool bmr_condition_fails(const bmr_condition *condition, const bmr_instant *now, double tolerance);

#endif
