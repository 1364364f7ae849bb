// SPDX-License-Identifier: MIT
#include "boomerang/world.h"

#include <math.h>
#include <string.h>

#include "geometry/memory.h"
#include "world/parts.h"

/// Cells of the coarsest grid of a periodic box along its shorter side: with three, all nine cells around one
/// are different ones.
#define LEAST_AROUND 3.0
/// .. and along its longer side, at most.
#define MOST_AROUND 0x1p20

bmr_world_def bmr_default_world_def(void) {
    bmr_world_def def;
    memset(&def, 0, sizeof def);
    bmr_kds_find("hybrid", &def.structure);
    def.kds = bmr_default_kds_def();
    def.kds.hysteresis = def.kds.margin;
    def.failure = bmr_default_failure_options();
    def.response.kind = BMR_RESPONSE_IMPULSE;
    def.response.restitution = 1.0;
    def.zeno_speed = 1e-2;
    def.contact_step = 0.1;
    return def;
}

bmr_body_def bmr_default_body_def(const bmr_shape *shape, const bmr_motion *motion) {
    bmr_body_def def = {shape, motion, INFINITY, INFINITY};
    bmr_mass mass;
    if (shape && shape->polygon && bmr_polygon_mass(shape->polygon, &mass) == BMR_OK) {
        def.mass = mass.area;
        def.inertia = mass.inertia + mass.area * bmr_dot(mass.centroid, mass.centroid);
    }
    return def;
}

// ---- creation ----

static bmr_error check_box(const bmr_world_def *def) {
    if (def->boundary == BMR_OPEN)
        return BMR_OK;
    const double width = def->high.x - def->low.x, height = def->high.y - def->low.y;
    if (!isfinite(width) || !isfinite(height) || !isfinite(def->low.x + def->low.y))
        return BMR_ERROR_NOT_FINITE;
    const double most =
        fmax(fmax(fabs(def->low.x), fabs(def->high.x)), fmax(fabs(def->low.y), fabs(def->high.y)));
    const bool fits = width > 0.0 && height > 0.0 && most <= BMR_MAX_COORDINATE / 4.0 &&
                      fmin(width, height) >= 64.0 * BMR_MIN_SIDE;
    const double longer = fmax(width, height), shorter = fmin(width, height);
    return fits && longer / shorter < MOST_AROUND ? BMR_OK : BMR_ERROR_OUT_OF_RANGE;
}

/// The shortest steps from sample to sample of a pair that passes are this part of contact_step
/// (pair_motion.c); steps below the tolerance, with which times are found, say nothing, and are without end.
#define LEAST_STEP_PART 1e-3

static bmr_error check_def(const bmr_world_def *def) {
    const double numbers[] = {def->failure.tolerance,    def->contact_step, def->zeno_speed,
                              def->response.restitution, def->kds.margin,   def->kds.hysteresis};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        if (!isfinite(numbers[i]))
            return BMR_ERROR_NOT_FINITE;
    const bool makes_sense =
        def->failure.tolerance > 0.0 && LEAST_STEP_PART * def->contact_step >= def->failure.tolerance &&
        def->zeno_speed > 0.0 && def->response.restitution >= 0.0 && def->response.restitution <= 1.0 &&
        (unsigned)def->response.kind < BMR_RESPONSE_KIND_COUNT && (unsigned)def->zeno <= BMR_ZENO_ELASTIC &&
        (unsigned)def->boundary <= BMR_PERIODIC && def->kds.margin > 0.0 && def->kds.hysteresis >= 0.0 &&
        def->structure->domain == BMR_KDS_RIGID;
    return makes_sense ? check_box(def) : BMR_ERROR_OUT_OF_RANGE;
}

/// Cells around a periodic box: as near to squares as whole numbers allow. With all pairs there are three by
/// three, of which each is every other's neighbour: of each two bodies, whatever the box's shape, the images
/// that can meet are a pair. (The others are more than a cell less its hysteresis apart, 7/24 of a side, and
/// no reach is that long: bodies are smaller than a quarter of the shorter one.)
static void lay_grid(bmr_world *w) {
    const double width = w->def.high.x - w->def.low.x, height = w->def.high.y - w->def.low.y;
    const double size = fmin(width, height) / LEAST_AROUND;
    const bool all = w->def.all_pairs;
    w->around_x = (int64_t)(all ? LEAST_AROUND : fmax(LEAST_AROUND, floor(width / size)));
    w->around_y = (int64_t)(all ? LEAST_AROUND : fmax(LEAST_AROUND, floor(height / size)));
    w->unit_x = width / (double)w->around_x;
    w->unit_y = height / (double)w->around_y;
}

