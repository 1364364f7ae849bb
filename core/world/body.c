// SPDX-License-Identifier: MIT
// Bodies: where they live, who is near them, what they move on; and as the caller has them, by an id.
#include <float.h>
#include <math.h>
#include <string.h>

#include "geometry/length.h"
#include "geometry/memory.h"
#include "world/parts.h"

#define FEW_CANDIDATES 2
#define MANY_CANDIDATES 16
/// Part of a cell by which a body may be outside of it, and of the hysteresis, when it is found to be: see
/// cells.c.
#define CELL_OVERSHOOT 0x1p-6

// ---- jumps ----
//
// Does a body go on from where it is, or jump? What differs by more than rounding is a jump. That is never
// wrong: it costs a search of the neighbours, and who is in contact after it was put there. To take a jump
// for rounding is wrong as soon as it is a part of the margin; so a part of the place (JUMP of pair_motion.c,
// which serves pairs that are watched in any case) would not do far from the origin.
//
// What is continued is still a rounding elsewhere. All certificates of the body are computed anew then, its
// own from where it is now (bmr_body_leaves_cell); so roundings do not add up.

/// Rounding of a pose: so many of the terms of its path, and of its rotation's. (Horner's rule has two for
/// each degree, and the caller may have come to his pose in another way.)
#define ROUNDINGS 16.0
/// Pairs halve the margin down to this part of it (pair.c): what is less is seen by no structure.
#define UNSEEN_PART 0x1p-20

/// By how much a pose may differ from another one of the same time: its place, and its (c, s).
typedef struct pose_rounding {
    double place, turn;
} pose_rounding;

/// Sum of the lengths of a path's terms.
static double terms(const double *x, const double *y, size_t degree, double elapsed) {
    double sum = 0.0, power = 1.0;
    for (size_t k = 0; k <= degree; k++, power *= elapsed)
        sum += power * (fabs(x[k]) + fabs(y[k]));
    return sum;
}

static pose_rounding rounding_of(const bmr_motion_piece *piece, const bmr_instant *now, double time) {
    const double elapsed = fabs(time - piece->origin);
    pose_rounding size;
    if (piece->kind == BMR_PIECE_SCREW) {
        const bmr_screw_motion *p = &piece->as.screw;
        const double x[] = {p->start.position.x, p->velocity.x}, y[] = {p->start.position.y, p->velocity.y};
        size.place = terms(x, y, 1, elapsed);
        size.turn = 1.0 + fabs(p->spin) * elapsed;
    } else {
        const bmr_algebraic_piece *p = &piece->as.algebraic, here = bmr_piece_expand(piece, time);
        size.place = terms(p->x, p->y, p->degree, elapsed);
        size.turn =
            terms(p->a, p->b, p->rotation_degree, elapsed) / bmr_length(bmr_vec2_make(here.a[0], here.b[0]));
    }
    const double part = ROUNDINGS * DBL_EPSILON, clock = BMR_CLOCK_ROUNDINGS * DBL_EPSILON * fabs(time);
    const pose_rounding rounding = {part * size.place + clock * bmr_length(now->velocity),
                                    part * size.turn + clock * fabs(now->spin)};
    return rounding;
}

/// Is the piece a jump from where the body is now, by more than rounding?
static bool jumps(const bmr_world *w, const bmr_world_body *r, const bmr_motion_piece *piece) {
    const bmr_motion_piece *const before = &r->now.piece;
    bmr_timed_piece next;
    bmr_timed_piece_set(&next, w->time, piece); // of unit length
    const bmr_instant p = bmr_piece_instant(before, w->time), q = bmr_piece_instant(&next.piece, w->time);
    const pose_rounding old = rounding_of(before, &p, w->time), new = rounding_of(&next.piece, &q, w->time);
    const double unseen = UNSEEN_PART * w->def.kds.margin;
    const double place = old.place + new.place + ROUNDINGS *DBL_EPSILON * r->radius + unseen;
    const double turn = old.turn + new.turn + unseen / fmax(r->radius, w->def.kds.margin);
    // Written so that a NaN is a jump.
    return !(fabs(p.pose.position.x - q.pose.position.x) <= place &&
             fabs(p.pose.position.y - q.pose.position.y) <= place && fabs(p.pose.c - q.pose.c) <= turn &&
             fabs(p.pose.s - q.pose.s) <= turn);
}

