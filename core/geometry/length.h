// SPDX-License-Identifier: MIT
#ifndef BMR_GEOMETRY_LENGTH_H
#define BMR_GEOMETRY_LENGTH_H

#include <math.h>

#include "boomerang/vector.h"

/// The length of a vector, also where its square is no double.
static inline double bmr_length(bmr_vec2 v) {
    return hypot(v.x, v.y);
}

#endif
