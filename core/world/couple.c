// SPDX-License-Identifier: MIT
// The life of a pair: disks that are apart, a structure, contacts, and disks again.
//
// All of it is a function of the two motions and of what was answered: no time here depends on how far the
// world is to advance, or on when the two became neighbours. So a couple that a grid finds late has the same
// contacts, to the bit, as one that was watched all along.
#include <math.h>
#include <string.h>

#include "kds/structure.h"
#include "kinetic/failure.h"
#include "world/parts.h"

/// The margin is halved at most so often: 2^-20 of it is below what structures can tell.
#define MOST_HALVINGS 20u
/// Repairs this near to one another are a burst.
#define BURST_TOLERANCES 4.0
/// A condition that failed, and is not yet seen to, is looked for over so many margins' way: as long as two
/// that fly through each other are in contact.
#define NUDGE_MARGINS 2.0
/// A search takes what is too close to call where it begins for a failure there. By so many margins' way, and
/// no more, may a failure be told too early.
#define EARLY_MARGINS 0.125
/// A structure may want a pair a little farther apart than the distance at which a contact ends. It is asked
/// again after a tolerance, two, four, and so on, so many times.
#define LEAVE_RETRIES 30

// ---- making ----

bmr_error bmr_couple_make(bmr_world *w, bmr_resident *a, bmr_resident *b, const int32_t image_of_b[2],
                          bmr_couple **couple) {
    bmr_couple *c = bmr_world_take(w, sizeof *c);
    if (!c)
        return BMR_ERROR_NO_MEMORY;
    const bmr_error error = bmr_event_queue_promise(&w->queue, &w->counted);
    if (error != BMR_OK) {
        bmr_world_give(w, c, sizeof *c);
        return error;
    }
    memset(c, 0, sizeof *c);
    const int sign = a->birth < b->birth ? 1 : -1; // walls were born last
    c->head.item.place = BMR_NOT_QUEUED;
    c->head.is_couple = true;
    c->side[0] = sign > 0 ? a : b;
    c->side[1] = sign > 0 ? b : a;
    c->image[0] = sign * image_of_b[0];
    c->image[1] = sign * image_of_b[1];
    c->watch = BMR_WATCH_DISKS;
    c->neighbours = true;
    *couple = c;
    return BMR_OK;
}

void bmr_couple_link(bmr_world *w, bmr_couple *c) {
    for (int i = 0; i < 2; i++) {
        bmr_resident *const r = c->side[i];
        c->after[i] = r->first;
        if (r->first)
            r->first->before[bmr_couple_side(r->first, r)] = c;
        r->first = c;
        r->couples++;
    }
    c->linked = true;
    w->counts.pairs++;
    w->counts.candidates++;
}

static void unlink_couple(bmr_world *w, bmr_couple *c) {
    for (int i = 0; i < 2; i++) {
        bmr_resident *const r = c->side[i];
        if (c->before[i])
            c->before[i]->after[bmr_couple_side(c->before[i], r)] = c->after[i];
        else
            r->first = c->after[i];
        if (c->after[i])
            c->after[i]->before[bmr_couple_side(c->after[i], r)] = c->before[i];
        r->couples--;
    }
    w->counts.pairs--;
}

static void set_watch(bmr_world *w, bmr_couple *c, bmr_watch watch) {
    w->counts.near -= c->watch == BMR_WATCH_STRUCTURE;
    w->counts.passing -= c->watch == BMR_WATCH_PASSING;
    w->counts.near += watch == BMR_WATCH_STRUCTURE;
    w->counts.passing += watch == BMR_WATCH_PASSING;
    c->watch = (uint8_t)watch;
}

static void end_structure(bmr_world *w, bmr_couple *c) {
    if (!c->near)
        return;
    bmr_kds_destroy(c->near->kds, &w->counted);
    bmr_world_give(w, c->near, sizeof *c->near);
    c->near = NULL;
}

void bmr_couple_destroy(bmr_world *w, bmr_couple *c) {
    if (w->busy == c)
        w->busy = NULL;
    if (c->linked)
        unlink_couple(w, c);
    set_watch(w, c, BMR_WATCH_DISKS);
    end_structure(w, c);
    bmr_event_queue_set(&w->queue, &c->head.item, INFINITY);
    bmr_event_queue_release(&w->queue, &w->counted);
    bmr_world_give(w, c, sizeof *c);
}

