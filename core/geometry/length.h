// SPDX-License-Identifier: MIT
#ifndef BMR_GEOMETRY_LENGTH_H
#define BMR_GEOMETRY_LENGTH_H

#include <math.h>

#include "boomerang/vector.h"

/// The length of a vector, good to a rounding, also where its square is no double. (hypot takes care of that
/// always, in some fifty instructions; and sqrt is the same on every machine.)
static inline double bmr_length(bmr_vec2 v) {
    const double square = v.x * v.x + v.y * v.y;
    return square > 0x1p-960 && square < 0x1p1020 ? sqrt(square) : hypot(v.x, v.y);
}

#endif
