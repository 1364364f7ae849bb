// SPDX-License-Identifier: MIT
#ifndef BMR_GEOMETRY_POLYGON_QUERY_H
#define BMR_GEOMETRY_POLYGON_QUERY_H

#include "boomerang/polygon.h"

#ifdef __cplusplus
extern "C" {
#endif

/// `steps` below: increased by one for every vertex or edge that is looked at. That is the one unit in which
/// the library counts what a search costs.

/// As bmr_polygon_support and bmr_polygon_support_from.
uint32_t bmr_support_counted(const bmr_polygon *polygon, bmr_vec2 direction, unsigned *steps);
uint32_t bmr_support_from_counted(const bmr_polygon *polygon, bmr_vec2 direction, uint32_t hint,
                                  unsigned *steps);

/// The vertex that follows another counter-clockwise, and the one that precedes it.
static inline uint32_t bmr_vertex_after(const bmr_polygon *p, uint32_t i) {
    return i + 1 < p->count ? i + 1 : 0;
}
static inline uint32_t bmr_vertex_before(const bmr_polygon *p, uint32_t i) {
    return i > 0 ? i - 1 : p->count - 1;
}

/// Along edge i, from its vertex to the next.
static inline bmr_vec2 bmr_edge_vector(const bmr_polygon *p, uint32_t i) {
    return bmr_sub(p->vertices[bmr_vertex_after(p, i)], p->vertices[i]);
}

#ifdef __cplusplus
}
#endif
#endif
