// SPDX-License-Identifier: MIT
#ifndef BMR_GEOMETRY_TINY_H
#define BMR_GEOMETRY_TINY_H

#include <math.h>

#include "boomerang/vector.h"

/// Below this, products with it may lose bits to underflow, of two even their sign.
#define BMR_TINY 1e-140
#define BMR_TINY_SCALE 0x1p600

/// The same direction, long enough for products. Scaling by a power of two is exact and changes no sign.
static inline bmr_vec2 bmr_scale_up_if_tiny(bmr_vec2 d) {
    return fabs(d.x) < BMR_TINY && fabs(d.y) < BMR_TINY ? bmr_scale(BMR_TINY_SCALE, d) : d;
}

#endif