// ---- neighbours ----

/// Is a wall within the reach of a body in this cell? (A cell is wider than what a disk reaches, with all
/// that is added to it.)
static bool wall_is_near(const bmr_world *w, int side, int level, int64_t column, int64_t row) {
    if (w->def.all_pairs)
        return true;
    bmr_vec2 low, high;
    bmr_cell_box(w, level, column, row, 1.0, &low, &high);
    const bool upright = side < 2;
    return side % 2 == 0 ? (upright ? low.x <= w->def.low.x : low.y <= w->def.low.y)
                         : (upright ? high.x >= w->def.high.x : high.y >= w->def.high.y);
}

static void mark_pairs(bmr_world_body *r) {
    for (bmr_body_pair *c = r->first; c; c = c->after[bmr_body_pair_side(c, r)]) {
        bmr_world_body *const other = c->side[1 - bmr_body_pair_side(c, r)];
        c->kept = false;
        c->same = other->found;
        other->found = c;
    }
}

static void clear_marks(bmr_world_body *r) {
    for (bmr_body_pair *c = r->first; c; c = c->after[bmr_body_pair_side(c, r)])
        c->side[1 - bmr_body_pair_side(c, r)]->found = NULL;
}

/// Keeps the pair of these two, or adds a new one to the list *made.
static bmr_error want(bmr_world *w, bmr_world_body *r, bmr_world_body *other, const int32_t image[2],
                      bmr_body_pair **made) {
    bmr_body_pair *c = other->found;
    for (; c; c = c->same) {
        const int sign = c->side[0] == r ? 1 : -1; // whose image was counted
        if (c->image[0] == sign * image[0] && c->image[1] == sign * image[1])
            break;
    }
    if (c) {
        c->kept = true;
        return BMR_OK;
    }
    const bmr_error error = bmr_body_pair_make(w, r, other, image, &c);
    if (error != BMR_OK)
        return error;
    c->same = *made;
    *made = c;
    return BMR_OK;
}

/// Makes what pairs are missing in a cell; those that stay are marked as kept. NO_MEMORY: none are made.
static bmr_error want_all(bmr_world *w, bmr_world_body *r, int level, int64_t column, int64_t row,
                          bmr_body_pair **made) {
    *made = NULL;
    bmr_error error = bmr_grid_candidates(w, r, level, column, row);
    if (error != BMR_OK)
        return error;
    mark_pairs(r);
    const int32_t here[2] = {0, 0};
    for (size_t i = 0; i < w->candidate_count && error == BMR_OK; i++)
        error = want(w, r, w->candidates[i].body, w->candidates[i].image, made);
    for (int side = 0; side < BMR_WALLS && w->def.boundary == BMR_WALLED && error == BMR_OK; side++)
        if (wall_is_near(w, side, level, column, row))
            error = want(w, r, &w->walls[side], here, made);
    clear_marks(r);
    while (error != BMR_OK && *made) {
        bmr_body_pair *const c = *made;
        *made = c->same;
        bmr_body_pair_destroy(w, c);
    }
    return error;
}

/// Pairs that are no neighbours any more go, unless a structure stands.
static void let_go(bmr_world *w, bmr_world_body *r) {
    for (bmr_body_pair *c = r->first, *next; c; c = next) {
        next = c->after[bmr_body_pair_side(c, r)];
        c->neighbours = c->kept;
        if (!c->kept && c->watch == BMR_WATCH_DISKS && c != w->busy)
            bmr_body_pair_destroy(w, c);
    }
}

