// SPDX-License-Identifier: MIT
#ifndef BMR_HIERARCHY_MIXED_CELLS_H
#define BMR_HIERARCHY_MIXED_CELLS_H

#include "boomerang/hierarchy.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// The mixed hierarchy of A (+) (-B) at a rotation of B (section 4 of the paper), in configuration space: the
/// point x is the position of B's frame in A's. The polygons overlap where x is in the sum.
///
/// Both hierarchies are interleaved. Stage s = 2 (l - 1) + X inserts the edges of level l of body X (0: A, 1:
/// B) into the sum M_s; M_0 is the sum of the two rectangles. Inserting e, between the edges L and R that it
/// finds there, cuts off the triangle that it cut off its own polygon, and pushes the chain of the other
/// body's edges between L and R inwards: each of those leaves a parallelogram. With a = L^e, c = L^R, b = e^R
/// the cells are
///   triangle (a, c, b) + v, v the other body's corner whose cone holds e;   certificate: edge e, corner v;
///   parallelogram [a, c] (+) y for each edge y of the other between L and e; certificate: edge y, corner a;
///   parallelogram [c, b] (+) y for each y between e and R;                   certificate: edge y, corner b.
/// All of them tile M_0 without the sum. Where two edges have the same direction, B's comes first.
///
/// Nothing is stored but the two hierarchies: a cell is a tuple of edges, and its neighbours follow from it.

/// The mixed hierarchy itself: plain data.
typedef struct bmr_mixed {
    const bmr_hierarchy *hierarchies[2]; ///< of A and of B
    double c, s;                         ///< rotation of B's frame in A's, unit length
    /// Every line of both is this far outwards (>= 0, length units): then the tiling is that of the outside
    /// of two larger polygons, each corner out by at most sqrt(2) times as much, and to be outside proves the
    /// pair twice the offset apart.
    double offset;
    /// Increased by the nodes of the hierarchies and the cells that all queries look at; NULL: not counted.
    unsigned *steps;
} bmr_mixed;
bmr_mixed bmr_mixed_make(const bmr_hierarchy *a, const bmr_hierarchy *b, double c, double s, double offset);

typedef enum bmr_mixed_kind {
    BMR_MIXED_TRIANGLE,
    BMR_MIXED_BEFORE,  ///< a parallelogram between L and e
    BMR_MIXED_AFTER,   ///< a parallelogram between e and R
    BMR_MIXED_OUTSIDE, ///< no cell: outside M_0
    BMR_MIXED_INSIDE   ///< no cell: in the sum
} bmr_mixed_kind;

/// A cell. `edge` is e, of body `owner`. Of the other body: a triangle's `other` are the edges next before
/// and next after e; a parallelogram's other[0] is y, and other[1] BMR_NO_EDGE. OUTSIDE: `edge` is an edge of
/// M_0 and `other` the other body's corner, the certificate; INSIDE: all BMR_NO_EDGE.
typedef struct bmr_mixed_cell {
    bmr_edge edge;
    bmr_edge other[2];
    uint8_t kind; ///< bmr_mixed_kind
    uint8_t owner;
    uint8_t reserved[2];
} bmr_mixed_cell;
bool bmr_mixed_same(const bmr_mixed_cell *a, const bmr_mixed_cell *b);
/// The stage that made the cell; -1 for OUTSIDE, INT32_MAX for INSIDE.
int32_t bmr_mixed_stage(const bmr_mixed *mixed, const bmr_mixed_cell *cell);

/// Where a side is: INNER is the certificate's line, OUTER the same line before e came; LOW and HIGH are the
/// other two in angular order (of a triangle: those on L and on R).
typedef enum bmr_mixed_role {
    BMR_MIXED_INNER,
    BMR_MIXED_OUTER,
    BMR_MIXED_LOW,
    BMR_MIXED_HIGH
} bmr_mixed_role;

#define BMR_MIXED_MAX_SIDES 4
/// The corners in counter-clockwise order; returns how many: 3 or 4, and 0 for OUTSIDE and INSIDE.
size_t bmr_mixed_polygon(const bmr_mixed *mixed, const bmr_mixed_cell *cell,
                         bmr_vec2 corners[BMR_MIXED_MAX_SIDES]);
/// What the cell needs of the rotation: edge `first` of body `owner` comes before edge `second` of the other.
typedef struct bmr_mixed_order {
    bmr_edge first, second;
    uint8_t owner;     ///< of `first`
    uint8_t page_turn; ///< 1: where they become parallel a page is turned; 0: the cell collapses
} bmr_mixed_order;
/// Both orders of a cell. (OUTSIDE: that its corner is extreme.) O(1). Not for INSIDE.
void bmr_mixed_orders(const bmr_mixed *mixed, const bmr_mixed_cell *cell, bmr_mixed_order orders[2]);
/// Do both hold at this rotation, so that the tuple is a cell of it? O(1).
bool bmr_mixed_exists(const bmr_mixed *mixed, const bmr_mixed_cell *cell);

