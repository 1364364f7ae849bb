// SPDX-License-Identifier: MIT
#ifndef BMR_CONVEX32_CONVEX32_H
#define BMR_CONVEX32_CONVEX32_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "boomerang/allocator.h"
#include "boomerang/error.h"
#include "exact32/exact32.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// For the Box2D plugin alone; not a public header.
///
/// Convex polygons of any size in float, as a game engine keeps its shapes: what exact32.h is for 8 vertices,
/// in time that hardly grows with their number. How two of them touch: convex32_collide.h; how far apart they
/// are, and when they meet: convex32_distance.h.

/// Most vertices of a polygon: their numbers fit 16 bits.
#define BMR_CONVEX32_MOST 65535u

/// A part of an edge of a piece: behind it one other piece goes on (`inner`), or none. It ends where the next
/// one of the edge begins, and the last one where the edge does.
typedef struct bmr_edge_part32 {
    bmr_vec32 from;
    uint32_t edge;
    bool inner;
} bmr_edge_part32;

/// What a piece of an outline knows of its neighbours: convex32_pieces.h.
typedef struct bmr_seams32 {
    const bmr_vec32 *low,
        *high; ///< of each vertex: the outline turns there from `low`, counter-clockwise, to `high`
    const uint8_t *inner;         ///< of each edge: 1 where another piece goes on behind all of it, else 0
    const bmr_edge_part32 *parts; ///< of the edges that have several, at least one of them inner; in order
    uint32_t part_count;
} bmr_seams32;

/// A convex polygon, counter-clockwise, and a table that starts the search for its extreme vertices. A view:
/// it owns nothing and may be copied. Never written once made, so any number of threads may read it.
typedef struct bmr_convex32 {
    const bmr_vec32 *vertices;
    const bmr_vec32 *normals; ///< unit length, outward; normals[i] belongs to the edge from vertex i to i+1
    /// For each of 2^bucket_bits buckets of directions by pseudo-angle, a vertex at which to start; NULL for
    /// a polygon of at most 8 vertices (all are looked at).
    const uint16_t *buckets;
    uint32_t count; ///< 3 to BMR_CONVEX32_MOST
    uint32_t bucket_bits;
    bmr_vec32 extent;         ///< the largest |x| and |y| of a vertex; used with a table alone
    const bmr_seams32 *seams; ///< of a piece of an outline that has inner edges; else NULL
} bmr_convex32;

/// Area, centroid and inertia of a polygon at a density of one. Right to 1e-7, however thin the polygon, on a
/// thread that rounds to nearest.
typedef struct bmr_mass32 {
    float area;
    bmr_vec32 centroid;
    float inertia; ///< about the centroid
} bmr_mass32;

/// A polygon with the memory it lives in: one block, at most 40 bytes a vertex; of a piece of
/// an outline at most 60, and 16 for each part of an edge.
typedef struct bmr_convex32_block {
    bmr_convex32 polygon;
    bmr_mass32 mass;
    float reach;       ///< no vertex is farther from the origin
    uint32_t repeated; ///< how many of the points that it is the hull of equal another one
    size_t bytes;      ///< of the whole block
    bmr_seams32 seams; ///< of a piece of an outline; all zero of any other polygon
} bmr_convex32_block;

/// The convex hull of `count` points, counter-clockwise from the rightmost one (of these the lowest). Dropped
/// are, besides what lies inside, vertices that turn so little (at most about 1e-7) that the unit normals of
/// their two edges round to the same floats: kept normals all differ, and turn once around. Coordinates are
/// at most BMR_MAX_COORDINATE, the larger side of the bounding box at least BMR_MIN_SIDE (polygon.h).
///
/// Errors leave `*block` as it was: BMR_ERROR_TOO_FEW_POINTS, also for a hull without area as far as floats
/// can tell (a needle whose long sides have opposite normals), BMR_ERROR_NOT_FINITE, BMR_ERROR_OUT_OF_RANGE,
/// BMR_ERROR_TOO_MANY_POINTS (on the hull; or given, where the 32 bytes that each takes for the
/// time of the call have no addresses), BMR_ERROR_NO_MEMORY. O(n log n).
bmr_error bmr_convex32_create(const bmr_vec32 *points, size_t count, const bmr_allocator *allocator,
                              bmr_convex32_block **block);