static void begin_pairs(bmr_world *w, bmr_body_pair *made) {
    while (made) {
        bmr_body_pair *const c = made;
        made = c->same;
        bmr_body_pair_link(w, c);
        bmr_body_pair_search_later(w, c, false);
    }
}

/// Gives up all pairs: after a jump nothing that was known is true. The one whose contact is being reported
/// goes with them.
static void forget_pairs(bmr_world *w, bmr_world_body *r) {
    while (r->first)
        bmr_body_pair_destroy(w, r->first);
}

/// From the present time on it moves so; its certificates are as they were.
static void take(bmr_world *w, bmr_world_body *r, const bmr_course *course) {
    if (course->plan != r->plan)
        bmr_motion_destroy(r->plan);
    r->plan = course->plan;
    bmr_timed_piece_set(&r->now, -INFINITY, &course->piece);
    r->since = w->time;
    r->until = course->until;
}

/// Takes the body to a cell, with all that follows from that. `jump`: it jumped there, to a course of which
/// no pair knows; else NULL. NO_MEMORY: it stays.
static bmr_error settle(bmr_world *w, bmr_world_body *r, int level, int64_t column, int64_t row,
                        const bmr_course *jump) {
    bmr_cell *cell = NULL;
    bmr_error error = bmr_world_has_grid(w) ? bmr_grid_cell(w, level, column, row, &cell) : BMR_OK;
    if (error != BMR_OK)
        return error;
    bmr_body_pair *made, *const first = r->first;
    if (jump)
        r->first = NULL;
    error = want_all(w, r, level, column, row, &made);
    r->first = first;
    if (error != BMR_OK) {
        bmr_grid_prune(w, cell);
        return error;
    }
    if (jump)
        forget_pairs(w, r);
    bmr_cell_change(w, r, cell);
    r->column = column;
    r->row = row;
    if (jump)
        take(w, r, jump);
    else
        let_go(w, r);
    begin_pairs(w, made);
    if (cell && !jump)
        bmr_grid_lower(w);
    return BMR_OK;
}

// ---- its own certificate ----

/// The way out of its cell after `after`, or its motion's next piece.
static bmr_error search_own(bmr_world *w, bmr_world_body *r, double after) {
    double time = INFINITY;
    if (r->cell) {
        w->counts.disk_times++;
        const bmr_error error = bmr_body_leaves_cell(w, r, after, &time, &r->unfinished);
        if (error != BMR_OK)
            return error;
    }
    if (r->until <= time) {
        time = r->until;
        r->unfinished = false;
    }
    bmr_event_queue_set(&w->queue, &r->head.item, time);
    return BMR_OK;
}

/// Searches its own certificate; what cannot be done is tried again in the next advance.
static void search_later(bmr_world *w, bmr_world_body *r, double after) {
    if (search_own(w, r, after) == BMR_OK)
        return;
    r->unfinished = true;
    bmr_event_queue_set(&w->queue, &r->head.item, w->time);
}

static size_t candidates_of(const bmr_world_body *r) {
    size_t count = 0;
    for (const bmr_body_pair *c = r->first; c; c = c->after[bmr_body_pair_side(c, r)])
        if (c->neighbours && !bmr_body_is_wall(c->side[1]))
            count += c->side[1 - bmr_body_pair_side(c, r)]->cell->level <= r->cell->level;
    return count;
}

/// Which level it is to live on: its size's and place's at least, one higher or lower than now where it has
/// few or many candidates.
static bmr_error choose_level(const bmr_world *w, const bmr_world_body *r, bmr_vec2 position, int *level) {
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
    const double slack = 0.5 * BMR_CELL_HYSTERESIS;
    return place >= (double)before - slack && place <= (double)before + 1.0 + slack ? before : now;
}

