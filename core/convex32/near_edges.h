// SPDX-License-Identifier: MIT
#ifndef BMR_CONVEX32_NEAR_EDGES_H
#define BMR_CONVEX32_NEAR_EDGES_H

#include "convex32/directions.h"

/// @file
/// The edges whose lines a point is near to, or outside of, without looking at all edges.
///
/// Edges are taken in four sectors by their normals: within 45 degrees of +x, +y, -x, -y. Seen along the
/// sector's axis, the point's depth below the lines of one sector rises up to the edge that the axis through
/// the point hits, and falls behind it; and an edge's separation is that depth times a cosine between 0.707
/// and 1. So the edges of a sector with a separation above some bound lie side by side around the edge hit,
/// which halving finds.

enum { CONVEX32_SECTORS = 4 };

/// Edges first, first + 1, ... in cyclic order.
typedef struct edge_range {
    uint32_t first, count;
} edge_range;

/// The edges of a sector: 0, +x; 1, +y; 2, -x; 3, -y. A polygon with a table.
static inline edge_range sector_edges(const bmr_convex32 *p, uint32_t sector) {
    const uint32_t eighth = 1u << (p->bucket_bits - 3);
    const uint32_t first = p->buckets[eighth * (2 * sector + 1)];
    const uint32_t last = p->buckets[(eighth * (2 * sector + 3)) & (8 * eighth - 1)];
    const edge_range range = {first, last >= first ? last - first : last + p->count - first};
    return range;
}

static inline uint32_t convex32_wrap(const bmr_convex32 *p, uint32_t i) {
    return i < p->count ? i : i - p->count;
}

/// How far a vertex lies along the sector's edges: strictly rising from each to the next.
static inline float sector_key(bmr_vec32 v, uint32_t sector) {
    const float key = (sector & 1u) != 0 ? v.x : v.y;
    return sector == 1 || sector == 2 ? -key : key;
}

/// Of a sector that is not empty, the edge that the axis through the point hits, or the end nearer to it.
static inline uint32_t sector_hit(const bmr_convex32 *p, edge_range edges, uint32_t sector, bmr_vec32 point) {
    const float key = sector_key(point, sector);
    uint32_t low = 0, high = edges.count - 1;
    while (low < high) {
        const uint32_t middle = (low + high + 1) / 2;
        if (sector_key(p->vertices[convex32_wrap(p, edges.first + middle)], sector) <= key)
            low = middle;
        else
            high = middle - 1;
    }
    return low;
}

/// In Box2D's order of operations.
static inline float edge_separation(const bmr_convex32 *p, uint32_t edge, bmr_vec32 point) {
    const bmr_vec32 n = p->normals[edge], v = p->vertices[edge];
    return n.x * (point.x - v.x) + n.y * (point.y - v.y);
}

/// The edges of the sector around `hit` with a float separation above -margin, and perhaps more.
static inline edge_range around(const bmr_convex32 *p, edge_range edges, uint32_t hit, bmr_vec32 point,
                                float margin) {
    uint32_t low = hit, high = hit + 1;
    while (low > 0 && edge_separation(p, convex32_wrap(p, edges.first + low - 1), point) > -1.5f * margin)
        --low;
    while (high < edges.count &&
           edge_separation(p, convex32_wrap(p, edges.first + high), point) > -1.5f * margin)
        ++high;
    const edge_range range = {convex32_wrap(p, edges.first + low), high - low};
    return range;
}

/// |x| + |y| of all that goes into a separation.
static inline float separation_size(const bmr_convex32 *p, bmr_vec32 point) {
    return convex32_size(point) + convex32_size(p->extent);
}

/// A separation is wrong by less than 5 * 2^-24 of the size: differences, products and the sum by one part in
/// 2^24 each, the normal's rounding. Below minus this much no edge farther from the one hit comes out above
/// zero: (1 + 1.415) times the error, and more than that, see `around`.
#define CONVEX32_SEPARATION_NOISE 0x1p-20f

#endif
