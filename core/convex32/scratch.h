// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_CONVEX32_SCRATCH_H
#define BOOMERANG_CONVEX32_SCRATCH_H

#include "boomerang/vector.h"
#include "geometry/size.h"

/// Bytes for `count` points in double, and for a hull of them that ends where it began. False where that is
/// more than `limit`.
static inline bool bmr_convex32_scratch(size_t count, size_t limit, size_t *bytes) {
    size_t size = 0, begin;
    if (!bmr_size_add(&size, count, 2 * sizeof(bmr_vec2), 1, limit, &begin) ||
        !bmr_size_add(&size, 1, sizeof(bmr_vec2), 1, limit, &begin))
        return false;
    *bytes = size;
    return true;
}

#endif