static bmr_error cross(bmr_world *w, bmr_world_body *r) {
    const bmr_vec2 position = bmr_path_position(&r->now.piece, w->time);
    int level;
    const bmr_error error = choose_level(w, r, position, &level);
    if (error == BMR_ERROR_OUT_OF_RANGE)
        return bmr_world_stop(w, error, BMR_TROUBLE_PLACE, r->id, BMR_NO_BODY);
    if (error != BMR_OK)
        return error;
    // It is farther out of its cell than rounding of its place allows: no time lies between. (A motion that
    // begins now may begin there.)
    if (r->since < w->time && !bmr_body_in_cell(w, r, position, BMR_CELL_HYSTERESIS + CELL_OVERSHOOT))
        return bmr_world_stop(w, BMR_ERROR_OUT_OF_RANGE, BMR_TROUBLE_SPEED, r->id, BMR_NO_BODY);
    int64_t column, row;
    bmr_grid_place(w, level, position, &column, &row);
    if (level == r->cell->level) {
        const bmr_vec2 at = bmr_grid_cells(w, level, position);
        column = column_at(r->column, column, at.x);
        row = column_at(r->row, row, at.y);
    }
    // So fast that a rounding of the time is a way through the hysteresis: on to the next time that there is.
    const bool stays = level == r->cell->level && column == r->column && row == r->row;
    const bmr_body id = r->id;
    const bmr_error settled = settle(w, r, level, column, row, NULL);
    if (settled != BMR_OK)
        return settled;
    search_later(w, r, stays ? nextafter(w->time, INFINITY) : w->time);
    bmr_world_observe(w, BMR_WORLD_CROSS, id, BMR_NO_BODY, NULL);
    return BMR_OK;
}

// ---- motions ----

/// To where its pose jumped. NO_MEMORY: as it was.
static bmr_error jump(bmr_world *w, bmr_world_body *r, const bmr_course *course) {
    const bmr_vec2 position = bmr_path_position(&course->piece, w->time);
    int level = 0;
    int64_t column = 0, row = 0;
    if (r->cell) {
        const bmr_error error = bmr_grid_level(w, r->radius, position, &level);
        if (error != BMR_OK)
            return error;
        bmr_grid_place(w, level, position, &column, &row);
    }
    const bmr_error error = settle(w, r, level, column, row, course);
    if (error == BMR_OK)
        search_later(w, r, w->time);
    return error;
}

bmr_error bmr_body_move(bmr_world *w, bmr_world_body *r, const bmr_course *course) {
    w->counts.replans++;
    if (jumps(w, r, &course->piece))
        return jump(w, r, course);
    take(w, r, course);
    search_later(w, r, w->time);
    w->counts.replanned++;
    for (bmr_body_pair *c = r->first; c; c = c->after[bmr_body_pair_side(c, r)]) {
        if (c == w->busy)
            continue;
        w->counts.replanned++;
        bmr_body_pair_search_later(w, c, true);
    }
    return BMR_OK;
}

static bmr_error next_piece(bmr_world *w, bmr_world_body *r) {
    bmr_course course; // the last piece outlives its plan
    course.piece = *bmr_motion_piece_at(r->plan, w->time, &course.until);
    course.plan = course.until < INFINITY ? r->plan : NULL;
    const bmr_body id = r->id;
    const bmr_error error = bmr_body_move(w, r, &course);
    if (error != BMR_OK)
        return error;
    bmr_world_observe(w, BMR_WORLD_PLAN, id, BMR_NO_BODY, NULL);
    return BMR_OK;
}

bmr_error bmr_body_event(bmr_world *w, bmr_world_body *r) {
    if (r->until <= w->time)
        return next_piece(w, r);
    if (r->unfinished) {
        w->counts.continued++;
        return search_own(w, r, w->time);
    }
    return cross(w, r);
}

