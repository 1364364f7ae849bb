// SPDX-License-Identifier: MIT
#ifndef BMR_OUTLINE_GRID_H
#define BMR_OUTLINE_GRID_H

#include "outline/rings.h"

/// The points of an outline in cells over their bounding box, about one a cell, to find those in a triangle.
typedef struct bmr_grid {
    const bmr_vec2 *points;
    bmr_vec2 low, size; ///< halved, so that no difference of two coordinates overflows
    uint32_t columns, rows;
    uint32_t *first; ///< point of each cell; NONE: it is empty
    uint32_t *next;  ///< of each point in its cell
} bmr_grid;

/// How many cells there are for so many points.
uint32_t bmr_grid_cells(uint32_t points);

/// Into arrays of the caller's: bmr_grid_cells(count) and `count` numbers.
void bmr_grid_make(bmr_grid *grid, const bmr_vec2 *points, uint32_t count, uint32_t *first, uint32_t *next);

/// Is a point in the closed triangle that is not `removed` and lies in none of its three corners' places, or
/// in that of `tip` without being it? (The triangle's corners are points tip, a and b.)
bool bmr_grid_blocks(const bmr_grid *grid, const bool *removed, uint32_t tip, uint32_t a, uint32_t b);

#endif