bool bmr_item_before(const bmr_event_item *a, const bmr_event_item *b) {
    const bmr_scheduled *const first = (const void *)a, *const second = (const void *)b;
    if (first->is_couple != second->is_couple)
        return second->is_couple;
    if (!first->is_couple) {
        const bmr_resident *p = (const void *)a, *q = (const void *)b;
        return p->birth < q->birth;
    }
    const bmr_couple *p = (const void *)a, *q = (const void *)b;
    for (int i = 0; i < 2; i++)
        if (p->side[i]->birth != q->side[i]->birth)
            return p->side[i]->birth < q->side[i]->birth;
    return p->image[0] != q->image[0] ? p->image[0] < q->image[0] : p->image[1] < q->image[1];
}

// ---- events ----

/// Too many repairs of one pair, each within next to no time of the one before.
static bool is_burst(const bmr_world *w, bmr_near *n, double time) {
    n->burst =
        time - n->last_repair <= BURST_TOLERANCES * bmr_couple_tolerance(w, n, time) ? n->burst + 1 : 0;
    n->last_repair = time;
    return n->burst > BMR_WORLD_BURST;
}

static void count(bmr_world *w, const bmr_kds_report *report) {
    w->counts.kds_events[report->kind]++;
    w->counts.touched += report->touched;
}

static void observe(bmr_world *w, const bmr_couple *c, bmr_world_event_kind kind,
                    const bmr_kds_report *report) {
    bmr_world_observe(w, kind, w->time, c->side[0]->id, c->side[1]->id, report);
}

static double margin_of(const bmr_world *w, unsigned rung) {
    return w->def.kds.margin * exp2(-(double)rung / bmr_rungs_a_halving(w));
}

/// A proof from nothing with the margin of the couple's rung; false: contact.
static bool start(bmr_world *w, bmr_couple *c, double time, bmr_kds_report *report) {
    bmr_near *const n = c->near;
    bmr_couple_view view;
    const bmr_pair_motion motion = bmr_couple_motion(w, c, &view);
    const bmr_instant now = bmr_pair_instant(&motion, time);
    n->kds->def.hysteresis = 0.0; // the world's own: see rise
    n->kds->def.margin = margin_of(w, n->rung);
    bmr_kds_start(n->kds, &now, report);
    n->from = n->repaired = time;
    return report->apart;
}

static double separation(const bmr_world *w, const bmr_couple *c, double time) {
    bmr_couple_view view;
    const bmr_pair_motion motion = bmr_couple_motion(w, c, &view);
    return bmr_pair_separation(&motion, time);
}

/// The disks have met: a structure begins.
static bmr_error meet(bmr_world *w, bmr_couple *c) {
    if (bmr_couple_too_fast(w, c))
        return bmr_couple_stop(w, c, BMR_ERROR_OUT_OF_RANGE, BMR_TROUBLE_SPEED);
    bmr_near *const n = bmr_world_take(w, sizeof *n);
    if (!n)
        return BMR_ERROR_NO_MEMORY;
    memset(n, 0, sizeof *n);
    const bmr_error error = bmr_kds_create(w->def.structure, &w->def.kds, bmr_couple_shape(c, 0),
                                           bmr_couple_shape(c, 1), &w->counted, &n->kds);
    if (error != BMR_OK) {
        bmr_world_give(w, n, sizeof *n);
        return error;
    }
    n->last_repair = -INFINITY;
    n->rise = INFINITY;
    n->part = NAN;
    c->near = n;
    set_watch(w, c, BMR_WATCH_STRUCTURE);
    bmr_kds_report report;
    const bool apart = start(w, c, w->time, &report);
    count(w, &report);
    if (!apart)
        return bmr_contact_tell(w, c, true);
    bmr_couple_search_later(w, c, false);
    observe(w, c, BMR_WORLD_NEAR, &report);
    return BMR_OK;
}

