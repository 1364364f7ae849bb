// SPDX-License-Identifier: MIT
// The life of a pair: disks that are apart, a structure, contacts, and disks again.
//
// All of it is a function of the two motions and of what was answered: no time here depends on how far the
// world is to advance, or on when the two became neighbours. So a pair that a grid finds late has the same
// contacts, to the bit, as one that was watched all along.
#include <float.h>
#include <math.h>
#include <string.h>

#include "geometry/length.h"
#include "kds/structure.h"
#include "kinetic/failure.h"
#include "world/parts.h"

/// The margin is halved at most so often: 2^-20 of it is below what structures can tell.
#define MOST_HALVINGS 20u
/// Repairs this near to one another are a burst.
#define BURST_TOLERANCES 4.0
/// A condition that failed, and is not yet repaired, is searched for over so many margins' way: as long as
/// two that fly through each other are in contact.
#define NUDGE_MARGINS 2.0
/// A search takes what is too close to call where it begins for a failure there. By so many margins' way, and
/// no more, may a failure be reported too early.
#define EARLY_MARGINS 0.125
/// A structure may want a pair a little farther apart than the distance at which a contact ends. It is asked
/// again after a tolerance, two, four, and so on, so many times.
#define LEAVE_RETRIES 30

// ---- when something happens next: to its disks, to its structure's conditions, and how exactly ----

/// The first failure is searched for in this part of the time in which the two can move by their reach, then
/// in twice that.
#define FIRST_PART 0x1p-3
/// Windows that one search goes through before the pair is put back into the queue.
#define WINDOWS 6
/// A pair that passes is sampled step by step: so many steps ahead, for most pairs are soon sent elsewhere.
#define PASSING_STEPS 8.0
/// Times are found so exactly that meanwhile no point moves by more than this part of the margin, but no more
/// exactly than to so many roundings of the clock. Two that fly through each other are within the margin for
/// two margins' way, so where these roundings are a margin's way at most nobody is missed; where they are
/// more, the pair is stopped.
#define TOLERANCE_PART 0x1p-4
#define CLOCK_ROUNDINGS 4.0
/// A hit goes through a row of bodies that lie on each other in no time. A pair may be reported so often at
/// one time; then its distance must shrink before it is reported again.
#define MOST_TOUCHES 256
/// The next failure is searched for in so many times the time between the last two, then in twice that.
#define AHEAD 4.0
/// What is too fast over one window is searched over so much of it.
#define SHORTER 0x1p-4

/// The time in which the two can move by their reach, at the speeds they have.
static double natural_time(const bmr_world *w, const bmr_body_pair *c, double time) {
    bmr_pair_view view;
    const bmr_pair_motion motion = bmr_body_pair_motion(w, c, &view);
    const bmr_instant now = bmr_pair_instant(&motion, time);
    const double radii = c->side[0]->radius + c->side[1]->radius; // a wall's is 0
    const double speed = bmr_length(now.velocity) + fabs(now.spin) * radii;
    const double scale = bmr_disks_reach(w, c) / speed;
    return scale > 0.0 && scale < INFINITY ? scale : fmax(1.0, fabs(time));
}

/// It has its next event then, not before the present time. INFINITY: never.
static void schedule(bmr_world *w, bmr_body_pair *c, bmr_pair_due event, double time) {
    c->event = (uint8_t)event;
    bmr_event_queue_set(&w->queue, &c->head.item, time < INFINITY ? fmax(time, w->time) : time);
}

/// OUT_OF_RANGE of a question about the disks: so fast, or so long after their epoch, that they cannot be
/// told apart from disks that meet.
static bmr_error disks_error(bmr_world *w, const bmr_body_pair *c, bmr_error error) {
    return error == BMR_ERROR_OUT_OF_RANGE ? bmr_body_pair_stop(w, c, error, BMR_TROUBLE_SPEED) : error;
}

static bmr_error search_disks(bmr_world *w, bmr_body_pair *c) {
    double time;
    bool unfinished;
    w->counts.disk_times++;
    const bmr_error error = bmr_disks_next(w, c, true, w->time, &time, &unfinished);
    if (error == BMR_OK)
        schedule(w, c, unfinished ? BMR_DUE_SEARCH : BMR_DUE_MEET, time);
    return disks_error(w, c, error);
}

