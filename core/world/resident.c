// SPDX-License-Identifier: MIT
// Residents: where they live, who is near them, and what they move on.
#include "world/parts.h"

#include <math.h>

/// A body lives one level higher from its next crossing on where it has fewer candidates than this of its own
/// level and below, and one level lower, as low as its size allows, where it has more than that: where there
/// is nobody, cells are large and crossings rare. A cell of the next level has room for four times as many.
/// (Larger bodies are candidates wherever it lives.)
#define FEW_CANDIDATES 2
#define MANY_CANDIDATES 16
/// Part of a cell by which a body may be outside of it, and of the hysteresis, when it is found to be: see
/// cells.c.
#define CELL_OVERSHOOT 0x1p-6

// ---- neighbours ----

/// Is a wall within the reach of a body in this cell?
static bool wall_is_near(const bmr_world *w, int side, int level, int64_t column, int64_t row) {
    if (w->def.all_pairs)
        return true;
    const double width = bmr_cell_width(w, level), height = bmr_cell_height(w, level);
    const bool upright = side < 2;
    const double size = upright ? width : height;
    const double low = (double)(upright ? column : row) * size, high = low + size;
    const double line = side == 0   ? w->def.low.x
                        : side == 1 ? w->def.high.x
                        : side == 2 ? w->def.low.y
                                    : w->def.high.y;
    // A cell is wider than what a disk reaches, with all that is added to it.
    return side % 2 == 0 ? low - size <= line : high + size >= line;
}

static void mark_couples(bmr_resident *r) {
    for (bmr_couple *c = r->first; c; c = c->after[bmr_couple_side(c, r)]) {
        bmr_resident *const other = c->side[1 - bmr_couple_side(c, r)];
        c->kept = false;
        c->same = other->found;
        other->found = c;
    }
}

static void clear_marks(bmr_resident *r) {
    for (bmr_couple *c = r->first; c; c = c->after[bmr_couple_side(c, r)])
        c->side[1 - bmr_couple_side(c, r)]->found = NULL;
}

/// Keeps the couple of these two, or adds a new one to the list *made.
static bmr_error want(bmr_world *w, bmr_resident *r, bmr_resident *other, const int32_t image[2],
                      bmr_couple **made) {
    bmr_couple *c = other->found;
    for (; c; c = c->same) {
        const int sign = c->side[0] == r ? 1 : -1; // whose image was counted
        if (c->image[0] == sign * image[0] && c->image[1] == sign * image[1])
            break;
    }
    if (c) {
        c->kept = true;
        return BMR_OK;
    }
    const bmr_error error = bmr_couple_make(w, r, other, image, &c);
    if (error != BMR_OK)
        return error;
    c->same = *made;
    *made = c;
    return BMR_OK;
}

/// Makes what couples are missing in a cell; those that stay are marked as kept. NO_MEMORY: none are made.
static bmr_error want_all(bmr_world *w, bmr_resident *r, int level, int64_t column, int64_t row,
                          bmr_couple **made) {
    *made = NULL;
    bmr_error error = bmr_grid_candidates(w, r, level, column, row);
    if (error != BMR_OK)
        return error;
    mark_couples(r);
    const int32_t here[2] = {0, 0};
    for (size_t i = 0; i < w->candidate_count && error == BMR_OK; i++)
        error = want(w, r, w->candidates[i].resident, w->candidates[i].image, made);
    for (int side = 0; side < BMR_WALLS && w->def.boundary == BMR_WALLED && error == BMR_OK; side++)
        if (wall_is_near(w, side, level, column, row))
            error = want(w, r, &w->walls[side], here, made);
    clear_marks(r);
    while (error != BMR_OK && *made) {
        bmr_couple *const c = *made;
        *made = c->same;
        bmr_couple_destroy(w, c);
    }
    return error;
}

/// Couples that are no neighbours any more go, unless a structure stands.
static void let_go(bmr_world *w, bmr_resident *r) {
    for (bmr_couple *c = r->first, *next; c; c = next) {
        next = c->after[bmr_couple_side(c, r)];
        c->neighbours = c->kept;
        if (!c->kept && c->watch == BMR_WATCH_DISKS && c != w->busy)
            bmr_couple_destroy(w, c);
    }
}

static void begin_couples(bmr_world *w, bmr_couple *made) {
    while (made) {
        bmr_couple *const c = made;
        made = c->same;
        bmr_couple_link(w, c);
        bmr_couple_search_later(w, c, false);
    }
}