static bmr_error part(bmr_world *w, bmr_couple *c) {
    end_structure(w, c);
    set_watch(w, c, BMR_WATCH_DISKS);
    const bmr_body a = c->side[0]->id, b = c->side[1]->id;
    if (c->neighbours)
        bmr_couple_search_later(w, c, false);
    else
        bmr_couple_destroy(w, c);
    bmr_world_observe(w, BMR_WORLD_PART, w->time, a, b, NULL);
    return BMR_OK;
}

/// When the condition fails, where that is known better than by the search: at `later` it does.
static double failure_between(const bmr_world *w, const bmr_near *n, const bmr_pair_motion *motion,
                              double later) {
    double sooner = w->time;
    while (later - sooner > bmr_couple_tolerance(w, n, later)) {
        const double middle = sooner + 0.5 * (later - sooner);
        const bmr_pose pose = bmr_pair_instant(motion, middle).pose;
        *(bmr_condition_value(&n->condition, &pose) > 0.0 ? &sooner : &later) = middle;
    }
    return later;
}

static bmr_error fail(bmr_world *w, bmr_couple *c) {
    bmr_near *const n = c->near;
    bmr_couple_view view;
    const bmr_pair_motion motion = bmr_couple_motion(w, c, &view);
    const double later = bmr_repair_time(&motion, &n->condition, w->time, bmr_couple_tolerance(w, n, w->time),
                                         NUDGE_MARGINS * w->def.kds.margin / n->speed);
    const bmr_instant now = bmr_pair_instant(&motion, later);
    if ((later - w->time) * n->speed > EARLY_MARGINS * w->def.kds.margin &&
        !(bmr_condition_value(&n->condition, &now.pose) > 0.0)) {
        w->counts.looks++;
        bmr_couple_schedule(w, c, BMR_COUPLE_FAIL, failure_between(w, n, &motion, later));
        return BMR_OK;
    }
    if (is_burst(w, n, w->time)) {
        bmr_couple_pass(w, c);
        return bmr_couple_stop(w, c, BMR_ERROR_STALLED, BMR_TROUBLE_REPAIRS);
    }
    bmr_kds_report report;
    bmr_kds_repair(n->kds, &now, n->failing, &report);
    count(w, &report);
    n->rhythm = fmax(later - n->repaired, 0.5 * n->rhythm);
    n->from = n->repaired = later;
    n->window = BMR_COUPLE_AHEAD * n->rhythm;
    if (report.kind == BMR_KDS_CONTACT)
        return bmr_contact_tell(w, c, false);
    bmr_couple_search_later(w, c, false);
    observe(w, c, BMR_WORLD_REPAIR, &report);
    return BMR_OK;
}

/// The lowest rung whose margin a pair at this separation has twice; of the ground, all of the hysteresis.
static unsigned rung_for(const bmr_world *w, double separation, unsigned rung) {
    const double ground = w->def.kds.margin + fmax(w->def.kds.margin, w->def.kds.hysteresis);
    unsigned lowest = 0;
    while (lowest < rung && !(separation > (lowest == 0 ? ground : 2.0 * margin_of(w, lowest))))
        lowest++;
    return lowest;
}

/// A pair that was in contact gets its margin back, as much of it as it is apart by; until it has all of it
/// it is asked again, each time after twice as long.
static bmr_error rise(bmr_world *w, bmr_couple *c) {
    bmr_near *const n = c->near;
    w->counts.looks++;
    n->rise_step = fmax(2.0 * n->rise_step, 2.0 * bmr_world_tolerance(w, w->time));
    n->rise = fmax(w->time + n->rise_step, nextafter(w->time, INFINITY));
    const unsigned before = n->rung, lower = rung_for(w, separation(w, c, w->time), before);
    if (lower < before) {
        bmr_kds_report report;
        n->rung = lower;
        bool apart = start(w, c, w->time, &report);
        if (!apart) {
            n->rung = before;
            apart = start(w, c, w->time, &report);
        }
        count(w, &report);
        if (!apart) { // apart, and no proof of it
            bmr_couple_pass(w, c);
            return bmr_couple_stop(w, c, BMR_ERROR_STALLED, BMR_TROUBLE_PROOF);
        }
        if (n->rung == 0) {
            n->rise = INFINITY;
            n->again = 0;
        }
    }
    bmr_couple_search_later(w, c, false);
    return BMR_OK;
}