/// When the structure is not needed any more; part_known: not before `part`, where it is to be asked again.
static bmr_error find_part(bmr_world *w, bmr_body_pair *c) {
    bmr_near *const n = c->near;
    if (!isnan(n->part) && (n->part_known || n->part > n->from))
        return BMR_OK;
    w->counts.disk_times++;
    bool unfinished;
    bmr_error error = bmr_disks_next(w, c, false, n->from, &n->part, &unfinished);
    // Who parts as soon as they meet would meet again, and so on: a loop, or a contact that nobody saw.
    if (error == BMR_OK && !unfinished && n->part <= n->from &&
        bmr_disks_distance(w, c, n->from) <= bmr_disks_reach(w, c))
        error = BMR_ERROR_OUT_OF_RANGE;
    n->part_known = error == BMR_OK && !unfinished;
    if (error != BMR_OK)
        n->part = NAN;
    return disks_error(w, c, error);
}

/// How exactly the pair's times are to be found: as the def says, and the faster it is the more exactly, down
/// to the clock's own rounding.
static double tolerance(const bmr_world *w, const bmr_near *n, double time) {
    const double fine = TOLERANCE_PART * w->def.kds.margin / n->speed;
    return fmax(CLOCK_ROUNDINGS * DBL_EPSILON * fabs(time), fmin(bmr_world_tolerance(w, time), fine));
}

/// Bound of the speed of any point of one as seen from the other. 0: none is known, near a pole of a rational
/// rotation (motion.h), where the search's own limits are what there is.
static double speed_over(const bmr_pair_motion *motion, double from, double to) {
    const double speed = bmr_pair_speed(motion, from, to);
    return isfinite(speed) ? speed : 0.0;
}

/// Until when (and since when) the clock can tell the times of a pair of such a speed apart.
static double clock_end(const bmr_world *w, double speed) {
    return w->def.kds.margin / (CLOCK_ROUNDINGS * DBL_EPSILON * speed);
}

/// The first failure of the structure's conditions, or the end of a contact that was passed, in (from, to].
static bmr_error find_event(bmr_world *w, bmr_body_pair *c, const bmr_pair_motion *motion, double from,
                            double to, double *time) {
    bmr_near *const n = c->near;
    if (c->watch == BMR_WATCH_PASSING) {
        const double target = w->def.kds.margin + w->def.kds.hysteresis;
        *time = bmr_pair_leaves(motion, from, to, target, w->def.contact_step, bmr_world_tolerance(w, from));
        return isnan(*time) ? BMR_ERROR_OUT_OF_RANGE : BMR_OK;
    }
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    const size_t count = bmr_kds_conditions(n->kds, conditions);
    w->counts.failure_times += count;
    const bmr_failure_options options = {tolerance(w, n, from) / fmax(1.0, fabs(from))};
    const bmr_error error =
        bmr_first_failure(conditions, count, motion->a, motion->b, from, to, &options, time, &n->failing);
    if (error == BMR_OK && *time < INFINITY)
        n->condition = conditions[n->failing];
    return error;
}

/// Sets the speed from n->from to *to, which is made earlier where the pair is so fast only later on that the
/// clock is too coarse. False: it is from the beginning.
static bool is_slow_enough(const bmr_world *w, bmr_near *n, const bmr_pair_motion *motion, double *to) {
    const double soonest = nextafter(n->from, INFINITY);
    for (;; *to = fmax(soonest, n->from + SHORTER * (*to - n->from))) {
        n->speed = speed_over(motion, n->from, *to);
        const double last = clock_end(w, n->speed);
        if (fabs(n->from) < last) {
            *to = fmin(*to, last);
            return true;
        }
        if (!(*to > soonest))
            return false;
    }
}