void bmr_body_destroy(bmr_world *w, bmr_world_body *r) {
    forget_pairs(w, r);
    bmr_cell_change(w, r, NULL);
    bmr_motion_destroy(r->plan);
    bmr_scheduled_destroy(w, &r->head, sizeof *r);
}

// ---- by their ids ----

bmr_world_body *bmr_world_find(const bmr_world *w, bmr_body id) {
    const size_t place = (size_t)(id & UINT32_MAX);
    if (place >= w->places || !w->bodies[place] || w->bodies[place]->id != id)
        return NULL;
    return w->bodies[place];
}

/// A place in the table of ids, whose ids are not used up; the table grows by doubling, and is never given
/// back before the world is.
static bmr_error find_place(bmr_world *w, size_t *place) {
    while (w->free_place < w->places &&
           (w->bodies[w->free_place] || w->generations[w->free_place] == BMR_NO_GENERATION))
        w->free_place++;
    *place = w->free_place;
    if (w->free_place < w->places)
        return BMR_OK;
    if (w->places == w->capacity) {
        const size_t capacity = w->capacity ? 2 * w->capacity : 16;
        size_t bytes;
        if (w->capacity > UINT32_MAX / 4 || !bmr_size_product(capacity, BMR_PLACE_BYTES, &bytes))
            return BMR_ERROR_TOO_LARGE;
        bmr_world_body **bodies = bmr_world_take(w, bytes);
        if (!bodies)
            return BMR_ERROR_NO_MEMORY;
        uint32_t *generations = (uint32_t *)(void *)(bodies + capacity);
        memset(bodies, 0, bytes);
        if (w->bodies) {
            memcpy(bodies, w->bodies, w->places * sizeof(bmr_world_body *));
            memcpy(generations, w->generations, w->places * sizeof *generations);
            bmr_world_give(w, w->bodies, w->capacity * BMR_PLACE_BYTES);
        }
        w->bodies = bodies;
        w->generations = generations;
        w->capacity = capacity;
    }
    return BMR_OK;
}

static bmr_error course_of(bmr_world *w, const bmr_motion *motion, bmr_course *course) {
    course->piece = *bmr_motion_piece_at(motion, w->time, &course->until);
    course->plan = NULL;
    return course->until < INFINITY ? bmr_motion_copy_from(motion, w->time, &w->counted, &course->plan)
                                    : BMR_OK;
}

static double radius_of(const bmr_polygon *polygon) {
    double most = 0.0;
    for (uint32_t i = 0; i < polygon->count; i++)
        most = fmax(most, hypot(polygon->vertices[i].x, polygon->vertices[i].y));
    return most * (1.0 + 0x1p-50);
}

/// Where it is to live, and whether its shape will do: what a structure would say of it.
static bmr_error check_body(bmr_world *w, const bmr_body_def *def, bmr_world_body *r, int *level) {
    if (!(def->mass > 0.0) || !(def->inertia > 0.0))
        return isnan(def->mass) || isnan(def->inertia) ? BMR_ERROR_NOT_FINITE : BMR_ERROR_OUT_OF_RANGE;
    bmr_kds *kds;
    bmr_error error = bmr_kds_create(w->def.structure, &w->def.kds, &r->shape, &r->shape, &w->counted, &kds);
    if (error != BMR_OK)
        return error;
    bmr_kds_destroy(kds, &w->counted);
    if (w->unit_x == 0.0)
        w->unit_x = w->unit_y = bmr_grid_need(w, r->radius);
    const bmr_vec2 position = bmr_path_position(&r->now.piece, w->time);
    error = bmr_grid_level(w, r->radius, position, level);
    if (error == BMR_OK && w->def.boundary == BMR_WALLED)
        error = bmr_wall_segments_of(w, r->radius, &r->segments);
    if (error == BMR_OK && w->def.boundary == BMR_PERIODIC &&
        8.0 * r->radius >= fmin(w->def.high.x - w->def.low.x, w->def.high.y - w->def.low.y))
        error = BMR_ERROR_OUT_OF_RANGE;
    return error;
}

