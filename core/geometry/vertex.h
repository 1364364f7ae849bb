// SPDX-License-Identifier: MIT
#ifndef BMR_GEOMETRY_VERTEX_H
#define BMR_GEOMETRY_VERTEX_H

#include "boomerang/polygon.h"

/// The vertex that follows another counter-clockwise, and the one that precedes it.
static inline uint32_t bmr_vertex_after(const bmr_polygon *p, uint32_t i) {
    return i + 1 < p->count ? i + 1 : 0;
}
static inline uint32_t bmr_vertex_before(const bmr_polygon *p, uint32_t i) {
    return i > 0 ? i - 1 : p->count - 1;
}

#endif