static bmr_error search_near(bmr_world *w, bmr_body_pair *c) {
    bmr_near *const n = c->near;
    n->from = fmax(n->from, w->time);
    const bmr_error error = find_part(w, c);
    if (error != BMR_OK)
        return error;
    bmr_pair_view view;
    const bmr_pair_motion motion = bmr_body_pair_motion(w, c, &view);
    if (!(n->window > 0.0))
        n->window = FIRST_PART * natural_time(w, c, n->from);
    const double pieces = fmin(c->side[0]->until, c->side[1]->until);
    const double horizon = fmin(n->part, fmin(n->growth, pieces));
    const bool passing = c->watch == BMR_WATCH_PASSING;
    if (passing)
        n->window = PASSING_STEPS * fmax(w->def.contact_step, bmr_world_tolerance(w, n->from));
    for (int i = 0; i < (passing ? 1 : WINDOWS) && n->from < horizon; i++, n->window *= 2.0) {
        double to = fmin(horizon, fmin(DBL_MAX, fmax(n->from + n->window, nextafter(n->from, INFINITY))));
        if (!passing && !is_slow_enough(w, n, &motion, &to)) {
            if (n->from > w->time)
                break;
            return bmr_body_pair_stop(w, c, BMR_ERROR_OUT_OF_RANGE, BMR_TROUBLE_SPEED);
        }
        double time;
        const bmr_error failed = find_event(w, c, &motion, n->from, to, &time);
        if (failed != BMR_OK)
            return failed;
        if (time < INFINITY) {
            schedule(w, c, passing ? BMR_DUE_LEAVE : BMR_DUE_FAIL, time);
            return BMR_OK;
        }
        n->from = to;
    }
    if (n->from < horizon)
        schedule(w, c, BMR_DUE_SEARCH, n->from);
    else if (horizon == n->part)
        schedule(w, c, n->part_known ? BMR_DUE_PART : BMR_DUE_SEARCH, n->part);
    else if (horizon == n->growth)
        schedule(w, c, BMR_DUE_GROWTH, n->growth);
    else // the next piece is an event of its body, and comes first
        schedule(w, c, BMR_DUE_SEARCH, pieces);
    return BMR_OK;
}

/// Finds its next event after the present time.
static bmr_error search(bmr_world *w, bmr_body_pair *c) {
    return c->near ? search_near(w, c) : search_disks(w, c);
}

/// ZENO_ELASTIC: are two that touched, and are still within the margin, driven together by more than
/// zeno_speed? They are bodies that lie on each other, and one of them was hit.
static bool is_driven_together(const bmr_world *w, const bmr_body_pair *c) {
    const bmr_near *const n = c->near;
    if (w->def.zeno != BMR_ZENO_ELASTIC || c->watch != BMR_WATCH_STRUCTURE || n->level == 0 ||
        (n->touch == w->time && n->touches >= MOST_TOUCHES))
        return false;
    bmr_touch touch;
    bmr_touch_describe(w, c, &touch);
    const bmr_contact *const contact = &touch.contact;
    const double approach =
        contact->count == 2 ? fmin(contact->approach[0], contact->approach[1]) : contact->approach[0];
    return contact->distance <= w->def.kds.margin && -approach > w->def.zeno_speed;
}

void bmr_body_pair_search_later(bmr_world *w, bmr_body_pair *c, bool replan) {
    if (replan && c->near) {
        bmr_near *const n = c->near;
        n->from = n->repaired;
        n->part = NAN;
        n->window = AHEAD * n->period;
        if (is_driven_together(w, c)) {
            schedule(w, c, BMR_DUE_TOUCH, w->time);
            return;
        }
    }
    if (search(w, c) != BMR_OK)
        schedule(w, c, BMR_DUE_SEARCH, w->time);
}

// ---- making ----

bmr_error bmr_body_pair_make(bmr_world *w, bmr_world_body *a, bmr_world_body *b, const int32_t image_of_b[2],
                             bmr_body_pair **pair) {
    bmr_scheduled *head;
    const bmr_error error = bmr_scheduled_make(w, sizeof(bmr_body_pair), true, &head);
    if (error != BMR_OK)
        return error;
    bmr_body_pair *const c = (void *)head;
    const int sign = a->birth < b->birth ? 1 : -1; // walls were born last
    c->side[0] = sign > 0 ? a : b;
    c->side[1] = sign > 0 ? b : a;
    c->image[0] = sign * image_of_b[0];
    c->image[1] = sign * image_of_b[1];
    c->neighbours = true;
    *pair = c;
    return BMR_OK;
}

