// SPDX-License-Identifier: MIT
// Looking at a world: its bodies, pairs, cells, counts and totals.
#include <math.h>
#include <string.h>

#include "world/parts.h"

const char *bmr_world_event_name(bmr_world_event_kind kind) {
    static const char *const names[BMR_WORLD_EVENT_KIND_COUNT] = {"plan", "cross",   "near", "repair",
                                                                  "part", "contact", "leave"};
    return (unsigned)kind < BMR_WORLD_EVENT_KIND_COUNT ? names[kind] : NULL;
}

bmr_error bmr_world_get(const bmr_world *w, bmr_body body, bmr_body_state *state) {
    if (!w || !state)
        return BMR_ERROR_NULL_ARGUMENT;
    const bmr_world_body *r = bmr_world_find(w, body);
    if (!r)
        return BMR_ERROR_OUT_OF_RANGE;
    const bmr_instant now = bmr_piece_instant(&r->now.piece, w->time);
    memset(state, 0, sizeof *state);
    state->pose = now.pose;
    state->velocity = now.velocity;
    state->spin = now.spin;
    state->shape = &r->shape;
    state->piece = r->now.piece;
    state->mass = r->mass;
    state->inertia = r->inertia;
    state->radius = r->radius;
    state->pairs = r->pairs;
    if (r->cell) {
        state->level = r->cell->level;
        bmr_cell_box(w, r->cell->level, r->column, r->row, 0.0, &state->cell_low, &state->cell_high);
    }
    return BMR_OK;
}

bmr_body bmr_world_next_body(const bmr_world *w, size_t *place) {
    while (*place < w->places) {
        const bmr_world_body *r = w->bodies[(*place)++];
        if (r)
            return r->id;
    }
    return BMR_NO_BODY;
}

static double next_event(const bmr_world *w, const bmr_scheduled *head) {
    return head->item.place == BMR_NOT_QUEUED ? INFINITY : w->queue.heap[head->item.place].time;
}

void bmr_world_each_pair(const bmr_world *w, void (*visit)(void *context, const bmr_world_pair *pair),
                         void *context) {
    for (size_t i = 0; i < w->places; i++) {
        const bmr_world_body *r = w->bodies[i];
        for (const bmr_body_pair *c = r ? r->first : NULL; c; c = c->after[bmr_body_pair_side(c, r)]) {
            if (c->side[0] != r)
                continue;
            bmr_world_pair pair;
            memset(&pair, 0, sizeof pair);
            pair.a = r->id;
            pair.b = c->side[1]->id;
            pair.watch = (bmr_watch)c->watch;
            pair.image = bmr_body_pair_shift(w, c);
            pair.reach = bmr_disks_reach(w, c);
            pair.next = next_event(w, &c->head);
            pair.neighbours = c->neighbours;
            pair.kds = c->near ? c->near->kds : NULL;
            visit(context, &pair);
        }
    }
}

void bmr_world_each_cell(const bmr_world *w, void (*visit)(void *context, const bmr_world_cell *cell),
                         void *context) {
    for (size_t i = 0; i < w->table_size; i++)
        for (const bmr_cell *c = w->table[i]; c; c = c->next) {
            if (c->bodies == 0)
                continue;
            bmr_world_cell cell;
            cell.level = c->level;
            cell.bodies = c->bodies;
            bmr_cell_box(w, c->level, c->column, c->row, 0.0, &cell.low, &cell.high);
            visit(context, &cell);
        }
}

bmr_world_counts bmr_world_get_counts(const bmr_world *w) {
    bmr_world_counts counts = w->counts;
    counts.cells = w->cell_count;
    int lowest = 0, highest = -1;
    for (int l = BMR_MOST_LEVEL; l >= BMR_LEAST_LEVEL; l--)
        if (w->level_bodies[l - BMR_LEAST_LEVEL] > 0) {
            highest = highest < lowest ? l : highest;
            lowest = l;
        }
    counts.levels = highest - lowest + 1;
    return counts;
}

bmr_world_totals bmr_world_get_totals(const bmr_world *w) {
    bmr_world_totals totals = {0.0, {0.0, 0.0}, 0.0};
    for (size_t i = 0; i < w->places; i++) {
        const bmr_world_body *r = w->bodies[i];
        if (!r)
            continue;
        const bmr_instant now = bmr_piece_instant(&r->now.piece, w->time);
        if (isfinite(r->mass)) {
            totals.energy += 0.5 * r->mass * bmr_dot(now.velocity, now.velocity);
            totals.momentum = bmr_add(totals.momentum, bmr_scale(r->mass, now.velocity));
            totals.angular += r->mass * bmr_cross(now.pose.position, now.velocity);
        }
        if (isfinite(r->inertia)) {
            totals.energy += 0.5 * r->inertia * now.spin * now.spin;
            totals.angular += r->inertia * now.spin;
        }
    }
    return totals;
}

// ---- everything that a world claims, proved from scratch ----

/// What places may be off their cells, and disks be nearer, by rounding: parts of a cell, and of the reach.
#define ROUNDING 1e-6

static bool in_cell(const bmr_world *w, const bmr_world_body *r) {
    if (!r->cell)
        return !bmr_world_has_grid(w);
    const bmr_vec2 position = bmr_path_position(&r->now.piece, w->time);
    return bmr_body_in_cell(w, r, position, BMR_CELL_HYSTERESIS + ROUNDING);
}

static bool near_by(int64_t a, int64_t b, int64_t size, int64_t *image) {
    const int64_t apart = a - b;
    *image = size > 0 ? (int64_t)floor((double)apart / (double)size + 0.5) : 0;
    const int64_t rest = apart - *image * size;
    return rest >= -1 && rest <= 1;
}

