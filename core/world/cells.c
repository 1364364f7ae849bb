// SPDX-License-Identifier: MIT
// Nested grids over the whole plane, or around a periodic box. The lines of a grid are lines of all finer
// ones, so that the cells above a body's cell change only where the cell does.
//
// Why neighbours are enough. Let a and b live on levels of cells h_a <= h_b, and call w = h/16 the
// hysteresis. If the cells of both on b's level are no neighbours, there is a whole cell between them, and
// the centres are more than h_b - w_a - w_b >= 7/8 h_b apart. Both radii are at most (h_b - 32 margin) / 2.5,
// so the sum of both with two margins is below 0.8 h_b - 23 margin, and the reach at which disks meet, 65/64
// of that and rounding (deadline.c), below 0.82 h_b. (A body that is beyond its cell and the hysteresis by
// h/64, because no time lies between, is an error: body.c.)
#include <math.h>
#include <string.h>

#include "geometry/memory.h"
#include "world/parts.h"

/// A cell is at least so many radii, and margins, wide: see above.
#define CELL_RADII 2.5
#define CELL_MARGINS 32.0
/// .. and this part of its distance from the origin, so that positions and columns are told apart exactly.
#define CELL_PART 0x1p-30

#define LEAST_TABLE 64

/// Of a periodic box, which has less than 2^22 cells of level 0 around: below this level their number would
/// be no int64_t.
#define LEAST_AROUND_LEVEL (-40)

bmr_vec2 bmr_cell_size(const bmr_world *w, int level) {
    return bmr_vec2_make(ldexp(w->unit_x, level), ldexp(w->unit_y, level));
}

static bmr_vec2 grid_origin(const bmr_world *w) {
    return w->def.boundary == BMR_PERIODIC ? w->def.low : bmr_vec2_make(0.0, 0.0);
}

double bmr_grid_need(const bmr_world *w, double radius) {
    return CELL_RADII * radius + CELL_MARGINS * w->def.kds.margin;
}

bmr_error bmr_grid_level(const bmr_world *w, double radius, bmr_vec2 position, int *level) {
    const double place = CELL_PART * fmax(fabs(position.x), fabs(position.y));
    const double cells = fmax(bmr_grid_need(w, radius), place) / fmin(w->unit_x, w->unit_y);
    // (fmax passes a NaN over, where it has another number.)
    if (!isfinite(position.x) || !isfinite(position.y) || !isfinite(cells))
        return BMR_ERROR_NOT_FINITE;
    int exponent = BMR_LEAST_LEVEL;
    if (frexp(cells, &exponent) == 0.5)
        exponent--;
    const bool periodic = w->def.boundary == BMR_PERIODIC;
    if (exponent > (periodic ? 0 : BMR_MOST_LEVEL))
        return BMR_ERROR_OUT_OF_RANGE;
    const int least = periodic ? LEAST_AROUND_LEVEL : BMR_LEAST_LEVEL;
    if (exponent < least)
        exponent = least;
    *level = periodic && w->def.all_pairs ? 0 : exponent;
    return BMR_OK;
}

bmr_vec2 bmr_grid_cells(const bmr_world *w, int level, bmr_vec2 position) {
    const bmr_vec2 at = bmr_sub(position, grid_origin(w)), size = bmr_cell_size(w, level);
    return bmr_vec2_make(at.x / size.x, at.y / size.y);
}

void bmr_grid_place(const bmr_world *w, int level, bmr_vec2 position, int64_t *column, int64_t *row) {
    const bmr_vec2 at = bmr_grid_cells(w, level, position);
    *column = (int64_t)floor(at.x);
    *row = (int64_t)floor(at.y);
}

void bmr_cell_box(const bmr_world *w, int level, int64_t column, int64_t row, double border, bmr_vec2 *low,
                  bmr_vec2 *high) {
    const bmr_vec2 size = bmr_cell_size(w, level), base = grid_origin(w);
    const double x = (double)column, y = (double)row;
    *low = bmr_vec2_make(base.x + (x - border) * size.x, base.y + (y - border) * size.y);
    *high = bmr_vec2_make(base.x + (x + 1.0 + border) * size.x, base.y + (y + 1.0 + border) * size.y);
}

