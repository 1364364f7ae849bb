// SPDX-License-Identifier: MIT
// When something happens to a couple next: its disks, its structure's conditions, and how exactly.
#include <float.h>
#include <math.h>

#include "geometry/length.h"
#include "kds/structure.h"
#include "kinetic/failure.h"
#include "world/parts.h"

/// The first failure is looked for in this part of the time in which the two can move by their reach, then in
/// twice that.
#define FIRST_PART 0x1p-3
/// Windows that one search goes through before the couple is put back into the queue.
#define WINDOWS 6
/// A pair that passes is looked at step by step: so many steps ahead, for most pairs are soon sent elsewhere.
#define PASSING_STEPS 8.0
/// Times are found so exactly that meanwhile no point moves by more than this part of the margin, but no more
/// exactly than to so many roundings of the clock. Two that fly through each other are within the margin for
/// two margins' way, so where these roundings are a margin's way at most nobody is missed; where they are
/// more, the pair is stopped.
#define TOLERANCE_PART 0x1p-4
#define CLOCK_ROUNDINGS 4.0
/// A hit goes through a row of bodies that lie on each other in no time. So often may a pair be told that it
/// touches at one time; then its distance must shrink before it is told again.
#define MOST_TOUCHES 256
/// What is too fast over one window is looked at over so much of it.
#define SHORTER 0x1p-4

double bmr_couple_natural_time(const bmr_world *w, const bmr_couple *c, const bmr_pair_motion *motion,
                               double time) {
    const bmr_instant now = bmr_pair_instant(motion, time);
    const bool wall = bmr_resident_is_wall(c->side[1]);
    const double speed =
        bmr_length(now.velocity) + fabs(now.spin) * (c->side[0]->radius + (wall ? 0.0 : c->side[1]->radius));
    const double scale = bmr_gate_reach(w, c) / speed;
    return scale > 0.0 && scale < INFINITY ? scale : fmax(1.0, fabs(time));
}

void bmr_couple_schedule(bmr_world *w, bmr_couple *c, bmr_couple_event event, double time) {
    c->event = (uint8_t)event;
    bmr_event_queue_set(&w->queue, &c->head.item, time < INFINITY ? fmax(time, w->time) : time);
}

/// OUT_OF_RANGE of a question about the disks: so fast, or so long after their epoch, that they cannot be
/// told apart from disks that meet.
static bmr_error disks_error(bmr_world *w, const bmr_couple *c, bmr_error error) {
    return error == BMR_ERROR_OUT_OF_RANGE ? bmr_couple_stop(w, c, error, BMR_TROUBLE_SPEED) : error;
}

static bmr_error search_disks(bmr_world *w, bmr_couple *c) {
    double time;
    bool look;
    w->counts.disk_times++;
    const bmr_error error = bmr_gate_meets(w, c, w->time, &time, &look);
    if (error == BMR_OK)
        bmr_couple_schedule(w, c, look ? BMR_COUPLE_LOOK : BMR_COUPLE_MEET, time);
    return disks_error(w, c, error);
}

/// When the structure is not needed any more; part_known: not before `part`, where it is to be asked again.
static bmr_error find_part(bmr_world *w, bmr_couple *c) {
    bmr_near *const n = c->near;
    if (!isnan(n->part) && (n->part_known || n->part > n->from))
        return BMR_OK;
    w->counts.disk_times++;
    bool look;
    const double after = fmax(w->time, n->from);
    bmr_error error = bmr_gate_parts(w, c, after, &n->part, &look);
    // Who parts as soon as they meet would meet again, and so on: a loop, or a contact that nobody saw.
    if (error == BMR_OK && !look && n->part <= after &&
        bmr_gate_distance(w, c, after) <= bmr_gate_reach(w, c))
        error = BMR_ERROR_OUT_OF_RANGE;
    n->part_known = error == BMR_OK && !look;
    if (error != BMR_OK)
        n->part = NAN;
    return disks_error(w, c, error);
}

