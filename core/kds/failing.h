// SPDX-License-Identifier: MIT
#ifndef BMR_KDS_FAILING_H
#define BMR_KDS_FAILING_H

#include "boomerang/kds.h"

/// A value above zero by less than this part of its magnitudes may be a failure that was found a little
/// early.
#define BMR_FAILING_PART 1e-10

/// d/dt of bmr_condition_value under the instant's rates. O(1).
double bmr_condition_rate(const bmr_condition *condition, const bmr_instant *now);

/// Has the condition failed at this instant? It has if it is not positive, or within `tolerance` and falling.
/// Growing from below zero is no excuse: where a motion turns round just after the failure, whoever looks for
/// failures finds this one as long as the condition is below zero.
bool bmr_condition_fails(const bmr_condition *condition, const bmr_instant *now, double tolerance);

#endif
