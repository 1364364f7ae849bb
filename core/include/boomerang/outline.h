// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_OUTLINE_H
#define BOOMERANG_OUTLINE_H

#include <stddef.h>
#include <stdint.h>

#include "boomerang/allocator.h"
#include "boomerang/error.h"
#include "boomerang/mass.h"
#include "boomerang/vector.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// Outlines that are not convex. A polygon with holes becomes a few convex pieces of any number of vertices
/// each. The paper's polygons are convex; this makes other bodies of them.
///
///     bmr_rings rings = {points, counts, ring_count};      // counts[0] points of the outer ring, then holes
///     bmr_outline_def def = bmr_default_outline_def();     // no tolerance: exactly the outline
///     bmr_outline_pieces *pieces;
///     bmr_outline_fault fault;
///     if (bmr_outline_decompose(&rings, &def, NULL, &pieces, &fault) != BMR_OK)
///         the outline is wrong: fault.edge[0] and fault.edge[1] say where
///     for (uint32_t p = 0; p < pieces->piece_count; ++p)
///         for (uint32_t e = pieces->first[p]; e < pieces->first[p + 1]; ++e)
///             corner pieces->points[pieces->edges[e].point]; pieces->edges[e].outline says what the edge is
///     bmr_outline_pieces_destroy(pieces, NULL);
///
/// Exact predicates on the given coordinates make all decisions. Any finite double is allowed: denormals,
/// 1e150 and 1e-150 in one outline. (A bmr_polygon that is made of a piece has a smaller range:
/// BMR_MAX_COORDINATE.) All functions are deterministic: the same rings give the same pieces, bit for bit.
///
/// Rings. Ring 0 is the outer one, all others are holes. Each runs clockwise or counter-clockwise, and is
/// closed. A point that repeats the one before it in its ring (at the ring's end also the first one) does not
/// count: of equal points in a row the one with the lowest index counts, and the others have no edge. Edge i
/// begins at point i of all points. It ends at the next point of its ring that counts, or at the ring's first
/// one. Allowed are
///
///   - any number of points on one straight line;
///   - rings that touch in points: a point of one ring on a point or inside an edge of another one, or of the
///   same one, as long as neither crosses to the other side there. The solid may hang together in such points
///   only.
///
/// Errors. Each names the two edges (bmr_outline_fault):
///
///   - BMR_ERROR_TOO_FEW_POINTS: a ring of fewer than three points that count;
///   - BMR_ERROR_CROSSING_EDGES: two edges cross, or two rings (or parts of one) in a point that they share;
///   - BMR_ERROR_OVERLAPPING_EDGES: two edges have more than a point in common: a spike that goes back over
///   itself, a ring of points on one line, a hole that shares a stretch with the outer ring, a ring given
///   twice;
///   - BMR_ERROR_HOLE_OUTSIDE: a hole is not inside the outer ring, or is inside another hole.

/// No edge, no piece.
#define BMR_OUTLINE_NONE UINT32_MAX

/// An outline, as the caller gives it. Functions read it and do not keep it.
typedef struct bmr_rings {
    const bmr_vec2 *points; ///< of all rings, one ring behind the other
    const uint32_t *counts; ///< how many points each ring has
    uint32_t ring_count;    ///< at least 1
} bmr_rings;

/// A fault of an outline. Of several faults it is the first: rings that are too short, in their order; then
/// the first that a sweep from left to right meets.
typedef struct bmr_outline_fault {
    bmr_error error; ///< BMR_OK: none of these faults
    /// The two edges, the lower number first. TOO_FEW_POINTS: twice the ring's first edge (BMR_OUTLINE_NONE
    /// if the ring has no point). HOLE_OUTSIDE: the edge of the hole that begins or ends at its leftmost
    /// point, and the edge below it there (BMR_OUTLINE_NONE if there is none).
    uint32_t edge[2];
    uint32_t ring[2]; ///< the rings of these edges
    /// A point of the first edge, near or at the fault: where the two edges meet, up to rounding.
    bmr_vec2 where;
} bmr_outline_fault;

/// Checks an outline. Writes its fault, or BMR_OK, to *fault (which may be NULL). At most BMR_MAX_VERTICES
/// points, all rings together. O(n log n), 180 bytes a point of scratch. Errors: those of the list above;
/// NULL_ARGUMENT, NO_POINTS (no ring), TOO_MANY_POINTS, NOT_FINITE, NO_MEMORY, with which *fault is
/// untouched.
bmr_error bmr_outline_check(const bmr_rings *rings, const bmr_allocator *allocator, bmr_outline_fault *fault);

/// Area, centroid and second moment of the solid: the mass of a body of this outline, independent of its
/// pieces. The caller vouches for the outline (bmr_outline_check). O(n), no scratch. Errors: NULL_ARGUMENT,
/// NO_POINTS; OUT_OF_RANGE if area or inertia, as far as doubles can tell, is not a positive number; then
/// *mass is untouched.
bmr_error bmr_outline_mass(const bmr_rings *rings, bmr_mass *mass);

