// SPDX-License-Identifier: MIT
#ifndef BMR_KINETIC_SAFE_STEPS_H
#define BMR_KINETIC_SAFE_STEPS_H

#include "boomerang/condition.h"
#include "kinetic/piece.h"

/// The first failure in [from, to], by steps over which a bound of the second derivative keeps the condition
/// positive, and GSL's Brent solver once two neighbouring looks have different signs. For any two pieces;
/// needed where a spinning screw takes part. `fresh`: `from` is where the caller begins, and a condition a
/// little below zero that is above it after a few tolerances is growing; else it follows on another piece.
/// INFINITY if there is none. A condition costs two sines and cosines a look; a root takes about ten looks,
/// and a whole turn some five more. Errors: NOT_FINITE (the motion overflows), OUT_OF_RANGE (more than
/// BMR_FAILURE_MAX_STEPS steps); then *time is untouched.
bmr_error bmr_safe_first_failure(const bmr_condition *condition, const bmr_motion_piece *owner,
                                 const bmr_motion_piece *other, double from, double to, bool fresh,
                                 double tolerance, double *time);

#endif
