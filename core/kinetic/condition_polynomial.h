// SPDX-License-Identifier: MIT
#ifndef BMR_KINETIC_CONDITION_POLYNOMIAL_H
#define BMR_KINETIC_CONDITION_POLYNOMIAL_H

#include "boomerang/condition.h"
#include "kinetic/first_root.h"
#include "kinetic/piece.h"

/// A polynomial in u, from 0 to 1 over an interval of time, that has the sign of a condition there.
typedef struct bmr_condition_polynomial {
    double c[BMR_POLYNOMIAL_MAX_DEGREE + 1];
    size_t degree;
    double width; ///< of the interval that 0 to 1 stands for
    double noise; ///< bound of the rounding error of its values on [0, 1]
} bmr_condition_polynomial;

/// The condition under two algebraic pieces on [from, from + width], width <= longest > 0 chosen such that
/// the polynomial's coefficients say no more than what happens there: in powers around a far origin, or on
/// too long an interval, the digits of the near values are lost. The condition is multiplied by the two
/// denominators (a^2 + b^2), which are positive, and DISKS is squared. (Its offset must be positive.) With
/// position of degree d and rotations of degrees r and q: BEYOND has degree d + 2r + 2q, TURN 2r + 2q, DISKS
/// 2d + 2r + 2q; at most 48.
void bmr_condition_expand(const bmr_condition *condition, const bmr_motion_piece *owner,
                          const bmr_motion_piece *other, double from, double longest,
                          bmr_condition_polynomial *polynomial);

#endif
