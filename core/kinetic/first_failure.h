// SPDX-License-Identifier: MIT
#ifndef BMR_KINETIC_FIRST_FAILURE_H
#define BMR_KINETIC_FIRST_FAILURE_H

#include "boomerang/failure.h"
#include "kinetic/pair_motion.h"

/// The first failure of any of `count` conditions in (from, to], and which one fails; INFINITY: none, and
/// *failing is as it was. Errors: those of bmr_failure_time.
bmr_error bmr_first_failure(const bmr_condition *conditions, size_t count, const bmr_motion *a,
                            const bmr_motion *b, double from, double to, const bmr_failure_options *options,
                            double *time, size_t *failing);

/// From where a failing condition is no longer positive, at or a little after `time`: its failure is reported
/// up to a tolerance (here: absolute) early, and structures take a positive condition for a call that comes
/// too early. No look after the second is farther from `time` than `longest`.
double bmr_repair_time(const bmr_pair_motion *motion, const bmr_condition *condition, double time,
                       double tolerance, double longest);

#endif