bmr_error bmr_resident_settle(bmr_world *w, bmr_resident *r, int level, int64_t column, int64_t row) {
    const bool grid = !w->def.all_pairs || w->def.boundary == BMR_PERIODIC;
    bmr_cell *cell = NULL;
    bmr_couple *made;
    bmr_error error = grid ? bmr_grid_cell(w, level, column, row, &cell) : BMR_OK;
    if (error != BMR_OK)
        return error;
    error = want_all(w, r, level, column, row, &made);
    if (error != BMR_OK) {
        bmr_grid_prune(w, cell);
        return error;
    }
    if (grid && cell != r->cell) {
        cell->bodies++; // so that it is not given back with the old one
        bmr_cell_leave(w, r);
        cell->bodies--;
        bmr_cell_enter(w, cell, r);
    }
    r->column = column;
    r->row = row;
    let_go(w, r);
    begin_couples(w, made);
    if (grid)
        bmr_grid_lower(w);
    return BMR_OK;
}

// ---- its own certificate ----

/// The way out of its cell after `after`, or its motion's next piece.
static bmr_error search_own(bmr_world *w, bmr_resident *r, double after) {
    double time = INFINITY;
    r->look = false;
    if (r->cell) {
        w->counts.disk_times++;
        const bmr_error error = bmr_gate_crosses(w, r, after, &time, &r->look);
        if (error != BMR_OK)
            return error;
    }
    if (r->until <= time) {
        time = r->until;
        r->look = false;
    }
    bmr_event_queue_set(&w->queue, &r->head.item, time);
    return BMR_OK;
}

void bmr_resident_search_later(bmr_world *w, bmr_resident *r, double after) {
    if (search_own(w, r, after) == BMR_OK)
        return;
    r->look = true;
    bmr_event_queue_set(&w->queue, &r->head.item, w->time);
}

static size_t candidates_of(const bmr_resident *r) {
    size_t count = 0;
    for (const bmr_couple *c = r->first; c; c = c->after[bmr_couple_side(c, r)])
        if (c->neighbours && !bmr_resident_is_wall(c->side[1]))
            count += c->side[1 - bmr_couple_side(c, r)]->cell->level <= r->cell->level;
    return count;
}

/// Which level it is to live on: its size's and place's at least, one higher or lower than now where it has
/// few or many candidates.
static bmr_error choose_level(const bmr_world *w, const bmr_resident *r, bmr_vec2 position, int *level) {
    int least;
    const bmr_error error = bmr_grid_level(w, r->radius, position, &least);
    if (error != BMR_OK)
        return error;
    const size_t candidates = candidates_of(r);
    const bool open = w->def.boundary != BMR_PERIODIC;
    *level = r->cell->level;
    // It would cross the largest cells for as long as there are digits.
    if (open && *level == BMR_MOST_LEVEL)
        return BMR_ERROR_OUT_OF_RANGE;
    if (candidates < FEW_CANDIDATES && *level < (open ? BMR_MOST_LEVEL : 0))
        ++*level;
    else if (candidates > MANY_CANDIDATES)
        --*level;
    if (*level < least)
        *level = least;
    return BMR_OK;
}

/// A column (or row) is left when the place is beyond it by half of the hysteresis: at the time computed it
/// is beyond by all of it, up to rounding.
static int64_t column_at(int64_t before, int64_t now, double place) {
    const double room = 0.5 * BMR_CELL_HYSTERESIS;
    return place >= (double)before - room && place <= (double)before + 1.0 + room ? before : now;
}

/// By how much of a cell a place is outside of one.
static double beyond(double cell, double place) {
    return fmax(cell - place, place - (cell + 1.0));
}

/// It is farther out of its cell than rounding of its place allows: no time lies between. (A motion that
/// begins now may begin there.)
static bool has_left(const bmr_world *w, const bmr_resident *r, bmr_vec2 position) {
    const bool periodic = w->def.boundary == BMR_PERIODIC;
    const bmr_vec2 at = periodic ? bmr_sub(position, w->def.low) : position;
    const int level = r->cell->level;
    const double x = beyond((double)r->column, at.x / bmr_cell_width(w, level));
    const double y = beyond((double)r->row, at.y / bmr_cell_height(w, level));
    return !(fmax(x, y) <= BMR_CELL_HYSTERESIS + CELL_OVERSHOOT);
}

static bmr_error cross(bmr_world *w, bmr_resident *r) {
    const bmr_vec2 position = bmr_path_position(&r->now.piece, w->time);
    int level;
    const bmr_error error = choose_level(w, r, position, &level);
    if (error == BMR_ERROR_OUT_OF_RANGE)
        return bmr_world_stop(w, error, BMR_TROUBLE_PLACE, r->id, BMR_NO_BODY);
    if (error != BMR_OK)
        return error;
    if (r->since < w->time && has_left(w, r, position))
        return bmr_world_stop(w, BMR_ERROR_OUT_OF_RANGE, BMR_TROUBLE_SPEED, r->id, BMR_NO_BODY);
    int64_t column, row;
    bmr_grid_place(w, level, position, &column, &row);
    if (level == r->cell->level) {
        const bool periodic = w->def.boundary == BMR_PERIODIC;
        const bmr_vec2 at = periodic ? bmr_sub(position, w->def.low) : position;
        column = column_at(r->column, column, at.x / bmr_cell_width(w, level));
        row = column_at(r->row, row, at.y / bmr_cell_height(w, level));
    }
    // So fast that a rounding of the time is a way through the hysteresis: on to the next time that there is.
    const bool stays = level == r->cell->level && column == r->column && row == r->row;
    const bmr_body id = r->id;
    const bmr_error settled = bmr_resident_settle(w, r, level, column, row);
    if (settled != BMR_OK)
        return settled;
    bmr_resident_search_later(w, r, stays ? nextafter(w->time, INFINITY) : w->time);
    bmr_world_observe(w, BMR_WORLD_CROSS, w->time, id, BMR_NO_BODY, NULL);
    return BMR_OK;
}

