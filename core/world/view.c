// SPDX-License-Identifier: MIT
// Looking at a world: its bodies, pairs, cells, counts and totals.
#include <math.h>
#include <string.h>

#include "kinetic/motion.h"
#include "world/parts.h"

const char *bmr_world_event_name(bmr_world_event_kind kind) {
    static const char *const names[BMR_WORLD_EVENT_KIND_COUNT] = {"plan", "cross",   "near", "repair",
                                                                  "part", "contact", "leave"};
    return (unsigned)kind < BMR_WORLD_EVENT_KIND_COUNT ? names[kind] : NULL;
}

/// Of a cell's place: counted on in a periodic box, where it is that of a body.
static void cell_box(const bmr_world *w, int level, int64_t column, int64_t row, bmr_vec2 *low,
                     bmr_vec2 *high) {
    const double width = bmr_cell_width(w, level), height = bmr_cell_height(w, level);
    const bmr_vec2 base = w->def.boundary == BMR_PERIODIC ? w->def.low : bmr_vec2_make(0.0, 0.0);
    *low = bmr_add(base, bmr_vec2_make((double)column * width, (double)row * height));
    *high = bmr_add(base, bmr_vec2_make((double)(column + 1) * width, (double)(row + 1) * height));
}

bmr_error bmr_world_get(const bmr_world *w, bmr_body body, bmr_body_state *state) {
    if (!w || !state)
        return BMR_ERROR_NULL_ARGUMENT;
    const bmr_resident *r = bmr_world_find(w, body);
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
    state->user = r->user;
    state->radius = r->radius;
    state->pairs = r->couples;
    if (r->cell) {
        state->level = r->cell->level;
        cell_box(w, r->cell->level, r->column, r->row, &state->cell_low, &state->cell_high);
    }
    return BMR_OK;
}

size_t bmr_world_body_count(const bmr_world *w) {
    return w->counts.bodies;
}

bmr_body bmr_world_next_body(const bmr_world *w, size_t *place) {
    while (*place < w->places) {
        const bmr_resident *r = w->residents[(*place)++];
        if (r)
            return r->id;
    }
    return BMR_NO_BODY;
}

void bmr_world_each_pair(const bmr_world *w, void (*visit)(void *context, const bmr_world_pair *pair),
                         void *context) {
    for (size_t i = 0; i < w->places; i++) {
        const bmr_resident *r = w->residents[i];
        for (const bmr_couple *c = r ? r->first : NULL; c; c = c->after[bmr_couple_side(c, r)]) {
            if (c->side[0] != r)
                continue;
            bmr_world_pair pair;
            memset(&pair, 0, sizeof pair);
            pair.a = r->id;
            pair.b = c->side[1]->id;
            pair.watch = (bmr_watch)c->watch;
            pair.image = bmr_couple_shift(w, c);
            pair.reach = bmr_gate_reach(w, c);
            pair.next =
                c->head.item.place == BMR_NOT_QUEUED ? INFINITY : w->queue.heap[c->head.item.place].time;
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
            cell_box(w, c->level, c->column, c->row, &cell.low, &cell.high);
            visit(context, &cell);
        }
}

bmr_world_counts bmr_world_get_counts(const bmr_world *w) {
    bmr_world_counts counts = w->counts;
    counts.cells = w->cell_count;
    counts.queued = w->queue.count;
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
        const bmr_resident *r = w->residents[i];
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