// ---- the table ----

/// Cells around the box on a level; 0: it is open.
static int64_t around(int64_t of_level_0, int level) {
    return of_level_0 << -(of_level_0 > 0 ? level : 0);
}

static int64_t wrapped(int64_t place, int64_t size) {
    const int64_t rest = size > 0 ? place % size : place;
    return size > 0 && rest < 0 ? rest + size : rest;
}

static size_t hash(int level, int64_t column, int64_t row) {
    uint64_t h = (uint64_t)column * 0x9e3779b97f4a7c15u ^ ((uint64_t)row + (uint64_t)level * 0x2545f491u);
    h = (h ^ (h >> 32)) * 0xd6e8feb86659fd93u;
    return (size_t)(h ^ (h >> 29));
}

static bmr_cell **slot(const bmr_world *w, int level, int64_t column, int64_t row) {
    return &w->table[hash(level, column, row) & (w->table_size - 1)];
}

/// Inside of a periodic box.
static bmr_cell *find(const bmr_world *w, int level, int64_t column, int64_t row) {
    if (w->table_size == 0)
        return NULL;
    bmr_cell *cell = *slot(w, level, column, row);
    while (cell && (cell->level != level || cell->column != column || cell->row != row))
        cell = cell->next;
    return cell;
}

/// A table of another size, if there is memory for one; any size is right.
static bmr_error resize(bmr_world *w, size_t size) {
    size_t bytes;
    if (!bmr_size_product(size, sizeof(bmr_cell *), &bytes))
        return BMR_ERROR_TOO_LARGE;
    bmr_cell **table = bmr_world_take(w, bytes);
    if (!table)
        return BMR_ERROR_NO_MEMORY;
    memset(table, 0, bytes);
    bmr_cell **old = w->table;
    const size_t old_size = w->table_size;
    w->table = table;
    w->table_size = size;
    for (size_t i = 0; i < old_size; i++)
        for (bmr_cell *cell = old[i], *next; cell; cell = next) {
            next = cell->next;
            bmr_cell **const at = slot(w, cell->level, cell->column, cell->row);
            cell->next = *at;
            *at = cell;
        }
    bmr_world_give(w, old, old_size * sizeof(bmr_cell *));
    return BMR_OK;
}

static bmr_error fit_table(bmr_world *w) {
    if (w->table_size == 0)
        return resize(w, LEAST_TABLE);
    if (w->cell_count > w->table_size && w->table_size <= SIZE_MAX / 2)
        resize(w, 2 * w->table_size);
    else if (w->table_size > LEAST_TABLE && w->cell_count < w->table_size / 8)
        resize(w, w->table_size / 2);
    return BMR_OK;
}

static bmr_cell *create(bmr_world *w, int level, int64_t column, int64_t row) {
    bmr_cell *cell = bmr_world_take(w, sizeof *cell);
    if (!cell)
        return NULL;
    memset(cell, 0, sizeof *cell);
    cell->level = level;
    cell->column = column;
    cell->row = row;
    bmr_cell **const at = slot(w, level, column, row);
    cell->next = *at;
    *at = cell;
    w->cell_count++;
    return cell;
}

static void put_below(bmr_cell *cell, bmr_cell *parent) {
    cell->parent = parent;
    cell->before = NULL;
    cell->after = parent->child;
    if (parent->child)
        parent->child->before = cell;
    parent->child = cell;
}

static void take_from(bmr_cell *cell) {
    bmr_cell *const parent = cell->parent;
    if (!parent)
        return;
    if (cell->before)
        cell->before->after = cell->after;
    else
        parent->child = cell->after;
    if (cell->after)
        cell->after->before = cell->before;
    cell->parent = cell->after = cell->before = NULL;
}

static void destroy(bmr_world *w, bmr_cell *cell) {
    bmr_cell **at = slot(w, cell->level, cell->column, cell->row);
    while (*at != cell)
        at = &(*at)->next;
    *at = cell->next;
    w->cell_count--;
    bmr_world_give(w, cell, sizeof *cell);
}