static bmr_error make_body(bmr_world *w, const bmr_body_def *def, bmr_world_body **body) {
    bmr_course course;
    bmr_error error = course_of(w, def->motion, &course);
    if (error != BMR_OK)
        return error;
    bmr_scheduled *head;
    error = bmr_scheduled_make(w, sizeof(bmr_world_body), false, &head);
    if (error != BMR_OK) {
        bmr_motion_destroy(course.plan);
        return error;
    }
    bmr_world_body *const r = (void *)head;
    r->shape = *def->shape;
    r->radius = radius_of(def->shape->polygon);
    r->mass = def->mass;
    r->inertia = def->inertia;
    take(w, r, &course);
    *body = r;
    return BMR_OK;
}

bmr_error bmr_world_add(bmr_world *w, const bmr_body_def *def, bmr_body *body) {
    if (!w || !def || !body || !def->shape || !def->shape->polygon || !def->motion)
        return BMR_ERROR_NULL_ARGUMENT;
    size_t place;
    bmr_world_body *r;
    bmr_error error = find_place(w, &place);
    if (error == BMR_OK)
        error = make_body(w, def, &r);
    if (error != BMR_OK)
        return error;
    int level;
    error = check_body(w, def, r, &level);
    r->id = place | (bmr_body)(place < w->places ? w->generations[place] : 0) << 32;
    r->birth = w->births;
    if (error == BMR_OK) {
        int64_t column, row;
        bmr_grid_place(w, level, bmr_path_position(&r->now.piece, w->time), &column, &row);
        error = settle(w, r, level, column, row, NULL);
    }
    if (error != BMR_OK) {
        bmr_body_destroy(w, r);
        if (w->births == 0 && w->def.boundary != BMR_PERIODIC)
            w->unit_x = w->unit_y = 0.0;
        return error;
    }
    w->births++;
    if (place == w->places)
        w->places++;
    w->bodies[place] = r;
    w->counts.bodies++;
    search_later(w, r, w->time);
    *body = r->id;
    return BMR_OK;
}

bmr_error bmr_world_remove(bmr_world *w, bmr_body body) {
    if (!w)
        return BMR_ERROR_NULL_ARGUMENT;
    bmr_world_body *const r = bmr_world_find(w, body);
    if (!r)
        return BMR_ERROR_OUT_OF_RANGE;
    const size_t place = (size_t)(body & UINT32_MAX);
    w->bodies[place] = NULL;
    w->generations[place]++;
    if (place < w->free_place)
        w->free_place = place;
    w->counts.bodies--;
    bmr_body_destroy(w, r);
    return BMR_OK;
}

bmr_error bmr_world_set_motion(bmr_world *w, bmr_body body, const bmr_motion *motion) {
    if (!w || !motion)
        return BMR_ERROR_NULL_ARGUMENT;
    bmr_world_body *const r = bmr_world_find(w, body);
    if (!r)
        return BMR_ERROR_OUT_OF_RANGE;
    bmr_course course;
    bmr_error error = course_of(w, motion, &course);
    if (error != BMR_OK)
        return error;
    error = bmr_body_move(w, r, &course);
    if (error != BMR_OK)
        bmr_motion_destroy(course.plan);
    return error;
}

bmr_error bmr_world_set_piece(bmr_world *w, bmr_body body, const bmr_motion_piece *piece) {
    if (!w || !piece)
        return BMR_ERROR_NULL_ARGUMENT;
    const bmr_error error = bmr_piece_check(piece);
    if (error != BMR_OK)
        return error;
    bmr_world_body *const r = bmr_world_find(w, body);
    const bmr_course course = {*piece, INFINITY, NULL};
    return r ? bmr_body_move(w, r, &course) : BMR_ERROR_OUT_OF_RANGE;
}