/// Bodies first, and each kind by births, so that events of one time have an order.
static bool is_before(const bmr_event_item *a, const bmr_event_item *b) {
    const bmr_scheduled *const first = (const void *)a, *const second = (const void *)b;
    if (first->is_pair != second->is_pair)
        return second->is_pair;
    if (!first->is_pair) {
        const bmr_world_body *p = (const void *)a, *q = (const void *)b;
        return p->birth < q->birth;
    }
    const bmr_body_pair *p = (const void *)a, *q = (const void *)b;
    for (int i = 0; i < 2; i++)
        if (p->side[i]->birth != q->side[i]->birth)
            return p->side[i]->birth < q->side[i]->birth;
    return p->image[0] != q->image[0] ? p->image[0] < q->image[0] : p->image[1] < q->image[1];
}

bmr_error bmr_world_create(const bmr_world_def *def, double time, const bmr_allocator *allocator,
                           bmr_world **world) {
    if (!def || !def->structure || !world)
        return BMR_ERROR_NULL_ARGUMENT;
    if (!isfinite(time))
        return BMR_ERROR_NOT_FINITE;
    const bmr_error error = check_def(def);
    if (error != BMR_OK)
        return error;
    bmr_world *w = bmr_allocate(allocator, sizeof *w);
    if (!w)
        return BMR_ERROR_NO_MEMORY;
    memset(w, 0, sizeof *w);
    w->allocator = allocator;
    w->counted = (bmr_allocator){bmr_world_take, bmr_world_give, w};
    w->counts.bytes = w->counts.most_bytes = sizeof *w;
    w->def = *def;
    w->time = time;
    w->queue.before = is_before;
    w->trouble.a = w->trouble.b = BMR_NO_BODY;
    if (def->boundary == BMR_PERIODIC)
        lay_grid(w);
    if (def->boundary == BMR_WALLED)
        bmr_walls_make(w);
    *world = w;
    return BMR_OK;
}

void bmr_world_destroy(bmr_world *w) {
    if (!w || w->inside)
        return;
    for (size_t i = 0; i < w->places; i++)
        if (w->bodies[i])
            bmr_body_destroy(w, w->bodies[i]);
    bmr_walls_destroy(w);
    bmr_world_give(w, w->bodies, w->capacity * BMR_PLACE_BYTES);
    bmr_world_give(w, w->candidates, w->candidate_capacity * sizeof *w->candidates);
    bmr_world_give(w, w->table, w->table_size * sizeof(bmr_cell *));
    bmr_world_give(w, w->queue.heap, w->queue.capacity * sizeof *w->queue.heap);
    bmr_release(w->allocator, w, sizeof *w);
}

// ---- running ----

/// Names who is concerned, where nobody else did.
static bmr_error take_event(bmr_world *w) {
    bmr_scheduled *const item = (bmr_scheduled *)(void *)w->queue.heap[0].item;
    w->time = fmax(w->time, w->queue.heap[0].time);
    const bmr_body_pair *const pair = item->is_pair ? (void *)item : NULL;
    const bmr_body a = pair ? pair->side[0]->id : ((bmr_world_body *)(void *)item)->id;
    const bmr_body b = pair ? pair->side[1]->id : BMR_NO_BODY;
    bool touches = false;
    bmr_error error =
        item->is_pair ? bmr_body_pair_event(w, (void *)item, &touches) : bmr_body_event(w, (void *)item);
    if (touches)
        error = bmr_contact_report(w, (void *)item);
    return error != BMR_OK && w->trouble.kind == BMR_TROUBLE_NONE
               ? bmr_world_stop(w, error, BMR_TROUBLE_OTHER, a, b)
               : error;
}

bmr_error bmr_world_advance(bmr_world *w, double until) {
    if (!w)
        return BMR_ERROR_NULL_ARGUMENT;
    if (!isfinite(until))
        return BMR_ERROR_NOT_FINITE;
    if (w->inside || until < w->time)
        return BMR_ERROR_OUT_OF_RANGE;
    w->inside = true;
    bmr_world_stop(w, BMR_OK, BMR_TROUBLE_NONE, BMR_NO_BODY, BMR_NO_BODY);
    bmr_error error = BMR_OK;
    for (uint64_t events = 0; error == BMR_OK && bmr_event_queue_time(&w->queue) <= until; events++)
        error = events < w->def.most_events || w->def.most_events == 0
                    ? take_event(w)
                    : bmr_world_stop(w, BMR_ERROR_OUT_OF_RANGE, BMR_TROUBLE_EVENTS, BMR_NO_BODY, BMR_NO_BODY);
    if (error == BMR_OK) {
        w->time = until;
        bmr_world_stop(w, BMR_OK, BMR_TROUBLE_NONE, BMR_NO_BODY, BMR_NO_BODY); // what was wrong is gone
    }
    w->inside = false;
    return error;
}

double bmr_world_time(const bmr_world *w) {
    return w->time;
}