/// Destroys the cells of the top level, which have no body of their own.
static void drop_top(bmr_world *w) {
    for (size_t i = 0; i < w->table_size; i++)
        for (bmr_cell *cell = w->table[i], *next; cell; cell = next) {
            next = cell->next;
            if (cell->level != w->top)
                continue;
            while (cell->child)
                take_from(cell->child);
            destroy(w, cell);
        }
    w->top--;
    w->idle_top = 0;
}

/// One level more: a parent for each cell of the top level.
static bmr_error raise_top(bmr_world *w) {
    const int level = ++w->top;
    for (size_t i = 0; i < w->table_size; i++)
        for (bmr_cell *cell = w->table[i]; cell; cell = cell->next) {
            if (cell->level != level - 1)
                continue;
            bmr_cell *parent = find(w, level, cell->column >> 1, cell->row >> 1);
            if (!parent)
                parent = create(w, level, cell->column >> 1, cell->row >> 1);
            if (!parent) {
                drop_top(w);
                return BMR_ERROR_NO_MEMORY;
            }
            put_below(cell, parent);
        }
    w->idle_top = 0;
    return BMR_OK;
}

void bmr_grid_lower(bmr_world *w) {
    if (w->cell_count == 0 || w->level_bodies[w->top - BMR_LEAST_LEVEL] > 0)
        w->idle_top = 0;
    else if (++w->idle_top > w->table_size)
        drop_top(w);
}

bmr_error bmr_grid_cell(bmr_world *w, int level, int64_t column, int64_t row, bmr_cell **cell) {
    bmr_error error = fit_table(w);
    if (w->cell_count == 0)
        w->top = level;
    while (w->top < level && error == BMR_OK)
        error = raise_top(w);
    if (error != BMR_OK)
        return error;
    int64_t i = wrapped(column, around(w->around_x, level)), j = wrapped(row, around(w->around_y, level));
    *cell = find(w, level, i, j);
    bmr_cell *below = NULL;
    for (int l = level; !*cell || below; l++, i >>= 1, j >>= 1) {
        bmr_cell *here = find(w, l, i, j);
        const bool last = here || l == w->top;
        if (!here)
            here = create(w, l, i, j);
        if (!here) {
            bmr_grid_prune(w, *cell);
            return BMR_ERROR_NO_MEMORY;
        }
        if (below)
            put_below(below, here);
        else
            *cell = here;
        below = last ? NULL : here;
    }
    return BMR_OK;
}

void bmr_grid_prune(bmr_world *w, bmr_cell *cell) {
    while (cell && cell->bodies == 0 && !cell->child) {
        bmr_cell *const parent = cell->parent;
        take_from(cell);
        destroy(w, cell);
        cell = parent;
    }
}

/// By how much of a cell a place is outside of one.
static double beyond(double cell, double place) {
    return fmax(cell - place, place - (cell + 1.0));
}

bool bmr_body_in_cell(const bmr_world *w, const bmr_world_body *r, bmr_vec2 position, double border) {
    const bmr_vec2 at = bmr_grid_cells(w, r->cell->level, position);
    return fmax(beyond((double)r->column, at.x), beyond((double)r->row, at.y)) <= border;
}

static void enter(bmr_world *w, bmr_cell *cell, bmr_world_body *r) {
    r->before = NULL;
    r->after = cell->first;
    if (cell->first)
        cell->first->before = r;
    cell->first = r;
    cell->bodies++;
    w->level_bodies[cell->level - BMR_LEAST_LEVEL]++;
}

static void leave(bmr_world *w, bmr_cell *cell, bmr_world_body *r) {
    if (r->before)
        r->before->after = r->after;
    else
        cell->first = r->after;
    if (r->after)
        r->after->before = r->before;
    cell->bodies--;
    w->level_bodies[cell->level - BMR_LEAST_LEVEL]--;
}

