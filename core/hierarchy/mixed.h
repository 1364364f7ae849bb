// SPDX-License-Identifier: MIT
#ifndef BMR_HIERARCHY_MIXED_H
#define BMR_HIERARCHY_MIXED_H

#include "hierarchy/mixed_cells.h"

/// @file
/// What the files of the mixed hierarchy share. Directions and points here are in A's frame; those of body 1
/// are those of -B.

/// Does edge f of body X come before edge g of the other, the two being less than 180 degrees apart? B first
/// in a tie.
bool bmr_mixed_precedes(const bmr_mixed *mixed, int body, bmr_edge f, bmr_edge g);
/// The corner of body `body`'s envelope of `level` whose cone holds edge `edge` of the other body. O(level).
bmr_corner bmr_mixed_around(const bmr_mixed *mixed, int body, bmr_edge edge, uint32_t level);
/// The point of a corner of one body plus that of a corner of the other: the same bits whoever asks.
bmr_vec2 bmr_mixed_sum(const bmr_mixed *mixed, int body, bmr_edge before, bmr_edge after,
                       bmr_edge other_before, bmr_edge other_after);
/// A body's vector in A's frame, -B's for B.
static inline bmr_vec2 bmr_mixed_into_a(const bmr_mixed *mixed, int body, bmr_vec2 v) {
    if (body == 0)
        return v;
    return bmr_vec2_make(mixed->s * v.y - mixed->c * v.x, -(mixed->s * v.x + mixed->c * v.y));
}

static inline void bmr_mixed_count(const bmr_mixed *mixed, unsigned steps) {
    if (mixed->steps)
        *mixed->steps += steps;
}

/// The level of a body in M_s.
static inline uint32_t bmr_mixed_level(int body, int32_t stage) {
    return (uint32_t)(stage + 1 - body) / 2u;
}

/// Is the point to the left of the ray?
static inline bool bmr_mixed_left(const bmr_mixed_ray *ray, bmr_vec2 point) {
    return bmr_cross(ray->direction, bmr_sub(point, ray->origin)) > 0.0;
}

bmr_mixed_cell bmr_mixed_cell_make(bmr_mixed_kind kind, int owner, bmr_edge edge, bmr_edge first,
                                   bmr_edge second);
/// A side as the cell's kind knows it: on line `line` of body `of` (0: the cell's owner, 1: the other), with
/// corner `corner` of the other one of the two.
typedef struct bmr_mixed_part {
    uint8_t role, of, line, corner;
    int8_t beyond; ///< as in bmr_mixed_side
} bmr_mixed_part;

/// All that a cell's sides are made of, each line and corner computed once. Of the owner: the edges L, e, R
/// and the corners a, c, b. Of the other body: those before, y, after, and the low and the high corner of y;
/// of a triangle those before and after (0 and 2), and the corner v (0). In the bodies' own frames, with the
/// offset; what the kind has no use for is not set.
typedef struct bmr_mixed_figure {
    const bmr_mixed_part *parts;
    size_t sides;
    bmr_edge edges[2][3];
    bmr_line lines[2][3];
    bmr_vec2 corners[2][3];
    int owner;
} bmr_mixed_figure;
/// Not for INSIDE. O(level) for a parallelogram, else O(1).
void bmr_mixed_draw(const bmr_mixed *mixed, const bmr_mixed_cell *cell, bmr_mixed_figure *figure);
/// bmr_mixed_side_value of side i.
double bmr_mixed_figure_value(const bmr_mixed *mixed, const bmr_mixed_figure *figure, size_t i, bmr_vec2 x);
/// bmr_mixed_polygon.
void bmr_mixed_figure_polygon(const bmr_mixed *mixed, const bmr_mixed_cell *cell,
                              const bmr_mixed_figure *figure, bmr_vec2 corners[BMR_MIXED_MAX_SIDES]);
/// Does the cell exist at this rotation, and hold x?
bool bmr_mixed_holds(const bmr_mixed *mixed, const bmr_mixed_cell *cell, bmr_vec2 x);

/// The cell inside of an edge g of body `body` with the other's corner w, both of M_s, where the ray crosses
/// it inwards.
bmr_mixed_cell bmr_mixed_down(const bmr_mixed *mixed, int body, bmr_edge g, const bmr_edge w[2],
                              int32_t stage, const bmr_mixed_ray *ray, unsigned *touched);

/// The side through which the ray leaves a cell: the one that starts on the ray's right and ends on its left.
/// The number of sides if the ray misses the cell.
size_t bmr_mixed_exit(const bmr_mixed *mixed, const bmr_mixed_cell *cell, const bmr_mixed_figure *figure,
                      const bmr_mixed_ray *ray);

/// One of the eight edges of M_0, with its ends.
typedef struct bmr_mixed_top {
    bmr_edge edge, corner[2];
    int owner;
    bmr_vec2 start, end;
} bmr_mixed_top;
#define BMR_MIXED_TOPS 8u
/// Fills in the edges of A, then those of B.
void bmr_mixed_tops(const bmr_mixed *mixed, bmr_mixed_top tops[BMR_MIXED_TOPS]);

/// More steps than a straight walk can take: each cell is convex and met once. A cell has an edge of its own
/// and one of the other body's.
static inline uint32_t bmr_mixed_most_steps(const bmr_mixed *mixed) {
    return 64u + 8u * (bmr_hierarchy_edge_count(mixed->hierarchies[0]) +
                       bmr_hierarchy_edge_count(mixed->hierarchies[1]));
}

// ---- a tiling in a block of the caller's ----

/// Bytes that are enough for the two hierarchies' tiling at any rotation. O(n + m).
size_t bmr_mixed_tiling_most_bytes(const bmr_hierarchy *a, const bmr_hierarchy *b);
/// Builds the tiling of `mixed` in a block of that many bytes, aligned for any type.
void bmr_mixed_tiling_build(bmr_mixed_tiling *tiling, const bmr_mixed *mixed, size_t bytes);

#endif