void bmr_body_pair_link(bmr_world *w, bmr_body_pair *c) {
    for (int i = 0; i < 2; i++) {
        bmr_world_body *const r = c->side[i];
        c->after[i] = r->first;
        if (r->first)
            r->first->before[bmr_body_pair_side(r->first, r)] = c;
        r->first = c;
        r->pairs++;
    }
    c->linked = true;
    w->counts.pairs++;
    w->counts.candidates++;
}

static void unlink_pair(bmr_world *w, bmr_body_pair *c) {
    for (int i = 0; i < 2; i++) {
        bmr_world_body *const r = c->side[i];
        if (c->before[i])
            c->before[i]->after[bmr_body_pair_side(c->before[i], r)] = c->after[i];
        else
            r->first = c->after[i];
        if (c->after[i])
            c->after[i]->before[bmr_body_pair_side(c->after[i], r)] = c->before[i];
        r->pairs--;
    }
    w->counts.pairs--;
}

static void set_watch(bmr_world *w, bmr_body_pair *c, bmr_watch watch) {
    w->counts.near -= c->watch == BMR_WATCH_STRUCTURE;
    w->counts.near += watch == BMR_WATCH_STRUCTURE;
    c->watch = (uint8_t)watch;
}

static void end_structure(bmr_world *w, bmr_body_pair *c) {
    if (!c->near)
        return;
    bmr_kds_destroy(c->near->kds, &w->counted);
    bmr_world_give(w, c->near, sizeof *c->near);
    c->near = NULL;
    set_watch(w, c, BMR_WATCH_DISKS);
}

void bmr_body_pair_destroy(bmr_world *w, bmr_body_pair *c) {
    if (w->busy == c)
        w->busy = NULL;
    if (c->linked)
        unlink_pair(w, c);
    end_structure(w, c);
    bmr_scheduled_destroy(w, &c->head, sizeof *c);
}

// ---- events ----

/// Too many repairs of one pair, each within next to no time of the one before.
static bool is_burst(const bmr_world *w, bmr_near *n, double time) {
    n->burst = time - n->last_repair <= BURST_TOLERANCES * tolerance(w, n, time) ? n->burst + 1 : 0;
    n->last_repair = time;
    return n->burst > BMR_WORLD_BURST;
}

static void observe(bmr_world *w, const bmr_body_pair *c, bmr_world_event_kind kind,
                    const bmr_kds_report *report) {
    bmr_world_observe(w, kind, c->side[0]->id, c->side[1]->id, report);
}

static double margin_of(const bmr_world *w, unsigned level) {
    return w->def.kds.margin * exp2(-(double)level / bmr_levels_a_halving(w));
}

/// A proof from nothing with the margin of the pair's level; false: contact.
static bool start(bmr_world *w, bmr_body_pair *c, double time, bmr_kds_report *report) {
    bmr_near *const n = c->near;
    bmr_pair_view view;
    const bmr_pair_motion motion = bmr_body_pair_motion(w, c, &view);
    const bmr_instant now = bmr_pair_instant(&motion, time);
    n->kds->def.hysteresis = 0.0; // the world's own: see grow
    n->kds->def.margin = margin_of(w, n->level);
    bmr_kds_start(n->kds, &now, report);
    n->from = n->repaired = time;
    return report->apart;
}

static double separation(const bmr_world *w, const bmr_body_pair *c, double time) {
    bmr_pair_view view;
    const bmr_pair_motion motion = bmr_body_pair_motion(w, c, &view);
    return bmr_pair_separation(&motion, time);
}

static bmr_error touch(bmr_world *w, bmr_body_pair *c, bool *touches) {
    set_watch(w, c, BMR_WATCH_PASSING);
    bmr_event_queue_set(&w->queue, &c->head.item, INFINITY);
    *touches = true;
    return BMR_OK;
}