/// Are their cells neighbours on the coarser one's level? `image`: of b as seen from a.
static bool are_neighbours(const bmr_world *w, const bmr_world_body *a, const bmr_world_body *b,
                           int64_t image[2]) {
    image[0] = image[1] = 0;
    if (!a->cell)
        return true;
    const int la = a->cell->level, lb = b->cell->level, level = la > lb ? la : lb;
    const int64_t x = w->around_x > 0 ? w->around_x << -level : 0;
    const int64_t y = w->around_y > 0 ? w->around_y << -level : 0;
    return near_by(bmr_place_above(a->column, level - la), bmr_place_above(b->column, level - lb), x,
                   &image[0]) &&
           near_by(bmr_place_above(a->row, level - la), bmr_place_above(b->row, level - lb), y, &image[1]);
}

static const bmr_body_pair *pair_of(const bmr_world_body *a, const bmr_world_body *b,
                                    const int64_t image[2]) {
    for (const bmr_body_pair *c = a->first; c; c = c->after[bmr_body_pair_side(c, a)]) {
        const int sign = c->side[0] == a ? 1 : -1;
        if (c->side[1 - bmr_body_pair_side(c, a)] == b && sign * c->image[0] == image[0] &&
            sign * c->image[1] == image[1])
            return c;
    }
    return NULL;
}

/// Each two: if their cells are neighbours they are a pair, and if they are none their disks are apart. (Of
/// images only the nearest can meet: in a periodic box a body is smaller than a quarter of each side.)
static bmr_error audit_two(const bmr_world *w, const bmr_world_body *a, const bmr_world_body *b) {
    int64_t image[2];
    const bool neighbours = are_neighbours(w, a, b, image);
    const bmr_body_pair *c = pair_of(a, b, image);
    if (neighbours && (!c || !c->neighbours))
        return BMR_ERROR_INVALID_STRUCTURE;
    bmr_vec2 way =
        bmr_sub(bmr_path_position(&b->now.piece, w->time), bmr_path_position(&a->now.piece, w->time));
    int64_t nearest[2] = {0, 0};
    if (w->def.boundary == BMR_PERIODIC) {
        const bmr_vec2 size = bmr_sub(w->def.high, w->def.low);
        nearest[0] = (int64_t)floor(0.5 - way.x / size.x);
        nearest[1] = (int64_t)floor(0.5 - way.y / size.y);
        way = bmr_add(way, bmr_vec2_make((double)nearest[0] * size.x, (double)nearest[1] * size.y));
    }
    return hypot(way.x, way.y) > a->radius + b->radius + w->def.kds.margin || pair_of(a, b, nearest)
               ? BMR_OK
               : BMR_ERROR_FALSE_CERTIFICATE;
}

static bmr_error audit_pair(const bmr_world *w, const bmr_body_pair *c) {
    const bool disks = c->watch == BMR_WATCH_DISKS;
    if (disks != (c->near == NULL) || (disks && !c->neighbours))
        return BMR_ERROR_INVALID_STRUCTURE;
    if (next_event(w, &c->head) <= w->time) // it was not processed yet
        return BMR_OK;
    if (disks)
        return bmr_disks_distance(w, c, w->time) > (1.0 - ROUNDING) * bmr_disks_reach(w, c)
                   ? BMR_OK
                   : BMR_ERROR_FALSE_CERTIFICATE;
    if (c->watch == BMR_WATCH_PASSING)
        return BMR_OK;
    bmr_pair_view view;
    const bmr_pair_motion motion = bmr_body_pair_motion(w, c, &view);
    const bmr_pose pose = bmr_pair_instant(&motion, w->time).pose;
    return bmr_kds_in_contact(c->near->kds) ? BMR_ERROR_INVALID_STRUCTURE
                                            : bmr_kds_audit(c->near->kds, &pose);
}

static bmr_error audit_queue(const bmr_world *w) {
    for (size_t i = 0; i < w->queue.count; i++) {
        const bmr_event_entry *entry = &w->queue.heap[i], *above = &w->queue.heap[i ? (i - 1) / 2 : 0];
        if (entry->item->place != i || entry->time < above->time || !(entry->time < INFINITY))
            return BMR_ERROR_INVALID_STRUCTURE;
    }
    return BMR_OK;
}

/// A body's list of pairs, and its cell.
static bmr_error audit_body(const bmr_world *w, const bmr_world_body *r) {
    if (next_event(w, &r->head) > w->time && !in_cell(w, r))
        return BMR_ERROR_FALSE_CERTIFICATE;
    size_t pairs = 0;
    for (const bmr_body_pair *c = r->first; c; c = c->after[bmr_body_pair_side(c, r)], pairs++) {
        const bmr_error error = c->side[0] == r ? audit_pair(w, c) : BMR_OK;
        if (error != BMR_OK)
            return error;
    }
    return pairs == r->pairs ? BMR_OK : BMR_ERROR_INVALID_STRUCTURE;
}

bmr_error bmr_world_audit(const bmr_world *w) {
    if (!w)
        return BMR_ERROR_NULL_ARGUMENT;
    bmr_error error = audit_queue(w);
    for (size_t i = 0; i < w->places && error == BMR_OK; i++) {
        const bmr_world_body *a = w->bodies[i];
        if (!a)
            continue;
        error = audit_body(w, a);
        for (size_t j = i + 1; j < w->places && error == BMR_OK; j++)
            if (w->bodies[j])
                error = audit_two(w, a, w->bodies[j]);
    }
    return error;
}