/// The polygon of vertices that are a hull already, counter-clockwise from any one: they are kept to the bit.
/// BMR_ERROR_NOT_CONVEX where they are not convex in exact arithmetic, and where the normals of two edges
/// round to the same or to opposite vectors (a needle). O(n).
bmr_error bmr_convex32_create_raw(const bmr_vec32 *vertices, size_t count, const bmr_allocator *allocator,
                                  bmr_convex32_block **block);
void bmr_convex32_destroy(bmr_convex32_block *block, const bmr_allocator *allocator);
/// Bytes of a block of so many vertices: 16 a vertex and, past 8, 4 to 8 for the table. SIZE_MAX for more
/// than BMR_CONVEX32_MOST, for which there is none.
size_t bmr_convex32_bytes(size_t count);
/// A polygon of Box2D's own size, with its own arrays; no table.
static inline bmr_convex32 bmr_convex32_small(const bmr_polygon32 *polygon) {
    const bmr_convex32 view = {
        polygon->vertices, polygon->normals, NULL, (uint32_t)polygon->count, 0, {0.0f, 0.0f}, NULL};
    return view;
}

/// The vertex of largest dot product with the direction, in float, (x * dx) + (y * dy): as a loop over all of
/// them, rounding included, finds it; of equal ones any. Vertex 0 where the direction is zero or not a
/// number. O(log n), O(1) where the edges are of about one length; besides, it looks at all vertices whose
/// products are too close to tell apart, and at every vertex where products overflow.
uint32_t bmr_convex32_support(const bmr_convex32 *polygon, bmr_vec32 direction);
/// The same vertex as bmr_convex32_support finds, by a walk from `hint`: best a vertex that was the answer
/// not long ago. O(steps) where the answer is near, else a few steps more than bmr_convex32_support. Any hint
/// is allowed.
uint32_t bmr_convex32_support_from(const bmr_convex32 *polygon, bmr_vec32 direction, uint32_t hint);

/// Is the point (in the polygon's frame) inside or on it, in Box2D's sense: outside no edge's line? O(n).
bool bmr_convex32_contains(const bmr_convex32 *polygon, bmr_vec32 point);

/// The first edge that the segment from p1 to p1 + fraction (p2 - p1), fraction <= max_fraction, enters, in
/// Box2D's sense (a segment that begins inside enters nothing). Polygon's frame. O(n).
bool bmr_convex32_ray(const bmr_convex32 *polygon, bmr_vec32 p1, bmr_vec32 p2, float max_fraction,
                      float *fraction, uint32_t *edge);

/// The box of the vertices at a pose, in float: the extremes over all of them, to the bit. O(log n).
void bmr_convex32_box(const bmr_convex32 *polygon, const bmr_transform32 *pose, bmr_vec32 *lower,
                      bmr_vec32 *upper);

/// `count` vertices (3 to 8, and no more than there are) of the polygon: the polygon inside it that stands
/// for it where no more can be said. Those that are extreme in evenly spread directions and, where one is so
/// in several, the farthest from those taken. Writes their numbers, ascending, all different. O(n).
void bmr_convex32_inner(const bmr_convex32 *polygon, uint32_t *vertices, uint32_t count);

/// Few vertices, whose polygon lies within `tolerance` (Hausdorff distance) of the given one: some of the
/// given ones, at least 3, in order. It is bmr_outline_simplify (outline.h) of the vertices. None of those
/// that are left can be left out, too. `points` has room for polygon->count; errors leave the outputs as they
/// were: BMR_ERROR_NULL_ARGUMENT, BMR_ERROR_NOT_FINITE and BMR_ERROR_NEGATIVE of a tolerance that is NaN or
/// negative, BMR_ERROR_NO_MEMORY. O(n log n) where the edges are of about one length.
bmr_error bmr_convex32_simplify(const bmr_convex32 *polygon, float tolerance, const bmr_allocator *allocator,
                                bmr_vec32 *points, size_t *count);

#ifdef __cplusplus
}
#endif
#endif