/// A way through configuration space. On which side of it a corner of the tiling lies is decided by one sign
/// for all cells that share the corner: a walk cannot contradict itself, however thin a cell is.
typedef struct bmr_mixed_ray {
    bmr_vec2 origin, direction; ///< direction is not zero
} bmr_mixed_ray;

/// The cell on the other side of a side, where the ray crosses it outwards (Lemma onecell). Also OUTSIDE and
/// INSIDE. `touched` (may be NULL) is increased by the stages looked at. O(j), j the deepest level looked at.
bmr_mixed_cell bmr_mixed_next(const bmr_mixed *mixed, const bmr_mixed_cell *cell, bmr_mixed_role role,
                              const bmr_mixed_ray *ray, unsigned *touched);
/// The first cell of a ray that comes from far away: OUTSIDE if it misses M_0.
bmr_mixed_cell bmr_mixed_enter(const bmr_mixed *mixed, const bmr_mixed_ray *ray, unsigned *touched);
/// Walks from a point of `cell` straight to `to`. OUTSIDE and INSIDE where the way leaves M_0 or meets the
/// sum. False: lost by rounding, *cell is the last one met.
bool bmr_mixed_walk(const bmr_mixed *mixed, bmr_mixed_cell *cell, bmr_vec2 from, bmr_vec2 to,
                    unsigned *touched);
/// The edge of M_0 that x is farthest beyond, as an OUTSIDE cell; *slack is how far (negative: x is in M_0).
bmr_mixed_cell bmr_mixed_outside(const bmr_mixed *mixed, bmr_vec2 x, double *slack);
/// The cell that holds x, by a walk from outside against `direction` (not zero; best the one from A to B): as
/// many cells as that line crosses, each O(j). False: lost by rounding.
bool bmr_mixed_locate(const bmr_mixed *mixed, bmr_vec2 x, bmr_vec2 direction, bmr_mixed_cell *cell,
                      unsigned *touched);
/// The triangle of an edge of level >= 1, which exists at every rotation. O(level).
bmr_mixed_cell bmr_mixed_triangle(const bmr_mixed *mixed, int owner, bmr_edge edge);

/// All cells of one rotation, with their neighbours ("if we are willing to construct this polygon"): for
/// figures, counts and tests, and for translating pairs that have the memory.
typedef struct bmr_mixed_tiling bmr_mixed_tiling;
#define BMR_MIXED_NO_TILE UINT32_MAX
/// The rotation is that of `mixed`; the hierarchies must outlive it. One block of O((n + m) log) bytes.
/// O(size log size). Errors: NULL_ARGUMENT, NO_MEMORY.
bmr_error bmr_mixed_tiling_create(const bmr_mixed *mixed, const bmr_allocator *allocator,
                                  bmr_mixed_tiling **tiling);
void bmr_mixed_tiling_destroy(bmr_mixed_tiling *tiling, const bmr_allocator *allocator);
/// Tiles are 0 .. count-1, coarse before fine.
uint32_t bmr_mixed_tiling_count(const bmr_mixed_tiling *tiling);
const bmr_mixed_cell *bmr_mixed_tiling_cell(const bmr_mixed_tiling *tiling, uint32_t tile);
/// The tile of a cell; NO_TILE if there is none. O(log size).
uint32_t bmr_mixed_tiling_find(const bmr_mixed_tiling *tiling, const bmr_mixed_cell *cell);
/// The one tile across the side of that role, which is not INNER; NO_TILE outside M_0, or where the cell has
/// no such side. O(1).
uint32_t bmr_mixed_tiling_across(const bmr_mixed_tiling *tiling, uint32_t tile, bmr_mixed_role role);
/// The tiles along the inner side of a tile; along M_0 for tile = NO_TILE. In no order. O(1).
const uint32_t *bmr_mixed_tiling_below(const bmr_mixed_tiling *tiling, uint32_t tile, uint32_t *count);
/// bmr_mixed_walk by the neighbours stored: NO_TILE and *kind OUTSIDE or INSIDE where the way leaves M_0 or
/// meets the sum. `tile` NO_TILE: comes from outside. A step costs O(1), inwards O(tiles below). False: lost
/// by rounding.
bool bmr_mixed_tiling_walk(const bmr_mixed_tiling *tiling, uint32_t *tile, bmr_mixed_kind *kind,
                           bmr_vec2 from, bmr_vec2 to, unsigned *touched);

#ifdef __cplusplus
}
#endif
#endif