double bmr_couple_tolerance(const bmr_world *w, const bmr_near *n, double time) {
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

bool bmr_couple_too_fast(const bmr_world *w, const bmr_couple *c) {
    bmr_couple_view view;
    const bmr_pair_motion motion = bmr_couple_motion(w, c, &view);
    const double speed = speed_over(&motion, w->time, nextafter(w->time, INFINITY));
    return !(fabs(w->time) < clock_end(w, speed));
}

/// The first failure of the structure's conditions, or the end of a contact that was passed, in (from, to].
static bmr_error find_event(bmr_world *w, bmr_couple *c, const bmr_pair_motion *motion, double from,
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
    const bmr_failure_options options = {w->def.failure.method,
                                         bmr_couple_tolerance(w, n, from) / fmax(1.0, fabs(from))};
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

static bmr_error search_near(bmr_world *w, bmr_couple *c) {
    bmr_near *const n = c->near;
    const bmr_error error = find_part(w, c);
    if (error != BMR_OK)
        return error;
    bmr_couple_view view;
    const bmr_pair_motion motion = bmr_couple_motion(w, c, &view);
    if (!(n->window > 0.0))
        n->window = FIRST_PART * bmr_couple_natural_time(w, c, &motion, n->from);
    const double pieces = fmin(c->side[0]->until, c->side[1]->until);
    const double horizon = fmin(n->part, fmin(n->rise, pieces));
    const bool passing = c->watch == BMR_WATCH_PASSING;
    if (passing)
        n->window = PASSING_STEPS * fmax(w->def.contact_step, bmr_world_tolerance(w, n->from));
    for (int i = 0; i < (passing ? 1 : WINDOWS) && n->from < horizon; i++, n->window *= 2.0) {
        double to = fmin(horizon, fmin(DBL_MAX, fmax(n->from + n->window, nextafter(n->from, INFINITY))));
        if (!passing && !is_slow_enough(w, n, &motion, &to)) {
            if (n->from > w->time)
                break;
            return bmr_couple_stop(w, c, BMR_ERROR_OUT_OF_RANGE, BMR_TROUBLE_SPEED);
        }
        double time;
        const bmr_error failed = find_event(w, c, &motion, n->from, to, &time);
        if (failed != BMR_OK)
            return failed;
        if (time < INFINITY) {
            bmr_couple_schedule(w, c, passing ? BMR_COUPLE_LEAVE : BMR_COUPLE_FAIL, time);
            return BMR_OK;
        }
        n->from = to;
    }
    if (n->from < horizon)
        bmr_couple_schedule(w, c, BMR_COUPLE_LOOK, n->from);
    else if (horizon == n->part)
        bmr_couple_schedule(w, c, n->part_known ? BMR_COUPLE_PART : BMR_COUPLE_LOOK, n->part);
    else if (horizon == n->rise)
        bmr_couple_schedule(w, c, BMR_COUPLE_RISE, n->rise);
    else // the next piece is an event of its body, and comes first
        bmr_couple_schedule(w, c, BMR_COUPLE_LOOK, pieces);
    return BMR_OK;
}

bmr_error bmr_couple_search(bmr_world *w, bmr_couple *c) {
    return c->near ? search_near(w, c) : search_disks(w, c);
}

/// ZENO_ELASTIC: are two that touched, and are still within the margin, driven together by more than
/// zeno_speed? They are bodies that lie on each other, and one of them was hit.
static bool is_driven_together(const bmr_world *w, const bmr_couple *c) {
    const bmr_near *const n = c->near;
    if (w->def.zeno != BMR_ZENO_ELASTIC || c->watch != BMR_WATCH_STRUCTURE || n->rung == 0 ||
        (n->touch == w->time && n->touches >= MOST_TOUCHES))
        return false;
    bmr_touch touch;
    bmr_touch_describe(w, c, false, &touch);
    const bmr_contact *const contact = &touch.contact;
    const double approach =
        contact->count == 2 ? fmin(contact->approach[0], contact->approach[1]) : contact->approach[0];
    return contact->distance <= w->def.kds.margin && -approach > w->def.zeno_speed;
}

void bmr_couple_search_later(bmr_world *w, bmr_couple *c, bool replan) {
    if (replan && c->near) {
        bmr_near *const n = c->near;
        n->from = fmax(n->repaired, w->time);
        n->part = NAN;
        n->window = BMR_COUPLE_AHEAD * n->rhythm;
        if (is_driven_together(w, c)) {
            bmr_couple_schedule(w, c, BMR_COUPLE_TOUCH, w->time);
            return;
        }
    }
    if (bmr_couple_search(w, c) != BMR_OK)
        bmr_couple_schedule(w, c, BMR_COUPLE_LOOK, w->time);
}