void bmr_cell_change(bmr_world *w, bmr_world_body *r, bmr_cell *cell) {
    bmr_cell *const old = r->cell;
    if (old == cell)
        return;
    if (old)
        leave(w, old, r);
    if (cell)
        enter(w, cell, r);
    r->cell = cell;
    bmr_grid_prune(w, old);
}

// ---- neighbours ----

static bmr_error add_candidate(bmr_world *w, bmr_world_body *r, int64_t image_x, int64_t image_y) {
    if (w->candidate_count == w->candidate_capacity) {
        const size_t capacity = w->candidate_capacity ? 2 * w->candidate_capacity : 16;
        size_t bytes;
        if (!bmr_size_product(capacity, sizeof *w->candidates, &bytes))
            return BMR_ERROR_TOO_LARGE;
        bmr_body_image *more = bmr_world_take(w, bytes);
        if (!more)
            return BMR_ERROR_NO_MEMORY;
        if (w->candidates) {
            memcpy(more, w->candidates, w->candidate_count * sizeof *more);
            bmr_world_give(w, w->candidates, w->candidate_capacity * sizeof *more);
        }
        w->candidates = more;
        w->candidate_capacity = capacity;
    }
    bmr_body_image *const c = &w->candidates[w->candidate_count++];
    c->body = r;
    c->image[0] = (int32_t)image_x;
    c->image[1] = (int32_t)image_y;
    return BMR_OK;
}

/// A cell's bodies and, with `below`, those of all cells below it. `column` and `row`: of that cell's place
/// on `level`, counted on as the asking body's are; a body's own count tells which image is there.
static bmr_error add_cell(bmr_world *w, const bmr_world_body *asks, const bmr_cell *cell, int level,
                          int64_t column, int64_t row, bool below) {
    const int64_t size_x = around(w->around_x, level), size_y = around(w->around_y, level);
    for (bmr_world_body *r = cell->first; r; r = r->after) {
        if (r == asks)
            continue;
        const int up = level - cell->level;
        const int64_t x = column - bmr_place_above(r->column, up), y = row - bmr_place_above(r->row, up);
        const bmr_error error = add_candidate(w, r, size_x > 0 ? x / size_x : 0, size_y > 0 ? y / size_y : 0);
        if (error != BMR_OK)
            return error;
    }
    for (const bmr_cell *child = below ? cell->child : NULL; child; child = child->after) {
        const bmr_error error = add_cell(w, asks, child, level, column, row, true);
        if (error != BMR_OK)
            return error;
    }
    return BMR_OK;
}

/// The nine cells around a place of a level.
static bmr_error add_around(bmr_world *w, const bmr_world_body *asks, int level, int64_t column, int64_t row,
                            bool below) {
    for (int64_t i = column - 1; i <= column + 1; i++)
        for (int64_t j = row - 1; j <= row + 1; j++) {
            const bmr_cell *cell = find(w, level, wrapped(i, around(w->around_x, level)),
                                        wrapped(j, around(w->around_y, level)));
            const bmr_error error = cell ? add_cell(w, asks, cell, level, i, j, below) : BMR_OK;
            if (error != BMR_OK)
                return error;
        }
    return BMR_OK;
}

static bmr_error add_all(bmr_world *w, const bmr_world_body *asks) {
    for (size_t i = 0; i < w->places; i++)
        if (w->bodies[i] && w->bodies[i] != asks) {
            const bmr_error error = add_candidate(w, w->bodies[i], 0, 0);
            if (error != BMR_OK)
                return error;
        }
    return BMR_OK;
}

bmr_error bmr_grid_candidates(bmr_world *w, const bmr_world_body *r, int level, int64_t column, int64_t row) {
    w->candidate_count = 0;
    if (!bmr_world_has_grid(w))
        return add_all(w, r);
    bmr_error error = add_around(w, r, level, column, row, true);
    for (int l = level + 1; l <= w->top && error == BMR_OK; l++)
        if (w->level_bodies[l - BMR_LEAST_LEVEL] > 0)
            error = add_around(w, r, l, bmr_place_above(column, l - level), bmr_place_above(row, l - level),
                               false);
    return error;
}