/// The disks have met: a structure begins.
static bmr_error meet(bmr_world *w, bmr_body_pair *c, bool *touches) {
    bmr_pair_view view;
    const bmr_pair_motion motion = bmr_body_pair_motion(w, c, &view);
    // Is the clock too coarse, at the present time, for the speeds of the two?
    if (!(fabs(w->time) < clock_end(w, speed_over(&motion, w->time, nextafter(w->time, INFINITY)))))
        return bmr_body_pair_stop(w, c, BMR_ERROR_OUT_OF_RANGE, BMR_TROUBLE_SPEED);
    bmr_near *const n = bmr_world_take(w, sizeof *n);
    if (!n)
        return BMR_ERROR_NO_MEMORY;
    memset(n, 0, sizeof *n);
    const bmr_error error = bmr_kds_create(w->def.structure, &w->def.kds, bmr_body_pair_shape(c, 0),
                                           bmr_body_pair_shape(c, 1), &w->counted, &n->kds);
    if (error != BMR_OK) {
        bmr_world_give(w, n, sizeof *n);
        return error;
    }
    n->last_repair = -INFINITY;
    n->growth = INFINITY;
    n->part = NAN;
    c->near = n;
    set_watch(w, c, BMR_WATCH_STRUCTURE);
    bmr_kds_report report;
    if (!start(w, c, w->time, &report)) // no motion brought them here
        return touch(w, c, touches);
    bmr_body_pair_search_later(w, c, false);
    observe(w, c, BMR_WORLD_NEAR, &report);
    return BMR_OK;
}

static void part(bmr_world *w, bmr_body_pair *c) {
    end_structure(w, c);
    const bmr_body a = c->side[0]->id, b = c->side[1]->id;
    if (c->neighbours)
        bmr_body_pair_search_later(w, c, false);
    else
        bmr_body_pair_destroy(w, c);
    bmr_world_observe(w, BMR_WORLD_PART, a, b, NULL);
}

/// When the condition fails, where that is known better than by the search: at `later` it does.
static double failure_between(const bmr_world *w, const bmr_near *n, const bmr_pair_motion *motion,
                              double later) {
    double sooner = w->time;
    while (later - sooner > tolerance(w, n, later)) {
        const double middle = sooner + 0.5 * (later - sooner);
        const bmr_pose pose = bmr_pair_instant(motion, middle).pose;
        *(bmr_condition_value(&n->condition, &pose) > 0.0 ? &sooner : &later) = middle;
    }
    return later;
}

static bmr_error fail(bmr_world *w, bmr_body_pair *c, bool *touches) {
    bmr_near *const n = c->near;
    bmr_pair_view view;
    const bmr_pair_motion motion = bmr_body_pair_motion(w, c, &view);
    const double later = bmr_repair_time(&motion, &n->condition, w->time, tolerance(w, n, w->time),
                                         NUDGE_MARGINS * w->def.kds.margin / n->speed);
    const bmr_instant now = bmr_pair_instant(&motion, later);
    if ((later - w->time) * n->speed > EARLY_MARGINS * w->def.kds.margin &&
        !(bmr_condition_value(&n->condition, &now.pose) > 0.0)) {
        w->counts.continued++;
        schedule(w, c, BMR_DUE_FAIL, failure_between(w, n, &motion, later));
        return BMR_OK;
    }
    if (is_burst(w, n, w->time)) {
        bmr_body_pair_pass(w, c);
        return bmr_body_pair_stop(w, c, BMR_ERROR_STALLED, BMR_TROUBLE_REPAIRS);
    }
    bmr_kds_report report;
    bmr_kds_repair(n->kds, &now, n->failing, &report);
    n->period = fmax(later - n->repaired, 0.5 * n->period);
    n->from = n->repaired = later;
    n->window = AHEAD * n->period;
    if (report.kind == BMR_KDS_CONTACT)
        return touch(w, c, touches);
    bmr_body_pair_search_later(w, c, false);
    observe(w, c, BMR_WORLD_REPAIR, &report);
    return BMR_OK;
}

/// The lowest level whose margin a pair at this separation has twice; of the ground, all of the hysteresis.
static unsigned level_for(const bmr_world *w, double separation, unsigned level) {
    const double ground = w->def.kds.margin + fmax(w->def.kds.margin, w->def.kds.hysteresis);
    unsigned lowest = 0;
    while (lowest < level && !(separation > (lowest == 0 ? ground : 2.0 * margin_of(w, lowest))))
        lowest++;
    return lowest;
}