/// A pair that passed is apart.
static bmr_error leave(bmr_world *w, bmr_couple *c) {
    bmr_near *const n = c->near;
    bmr_kds_report report;
    n->rung = 0;
    const double target = w->def.kds.margin + w->def.kds.hysteresis;
    if (separation(w, c, w->time) > target && start(w, c, w->time, &report)) {
        count(w, &report);
        n->again = n->retries = 0;
        n->rise = INFINITY;
        set_watch(w, c, BMR_WATCH_STRUCTURE);
        bmr_couple_search_later(w, c, false);
        observe(w, c, BMR_WORLD_LEAVE, &report);
        return BMR_OK;
    }
    n->from = w->time;
    if (n->retries++ < LEAVE_RETRIES) {
        bmr_couple_schedule(w, c, BMR_COUPLE_LEAVE,
                            w->time + ldexp(bmr_world_tolerance(w, w->time), (int)n->retries));
        return BMR_OK;
    }
    n->retries = 0;
    return bmr_couple_search(w, c);
}

bmr_error bmr_couple_event_due(bmr_world *w, bmr_couple *c) {
    switch ((bmr_couple_event)c->event) {
    case BMR_COUPLE_MEET:
        return meet(w, c);
    case BMR_COUPLE_FAIL:
        return fail(w, c);
    case BMR_COUPLE_PART:
        return part(w, c);
    case BMR_COUPLE_TOUCH:
        c->near->touches = c->near->touch == w->time ? c->near->touches + 1 : 1;
        c->near->touch = w->time;
        return bmr_contact_tell(w, c, false);
    case BMR_COUPLE_RISE:
        return rise(w, c);
    case BMR_COUPLE_LEAVE:
        return leave(w, c);
    case BMR_COUPLE_LOOK:
        break;
    }
    w->counts.looks++;
    return bmr_couple_search(w, c);
}

// ---- after a contact ----

void bmr_couple_hold(bmr_world *w, bmr_couple *c) {
    set_watch(w, c, BMR_WATCH_PASSING);
    bmr_event_queue_set(&w->queue, &c->head.item, INFINITY);
}

bmr_error bmr_couple_pass(bmr_world *w, bmr_couple *c) {
    bmr_near *const n = c->near;
    set_watch(w, c, BMR_WATCH_PASSING);
    c->stuck = false;
    n->from = n->repaired = w->time;
    n->part = NAN;
    n->rise = INFINITY;
    n->retries = 0;
    bmr_couple_search_later(w, c, false);
    return BMR_OK;
}

bmr_error bmr_couple_resume(bmr_world *w, bmr_couple *c, bool placed, double receding) {
    bmr_near *const n = c->near;
    bmr_kds_report report;
    n->again++;
    // At a TOUCH they are where they were: the margin that they have will do.
    for (n->rung += c->event != BMR_COUPLE_TOUCH; n->rung <= MOST_HALVINGS * bmr_rungs_a_halving(w);
         n->rung++) {
        const bool apart = start(w, c, w->time, &report);
        count(w, &report);
        if (!apart)
            continue;
        const double room = 2.0 * margin_of(w, n->rung - 1);
        bmr_couple_view view;
        const bmr_pair_motion motion = bmr_couple_motion(w, c, &view);
        const double most = bmr_couple_natural_time(w, c, &motion, w->time);
        n->part = NAN;
        n->window = 0.0;
        n->rhythm = 0.0;
        n->rise_step = receding * most > room ? room / receding : most;
        n->rise = w->time + fmax(n->rise_step, 2.0 * bmr_world_tolerance(w, w->time));
        set_watch(w, c, BMR_WATCH_STRUCTURE);
        bmr_couple_search_later(w, c, false);
        return BMR_OK;
    }
    // Overlapping bodies were put there: they pass, until they are apart.
    const bmr_error error = bmr_couple_pass(w, c);
    return placed ? error : bmr_couple_stop(w, c, BMR_ERROR_STALLED, BMR_TROUBLE_CONTACTS);
}