// ---- motions ----

/// Gives up all couples: after a jump nothing that was known is true. The one whose contact is being told
/// goes with them.
static void forget_couples(bmr_world *w, bmr_resident *r) {
    while (r->first)
        bmr_couple_destroy(w, r->first);
}

static void drop_plan(bmr_resident *r) {
    bmr_motion_destroy(r->plan);
    r->plan = NULL;
}

void bmr_resident_take(bmr_world *w, bmr_resident *r, const bmr_motion_piece *piece, double until,
                       bmr_motion *plan) {
    if (plan != r->plan)
        drop_plan(r);
    r->plan = plan;
    bmr_timed_piece_set(&r->now, -INFINITY, piece);
    r->since = w->time;
    r->until = until;
}

/// To where its pose jumped. NO_MEMORY: as it was.
static bmr_error jump(bmr_world *w, bmr_resident *r, const bmr_motion_piece *piece, double until,
                      bmr_motion *plan) {
    const bmr_vec2 position = bmr_path_position(piece, w->time);
    int level = 0;
    int64_t column = 0, row = 0;
    if (r->cell) {
        const bmr_error error = bmr_grid_level(w, r->radius, position, &level);
        if (error != BMR_OK)
            return error;
        bmr_grid_place(w, level, position, &column, &row);
    }
    // The cell is made first: all else can be done without memory, or later.
    bmr_cell *cell = NULL;
    bmr_couple *made;
    bmr_error error = r->cell ? bmr_grid_cell(w, level, column, row, &cell) : BMR_OK;
    if (error != BMR_OK)
        return error;
    bmr_couple *const first = r->first;
    r->first = NULL; // none of the old ones is kept
    error = want_all(w, r, level, column, row, &made);
    r->first = first;
    if (error != BMR_OK) {
        bmr_grid_prune(w, cell);
        return error;
    }
    if (cell)
        cell->bodies++;
    forget_couples(w, r);
    bmr_cell_leave(w, r);
    if (cell) {
        cell->bodies--;
        bmr_cell_enter(w, cell, r);
    }
    r->column = column;
    r->row = row;
    bmr_resident_take(w, r, piece, until, plan);
    begin_couples(w, made);
    bmr_resident_search_later(w, r, w->time);
    return BMR_OK;
}

bmr_error bmr_resident_move(bmr_world *w, bmr_resident *r, const bmr_motion_piece *piece, double until,
                            bmr_motion *plan) {
    w->counts.replans++;
    if (bmr_resident_jumps(w, r, piece))
        return jump(w, r, piece, until, plan);
    bmr_resident_take(w, r, piece, until, plan);
    bmr_resident_search_later(w, r, w->time);
    w->counts.replanned++;
    for (bmr_couple *c = r->first; c; c = c->after[bmr_couple_side(c, r)]) {
        c->stuck = c->stuck && w->sticking;
        if (c == w->busy)
            continue;
        w->counts.replanned++;
        bmr_couple_search_later(w, c, true);
    }
    return BMR_OK;
}

static bmr_error next_piece(bmr_world *w, bmr_resident *r) {
    double end;
    const bmr_motion_piece *piece = bmr_motion_piece_at(r->plan, w->time, &end);
    const bmr_body id = r->id;
    const bmr_motion_piece copy = *piece; // the last one outlives its plan
    const bmr_error error = bmr_resident_move(w, r, &copy, end, end < INFINITY ? r->plan : NULL);
    if (error != BMR_OK)
        return error;
    bmr_world_observe(w, BMR_WORLD_PLAN, w->time, id, BMR_NO_BODY, NULL);
    return BMR_OK;
}

bmr_error bmr_resident_event(bmr_world *w, bmr_resident *r) {
    if (r->until <= w->time)
        return next_piece(w, r);
    if (r->look) {
        w->counts.looks++;
        return search_own(w, r, w->time);
    }
    return cross(w, r);
}

void bmr_resident_destroy(bmr_world *w, bmr_resident *r) {
    forget_couples(w, r);
    bmr_event_queue_set(&w->queue, &r->head.item, INFINITY);
    bmr_event_queue_release(&w->queue, &w->counted);
    bmr_cell_leave(w, r);
    drop_plan(r);
    bmr_world_give(w, r, sizeof *r);
}