/// A pair that was in contact gets its margin back, as much of it as it is apart by; until it has all of it
/// it is asked again, each time after twice as long.
static bmr_error grow(bmr_world *w, bmr_body_pair *c) {
    bmr_near *const n = c->near;
    w->counts.continued++;
    n->growth_step = fmax(2.0 * n->growth_step, 2.0 * bmr_world_tolerance(w, w->time));
    n->growth = fmax(w->time + n->growth_step, nextafter(w->time, INFINITY));
    const unsigned before = n->level, lower = level_for(w, separation(w, c, w->time), before);
    if (lower < before) {
        bmr_kds_report report;
        n->level = lower;
        if (!start(w, c, w->time, &report)) {
            n->level = before;
            if (!start(w, c, w->time, &report)) { // apart, and no proof of it
                bmr_body_pair_pass(w, c);
                return bmr_body_pair_stop(w, c, BMR_ERROR_STALLED, BMR_TROUBLE_PROOF);
            }
        }
        if (n->level == 0) {
            n->growth = INFINITY;
            n->again = 0;
        }
    }
    bmr_body_pair_search_later(w, c, false);
    return BMR_OK;
}

/// A pair that passed is apart.
static bmr_error leave(bmr_world *w, bmr_body_pair *c) {
    bmr_near *const n = c->near;
    bmr_kds_report report;
    n->level = 0;
    const double target = w->def.kds.margin + w->def.kds.hysteresis;
    if (separation(w, c, w->time) > target && start(w, c, w->time, &report)) {
        n->again = 0;
        set_watch(w, c, BMR_WATCH_STRUCTURE);
        bmr_body_pair_search_later(w, c, false);
        observe(w, c, BMR_WORLD_LEAVE, &report);
        return BMR_OK;
    }
    if (n->retries++ < LEAVE_RETRIES) {
        schedule(w, c, BMR_DUE_LEAVE, w->time + ldexp(bmr_world_tolerance(w, w->time), (int)n->retries));
        return BMR_OK;
    }
    n->retries = 0;
    return search(w, c);
}

bmr_error bmr_body_pair_event(bmr_world *w, bmr_body_pair *c, bool *touches) {
    switch ((bmr_pair_due)c->event) {
    case BMR_DUE_MEET:
        return meet(w, c, touches);
    case BMR_DUE_FAIL:
        return fail(w, c, touches);
    case BMR_DUE_PART:
        part(w, c);
        return BMR_OK;
    case BMR_DUE_TOUCH:
        c->near->touches = c->near->touch == w->time ? c->near->touches + 1 : 1;
        c->near->touch = w->time;
        return touch(w, c, touches);
    case BMR_DUE_GROWTH:
        return grow(w, c);
    case BMR_DUE_LEAVE:
        return leave(w, c);
    case BMR_DUE_SEARCH:
        break;
    }
    w->counts.continued++;
    return search(w, c);
}

// ---- after a contact ----

void bmr_body_pair_pass(bmr_world *w, bmr_body_pair *c) {
    bmr_near *const n = c->near;
    set_watch(w, c, BMR_WATCH_PASSING);
    n->from = w->time;
    n->part = NAN;
    n->growth = INFINITY;
    n->retries = 0;
    bmr_body_pair_search_later(w, c, false);
}

bmr_error bmr_body_pair_resume(bmr_world *w, bmr_body_pair *c, double receding) {
    bmr_near *const n = c->near;
    bmr_kds_report report;
    n->again++;
    // At a TOUCH they are where they were: the margin that they have will do.
    for (n->level += c->event != BMR_DUE_TOUCH; n->level <= MOST_HALVINGS * bmr_levels_a_halving(w);
         n->level++) {
        if (!start(w, c, w->time, &report))
            continue;
        const double wanted = 2.0 * margin_of(w, n->level - 1);
        const double most = natural_time(w, c, w->time);
        n->part = NAN;
        n->window = 0.0;
        n->period = 0.0;
        n->growth_step = receding * most > wanted ? wanted / receding : most;
        n->growth = w->time + fmax(n->growth_step, 2.0 * bmr_world_tolerance(w, w->time));
        set_watch(w, c, BMR_WATCH_STRUCTURE);
        bmr_body_pair_search_later(w, c, false);
        return BMR_OK;
    }
    // Overlapping bodies were put there: they pass, until they are apart.
    const bool placed = c->event == BMR_DUE_MEET;
    bmr_body_pair_pass(w, c);
    return placed ? BMR_OK : bmr_body_pair_stop(w, c, BMR_ERROR_STALLED, BMR_TROUBLE_CONTACTS);
}