/// Leaves points out. Writes to `kept` the indices of the points that remain, ring by ring and in their
/// order, and to `counts` how many each ring keeps: 0 for a hole that is filled, at least 3 for every other
/// ring. `kept` has room for all points, `counts` for all rings. The result is an outline again: nothing
/// crosses, overlaps or repeats that did not before (rings that touched may still touch).
///
/// Let S be the solid, T the simplified one. No point of S is farther than `tolerance` from T, and no point
/// of T farther from S: the Hausdorff distance of the two is at most the tolerance. The same holds of each
/// remaining ring and its simplification, as curves. A hole may be filled only if it lies between two
/// parallel lines 2 * tolerance apart. Tolerance 0 drops exactly the points within straight stretches and the
/// repeated ones.
///
/// Usually O(n log n), O(n^2) at worst. Errors: those of bmr_outline_check (*fault as there); NEGATIVE,
/// NOT_FINITE (the tolerance); then `kept` and `counts` are untouched.
bmr_error bmr_outline_simplify(const bmr_rings *rings, double tolerance, const bmr_allocator *allocator,
                               uint32_t *kept, uint32_t *counts, bmr_outline_fault *fault);

typedef struct bmr_outline_def {
    /// Length units. 0: the union of the pieces is exactly the solid. Above 0: it is the solid of the outline
    /// that bmr_outline_simplify leaves. So pieces stick out by the tolerance at most, and leave no more than
    /// that of the solid uncovered. Shallow notches and narrow holes are filled.
    double tolerance;
} bmr_outline_def;

static inline bmr_outline_def bmr_default_outline_def(void) {
    const bmr_outline_def def = {0.0};
    return def;
}

/// One edge of a piece. It runs from its point to the point of the piece's next edge (the last one to the
/// first one's), with the piece on its left.
typedef struct bmr_outline_edge {
    /// Index of the point at which it begins. If points of the outline coincide, always the first of them.
    uint32_t point;
    /// Of an outer edge: the edge of the outline on which it lies, in either direction. It is a part of that
    /// edge if rings touch inside of it. With a tolerance an edge may replace several neighbouring edges of a
    /// ring: then the first of these in the ring's direction. Of an inner edge: NONE.
    uint32_t outline;
    /// Of an inner edge: the edge of another piece that has the same two ends, in the opposite direction. Of
    /// an outer edge: NONE.
    uint32_t twin;
    uint32_t piece; ///< whose edge it is
} bmr_outline_edge;

/// The pieces of an outline. One block; read only.
///
/// Every piece is convex and counter-clockwise. Its interior is not empty, and no two interiors meet. Its
/// corners are points of the outline; none is added. A piece lists every point of the (simplified) outline on
/// its boundary, also one at which it goes straight on. So an edge is inner or outer as a whole, and inner
/// edges have twins. At least three corners of each piece are strict; bmr_polygon_create drops the others. A
/// piece may be as thin as the outline makes it: three neighbouring points that are nearly on a line can be a
/// piece of their own.
typedef struct bmr_outline_pieces {
    const bmr_vec2 *points; ///< a copy of those given, in their order
    uint32_t point_count;
    uint32_t piece_count;
    const uint32_t *first; ///< piece p has the edges first[p] .. first[p + 1] - 1, counter-clockwise
    const bmr_outline_edge *edges;
    uint32_t edge_count; ///< of all pieces: first[piece_count]
} bmr_outline_pieces;

/// Up to this many points (after the simplification) an outline without holes gets the fewest pieces of all
/// ways to cut it from corner to corner.
#define BMR_OUTLINE_OPTIMAL_POINTS 128u

/// Cuts an outline from corner to corner into few convex pieces. With r notches (corners at which the
/// solid takes more than half a turn) and h holes there are at most 2r + 1 - h pieces. (More only if the
/// solid hangs together in single points: as many for each part of it.) Without holes there are at most four
/// times as many as the fewest possible. Up to BMR_OUTLINE_OPTIMAL_POINTS points there are the fewest
/// possible (Keil and Snoeyink, "On the time bound for convex decomposition of simple polygons", 2002). In
/// larger outlines, groups of neighbouring pieces that together are small enough are cut anew in that way.
///
/// `def` NULL: the defaults. `fault` may be NULL. O(n log n), and for each group of pieces a time that does
/// not grow with n. Half a megabyte of scratch, and 500 bytes a point; only the result's block stays. Errors:
/// those of bmr_outline_check and bmr_outline_simplify; then *pieces is untouched.
bmr_error bmr_outline_decompose(const bmr_rings *rings, const bmr_outline_def *def,
                                const bmr_allocator *allocator, bmr_outline_pieces **pieces,
                                bmr_outline_fault *fault);

/// Releases the block; `allocator` as at creation. NULL is no error.
void bmr_outline_pieces_destroy(bmr_outline_pieces *pieces, const bmr_allocator *allocator);

/// Checks every promise that can be seen from the pieces alone, with exact predicates: convex, not empty,
/// indices in range, twins that match. OK, or NULL_ARGUMENT, NOT_CONVEX or INVALID_STRUCTURE. O(n).
bmr_error bmr_outline_pieces_audit(const bmr_outline_pieces *pieces);

#ifdef __cplusplus
}
#endif
#endif
