// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_POLYGON_H
#define BOOMERANG_POLYGON_H

#include <stdbool.h>
#include <stdint.h>

#include "boomerang/allocator.h"
#include "boomerang/error.h"
#include "boomerang/pose.h"

#ifdef __cplusplus
extern "C" {
#endif

/// The most points that a polygon is made from, and so the most vertices it has.
#define BMR_MAX_VERTICES 65535u
/// The supported range. The magnitude of a coordinate is at most BMR_MAX_COORDINATE. If a polygon has more
/// than one point, the larger side of its bounding box is at least BMR_MIN_SIDE. Anything else is
/// BMR_ERROR_OUT_OF_RANGE.
#define BMR_MAX_COORDINATE 1e9
#define BMR_MIN_SIDE 1e-9

/// A convex polygon in the frame of its body. Read it; do not write it. The vertices are strictly convex and
/// counter-clockwise. Edge i runs from vertex i to vertex i+1 (mod count). One vertex is a point. Two are a
/// segment, whose edges 0 and 1 are its two sides. Everything lies in one block.
typedef struct bmr_polygon {
    const bmr_vec2 *vertices;
    uint32_t count;
    uint16_t lowest;  ///< index of the lowest vertex, of two the left one
    uint16_t highest; ///< index of the highest vertex, of two the right one
    bmr_vec2 center;  ///< centre of a bounding disk
    double radius;    ///< its radius, not smaller than the distance of any vertex from `center`
    double extent;    ///< largest |coordinate|: what rounding errors scale with
    /// Computed from the bits of the vertices, in order. Polygons of the same vertices have the same stamp,
    /// at any address; two others have the same stamp with a probability of 2^-32. A bmr_pair compares it to
    /// see whether it is asked about the same polygons, and a bmr_hierarchy to see whether a polygon is the
    /// one that it was built over.
    uint32_t stamp;
} bmr_polygon;

/// The convex hull of `points`, which come in any order. A point is dropped if and only if it equals another
/// or lies in the hull of the others (collinear points included). Exact predicates on the given coordinates
/// decide; there is no tolerance, so no vertex of the true hull is lost. The first vertex is the lowest
/// point, of these the leftmost. `allocator` NULL: malloc. O(n log n) time, one block of at most 16 bytes a
/// vertex and 64 more. Scratch of 32 bytes a point is allocated first and released before this returns.
/// Errors: NULL_ARGUMENT, NO_POINTS, TOO_MANY_POINTS, NOT_FINITE, OUT_OF_RANGE, NO_MEMORY; then *polygon is
/// untouched.
bmr_error bmr_polygon_create(const bmr_vec2 *points, size_t count, const bmr_allocator *allocator,
                             bmr_polygon **polygon);

/// The polygon with exactly these vertices in this order. The caller vouches that they are strictly convex
/// and counter-clockwise (bmr_polygon_audit checks it). Count, finiteness and range are still checked. O(n).
bmr_error bmr_polygon_create_raw(const bmr_vec2 *vertices, size_t count, const bmr_allocator *allocator,
                                 bmr_polygon **polygon);

/// Releases the block; `allocator` as at creation. NULL is no error.
void bmr_polygon_destroy(bmr_polygon *polygon, const bmr_allocator *allocator);

/// Bytes of the block of a polygon of `count` vertices. SIZE_MAX for more than BMR_MAX_VERTICES.
size_t bmr_polygon_bytes(size_t count);

/// Checks every promise of this header with exact predicates. OK, or NULL_ARGUMENT, NOT_CONVEX, NOT_FINITE,
/// OUT_OF_RANGE or INVALID_STRUCTURE. O(n).
bmr_error bmr_polygon_audit(const bmr_polygon *polygon);

/// Unit outer normal of edge i; (1, 0) for a point. O(1).
bmr_vec2 bmr_polygon_normal(const bmr_polygon *polygon, uint32_t edge);

/// Index of a vertex farthest in `direction` (of two: the first, counter-clockwise). Climbs from `hint` (any
/// value; taken modulo count): O(1) if the answer is near, O(n) at worst. For a zero or NaN direction it
/// returns the hint. Rounding: the true farthest vertex is farther by at most 1e-15 * extent * |direction|.
/// That holds for directions of length 1e-290 to 1e290. For others, whose products underflow or overflow, it
/// is some vertex.
uint32_t bmr_polygon_support_from(const bmr_polygon *polygon, bmr_vec2 direction, uint32_t hint);

/// The same without a hint, in O(log n), by bisection of the two chains between the lowest and the highest
/// vertex. A zero or NaN direction gives some vertex.
uint32_t bmr_polygon_support(const bmr_polygon *polygon, bmr_vec2 direction);

/// Is `point` inside, or at most `tolerance` (>= 0) beyond the line of every edge? Of a point or a segment:
/// at most `tolerance` from it. Tolerance 0 is exact and O(log n), by sectors around vertex 0. Any other is
/// O(n).
bool bmr_polygon_contains(const bmr_polygon *polygon, bmr_vec2 point, double tolerance);

#ifdef __cplusplus
}
#endif
#endif
