// SPDX-License-Identifier: MIT
#include "outline/grid.h"

#include <math.h>

#include "geometry/predicates.h"

#define NONE BMR_OUTLINE_NONE

static uint32_t side_of(uint32_t points) {
    return (uint32_t)sqrt((double)points) + 1;
}

uint32_t bmr_grid_cells(uint32_t points) {
    return side_of(points) * side_of(points);
}

/// Rounding moves a point to a neighbouring cell at most, and never one point past another: whatever is
/// between two coordinates is in a cell between theirs.
static uint32_t cell_of(double x, double low, double size, uint32_t cells) {
    const double part = size > 0.0 ? (0.5 * x - low) / size : 0.0;
    const uint32_t cell = (uint32_t)(part * cells);
    return cell < cells ? cell : cells - 1;
}

void bmr_grid_make(bmr_grid *grid, const bmr_vec2 *points, uint32_t count, uint32_t *first, uint32_t *next) {
    bmr_vec2 low = points[0], high = points[0];
    for (uint32_t i = 1; i < count; ++i) {
        low = bmr_vec2_make(fmin(low.x, points[i].x), fmin(low.y, points[i].y));
        high = bmr_vec2_make(fmax(high.x, points[i].x), fmax(high.y, points[i].y));
    }
    low = bmr_scale(0.5, low);
    const bmr_vec2 size = bmr_sub(bmr_scale(0.5, high), low);
    const uint32_t side = side_of(count);
    *grid = (bmr_grid){points, low, size, side, side, first, next};
    for (uint32_t c = 0; c < side * side; ++c)
        first[c] = NONE;
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t cell = cell_of(points[i].y, low.y, size.y, side) * side +
                              cell_of(points[i].x, low.x, size.x, side);
        next[i] = first[cell];
        first[cell] = i;
    }
}

/// Is p in the closed triangle, whose corners turn by `turn`?
static bool holds(const bmr_vec2 corners[3], int turn, bmr_vec2 p) {
    for (int i = 0; i < 3; ++i)
        if (bmr_orientation(corners[i], corners[(i + 1) % 3], p) * turn < 0)
            return false;
    return true;
}

bool bmr_grid_blocks(const bmr_grid *grid, const bool *removed, uint32_t tip, uint32_t a, uint32_t b) {
    const bmr_vec2 *p = grid->points;
    const bmr_vec2 corners[3] = {p[tip], p[a], p[b]};
    const int turn = bmr_orientation(corners[0], corners[1], corners[2]);
    const bmr_vec2 low = {fmin(fmin(p[tip].x, p[a].x), p[b].x), fmin(fmin(p[tip].y, p[a].y), p[b].y)};
    const bmr_vec2 high = {fmax(fmax(p[tip].x, p[a].x), p[b].x), fmax(fmax(p[tip].y, p[a].y), p[b].y)};
    const uint32_t left = cell_of(low.x, grid->low.x, grid->size.x, grid->columns);
    const uint32_t right = cell_of(high.x, grid->low.x, grid->size.x, grid->columns);
    const uint32_t bottom = cell_of(low.y, grid->low.y, grid->size.y, grid->rows);
    const uint32_t top = cell_of(high.y, grid->low.y, grid->size.y, grid->rows);
    for (uint32_t row = bottom; row <= top; ++row)
        for (uint32_t column = left; column <= right; ++column)
            for (uint32_t q = grid->first[row * grid->columns + column]; q != NONE; q = grid->next[q]) {
                if (removed[q] || q == tip || bmr_sweep_compare(p[q], p[a]) == 0 ||
                    bmr_sweep_compare(p[q], p[b]) == 0)
                    continue;
                if (p[q].x >= low.x && p[q].x <= high.x && p[q].y >= low.y && p[q].y <= high.y &&
                    holds(corners, turn, p[q]))
                    return true;
            }
    return false;
}
