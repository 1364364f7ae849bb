// SPDX-License-Identifier: MIT
#ifndef BMR_HIERARCHY_MIXED_H
#define BMR_HIERARCHY_MIXED_H

#include "hierarchy/mixed_cells.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// What the files of the mixed hierarchy share. Directions and points here are in A's frame; those of body 1
/// are those of -B.

/// Does edge f of body X come before edge g of the other, the two being less than 180 degrees apart? B first
/// in a tie.
bool bmr_mixed_precedes(const bmr_mixed *mixed, int body, bmr_edge f, bmr_edge g);
/// The corner of body `body`'s envelope of `level` whose cone holds edge `edge` of the other body. O(level).
bmr_corner bmr_mixed_around(const bmr_mixed *mixed, int body, bmr_edge edge, uint32_t level);

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
    int8_t beyond; ///< 1: the cell is beyond the line as seen from the line's body; -1: on that body's side
} bmr_mixed_part;

/// All that a cell's sides are made of, each line and corner computed once. Of the owner: the edges L, e, R
/// and the corners a, c, b. Of the other body: those before, y, after, and the low and the high corner of y;
/// of a triangle those before and after (0 and 2), and the corner v (2). In the bodies' own frames, with the
/// offset; what the kind has no use for is not set.
typedef struct bmr_mixed_figure {
    const bmr_mixed_part *parts;
    size_t sides;
    bmr_edge edges[2][3];
    bmr_line lines[2][3];
    bmr_vec2 corners[2][3];
    int owner;
} bmr_mixed_figure;
/// Not for INSIDE. OUTSIDE has one side, its certificate. O(level) for a parallelogram, else O(1).
void bmr_mixed_draw(const bmr_mixed *mixed, const bmr_mixed_cell *cell, bmr_mixed_figure *figure);
/// How far x is on the cell's side of side i's line (length units; negative: not).
double bmr_mixed_figure_value(const bmr_mixed *mixed, const bmr_mixed_figure *figure, size_t i, bmr_vec2 x);
/// bmr_mixed_polygon: side i goes from corner i to corner i + 1.
void bmr_mixed_figure_polygon(const bmr_mixed *mixed, const bmr_mixed_cell *cell,
                              const bmr_mixed_figure *figure, bmr_vec2 corners[BMR_MIXED_MAX_SIDES]);
/// Does the cell exist at this rotation, and hold x?
bool bmr_mixed_holds(const bmr_mixed *mixed, const bmr_mixed_cell *cell, bmr_vec2 x);

/// The side through which the ray leaves a cell: the one that starts on the ray's right and ends on its left.
/// The number of sides if the ray misses the cell.
size_t bmr_mixed_exit(const bmr_mixed *mixed, const bmr_mixed_cell *cell, const bmr_mixed_figure *figure,
                      const bmr_mixed_ray *ray);

// ---- a tiling in a block of the caller's ----

/// Bytes that are enough for the two hierarchies' tiling at any rotation. O(n + m).
size_t bmr_mixed_tiling_most_bytes(const bmr_hierarchy *a, const bmr_hierarchy *b);
/// Builds the tiling of `mixed` in a block of that many bytes, aligned for any type.
void bmr_mixed_tiling_build(bmr_mixed_tiling *tiling, const bmr_mixed *mixed, size_t bytes);

#ifdef __cplusplus
}
#endif
#endif
