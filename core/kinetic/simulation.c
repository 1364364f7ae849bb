// SPDX-License-Identifier: MIT
#include "boomerang/simulation.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "boomerang/time_of_contact.h"
#include "geometry/memory.h"
#include "kinetic/failure.h"
#include "kinetic/motion.h"

/// The search for the next event goes ahead by this many times the time between the last events, then by
/// twice that, and so on. So most searches find the event at once, and few look far beyond it in vain.
#define AHEAD 4.0

/// The first search, before there were events, goes over this part of the run.
#define FIRST_PART 0x1p-4
/// No search goes over less than this part of the run. After a burst of events the time between them is so
/// short that it would have to be doubled too often.
#define LEAST_PART 0x1p-16

/// A structure may still report contact where the distance has just risen above the one that ends it. It is
/// asked again after a tolerance, two, four, and so on, so many times: by default up to a millionth of a unit
/// of time later.
#define LEAVE_RETRIES 20

/// What comes next.
typedef enum next_event {
    NONE, ///< nothing that is known: the search goes on
    FAIL, ///< a condition fails
    LEAVE,
    JUMP
} next_event;

struct bmr_simulation {
    const bmr_allocator *allocator;
    bmr_simulation_def def;
    bmr_shape shapes[2];
    const bmr_motion *motions[2];
    bmr_kds *kds;
    bmr_simulation_observer observer;
    void *context;
    double time, reached; ///< now; as far as any run went
    bool inside;          ///< a run or a replan is at work: the observer may be called
    bool replan;          ///< a plan was changed, and nothing was searched since

    next_event next;
    double due;              ///< when `next` takes place; nothing happens before
    double searched;         ///< NONE: nothing happens until then
    size_t failing;          ///< FAIL: index of the condition
    bmr_condition condition; ///< FAIL: itself
    double from;             ///< where the next search begins
    double period;           ///< about the time between the last events
    double burst_start;
    unsigned burst;
    unsigned retries; ///< LEAVE: of the structure's start
    bmr_simulation_counts counts;
};

bmr_simulation_def bmr_default_simulation_def(void) {
    const bmr_simulation_def def = {NULL, bmr_default_kds_def(), bmr_default_failure_options(), 0.1};
    return def;
}

static double tolerance_at(const bmr_simulation *s, double time) {
    return s->def.failure.tolerance * fmax(1.0, fabs(time));
}

static bmr_pair_motion motion_of(const bmr_simulation *s) {
    const bmr_pair_motion motion = {s->motions[0], s->motions[1], s->shapes[0].polygon, s->shapes[1].polygon};
    return motion;
}

// ---- searching ----

static void expect(bmr_simulation *s, next_event next, double time) {
    s->next = next;
    s->due = time;
}

/// When a condition fails, or a contact ends, in (from, to]; INFINITY: at no time.
static bmr_error find_event(bmr_simulation *s, const bmr_pair_motion *motion, const bmr_condition *conditions,
                            size_t count, double from, double to, double *time) {
    if (bmr_kds_in_contact(s->kds)) {
        const double target = s->def.kds.margin + s->def.kds.hysteresis;
        *time = bmr_pair_leaves(motion, from, to, target, s->def.contact_step, tolerance_at(s, from));
        return isnan(*time) ? BMR_ERROR_OUT_OF_RANGE : BMR_OK;
    }
    const bmr_error error = bmr_first_failure(conditions, count, motion->a, motion->b, from, to,
                                              &s->def.failure, time, &s->failing);
    if (error == BMR_OK && *time < INFINITY)
        s->condition = conditions[s->failing];
    return error;
}

/// Finds the next event in (s->from, to]; if there is none, the search goes on after `to`. After an error it
/// begins again where it began.
static bmr_error search(bmr_simulation *s, double to) {
    s->searched = s->from;
    expect(s, NONE, s->from);
    const bmr_pair_motion motion = motion_of(s);
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    const bool contact = bmr_kds_in_contact(s->kds);
    const size_t count = bmr_kds_conditions(s->kds, conditions);
    if (!contact)
        s->counts.failure_times += count;
    double from = s->from;
    double window =
        fmax(LEAST_PART * (to - from), s->period > 0.0 ? AHEAD * s->period : FIRST_PART * (to - from));
    for (; from < to; window *= 2.0) {
        double end = fmin(to, fmax(from + window, nextafter(from, INFINITY)));
        const double jump = bmr_pair_next_jump(&motion, from, end);
        end = fmin(end, jump);
        double time;
        const bmr_error error = find_event(s, &motion, conditions, count, from, end, &time);
        if (error != BMR_OK)
            return error;
        if (time < jump && time <= end) {
            s->retries = 0;
            expect(s, contact ? LEAVE : FAIL, time);
            return BMR_OK;
        }
        if (jump <= end) {
            expect(s, JUMP, jump);
            return BMR_OK;
        }
        from = end;
    }
    s->searched = from;
    expect(s, NONE, nextafter(from, INFINITY));
    return BMR_OK;
}

// ---- events ----

static void observe(bmr_simulation *s, bmr_simulation_event *event) {
    const bmr_kds_event_kind kind = event->report.kind;
    s->counts.events[kind]++;
    s->counts.touched += event->report.touched;
    s->counts.lines += event->report.line_changed && kind != BMR_KDS_START && kind != BMR_KDS_LEAVE;
    event->kds = s->kds;
    bmr_kds_get_proof(s->kds, &event->after);
    if (s->observer)
        s->observer(s->context, event);
}

/// A start: at creation, after a jump, or on leaving contact. A pair that stays in contact is no event.
static void start(bmr_simulation *s, double time, bool first) {
    const bmr_pair_motion motion = motion_of(s);
    const bmr_instant now = bmr_pair_instant(&motion, time);
    bmr_simulation_event event;
    memset(&event, 0, sizeof event);
    event.time = time;
    event.pose = now.pose;
    const bool contact = !first && bmr_kds_in_contact(s->kds);
    bmr_kds_start(s->kds, &now, &event.report);
    s->counts.external += !first && contact == event.report.apart;
    s->from = time;
    if (!contact || event.report.apart)
        observe(s, &event);
}

/// False: a body jumps before the structure could be repaired, which is the next event.
static bool repair(bmr_simulation *s, double time) {
    const bmr_pair_motion motion = motion_of(s);
    const double later = bmr_repair_time(&motion, &s->condition, time, tolerance_at(s, time), INFINITY);
    const double jump = bmr_pair_next_jump(&motion, time, later);
    if (jump <= later) {
        expect(s, JUMP, jump);
        return false;
    }
    const bmr_instant now = bmr_pair_instant(&motion, later);
    bmr_simulation_event event;
    memset(&event, 0, sizeof event);
    event.time = time;
    event.pose = now.pose;
    event.failed = s->condition;
    bmr_kds_get_proof(s->kds, &event.before);
    bmr_kds_repair(s->kds, &now, s->failing, &event.report);
    s->counts.external += event.report.kind == BMR_KDS_CONTACT;
    s->period = fmax(later - s->from, 0.5 * s->period);
    s->from = later;
    observe(s, &event);
    return true;
}

/// For a pair that is far enough apart, but whose structure still reports contact. True: it is to be asked
/// again soon. False: it waits for the next time that the pair comes apart.
static bool leave_later(bmr_simulation *s, double time) {
    const bmr_pair_motion motion = motion_of(s);
    const double later = time + ldexp(tolerance_at(s, time), (int)s->retries);
    if (s->retries++ >= LEAVE_RETRIES || !(later > time) ||
        bmr_pair_next_jump(&motion, time, later) <= later ||
        !(bmr_pair_separation(&motion, later) > s->def.kds.margin + s->def.kds.hysteresis))
        return false;
    expect(s, LEAVE, later);
    return true;
}

/// Counts an event. True: there were too many within one tolerance.
static bool is_burst(bmr_simulation *s, double time) {
    if (!(time - s->burst_start <= tolerance_at(s, time))) {
        s->burst_start = time;
        s->burst = 0;
    }
    return ++s->burst > BMR_SIMULATION_BURST;
}

/// Starts the structure where a new plan jumps, and finds the next event.
static bmr_error go_on(bmr_simulation *s, double until) {
    while (s->replan) {
        s->replan = false;
        s->from = fmax(s->from, s->time);
        const bmr_pair_motion motion = motion_of(s);
        if (!bmr_pair_jumps_at(&motion, s->time))
            break;
        expect(s, JUMP, s->time); // after STALLED the next run begins here again
        if (is_burst(s, s->time))
            return BMR_ERROR_STALLED;
        start(s, s->time, false); // whose observer may have another plan
    }
    return search(s, until);
}

/// Takes the next event, and finds the one after it.
static bmr_error take_event(bmr_simulation *s, double until) {
    const double time = s->due;
    if (s->next == NONE) {
        s->from = s->searched;
        return search(s, until);
    }
    s->time = fmax(s->time, time);
    if (is_burst(s, time))
        return BMR_ERROR_STALLED;
    if (s->next == FAIL) {
        if (!repair(s, time))
            return BMR_OK;
    } else {
        start(s, time, false);
    }
    if (s->next == LEAVE && !s->replan && bmr_kds_in_contact(s->kds) && leave_later(s, time))
        return BMR_OK;
    return go_on(s, until);
}

bmr_error bmr_simulation_run(bmr_simulation *s, double until) {
    if (!s)
        return BMR_ERROR_NULL_ARGUMENT;
    if (!isfinite(until))
        return BMR_ERROR_NOT_FINITE;
    if (s->inside || until < s->time)
        return BMR_ERROR_OUT_OF_RANGE;
    s->reached = fmax(s->reached, until);
    s->inside = true;
    bmr_error error = BMR_OK;
    while (error == BMR_OK && s->due <= until)
        error = take_event(s, until);
    s->inside = false;
    if (error == BMR_OK)
        s->time = until;
    return error;
}

bmr_error bmr_simulation_replan(bmr_simulation *s) {
    if (!s)
        return BMR_ERROR_NULL_ARGUMENT;
    s->replan = true;
    if (s->inside)
        return BMR_OK;
    const uint64_t before = s->counts.failure_times;
    s->inside = true;
    const bmr_error error = go_on(s, s->reached);
    s->inside = false;
    s->counts.replanned += s->counts.failure_times - before;
    return error;
}

// ---- creation ----

static bool def_makes_sense(const bmr_simulation_def *def) {
    return isfinite(def->failure.tolerance) && def->failure.tolerance > 0.0 && isfinite(def->contact_step) &&
           def->contact_step > 0.0;
}

bmr_error bmr_simulation_create(const bmr_simulation_def *def, const bmr_shape shapes[2],
                                bmr_motion *const motions[2], double time, bmr_simulation_observer observer,
                                void *context, const bmr_allocator *allocator, bmr_simulation **simulation) {
    if (!def || !def->structure || !shapes || !motions || !motions[0] || !motions[1] || !simulation)
        return BMR_ERROR_NULL_ARGUMENT;
    if (!isfinite(time))
        return BMR_ERROR_NOT_FINITE;
    if (!def_makes_sense(def))
        return BMR_ERROR_OUT_OF_RANGE;
    bmr_simulation *s = bmr_allocate(allocator, sizeof *s);
    if (!s)
        return BMR_ERROR_NO_MEMORY;
    memset(s, 0, sizeof *s);
    const bmr_error error =
        bmr_kds_create(def->structure, &def->kds, &shapes[0], &shapes[1], allocator, &s->kds);
    if (error != BMR_OK) {
        bmr_release(allocator, s, sizeof *s);
        return error;
    }
    s->allocator = allocator;
    s->def = *def;
    s->observer = observer;
    s->context = context;
    s->time = s->reached = s->searched = time;
    s->burst_start = -INFINITY;
    for (size_t i = 0; i < 2; i++) {
        s->shapes[i] = shapes[i];
        s->motions[i] = motions[i];
    }
    start(s, time, true);
    expect(s, NONE, nextafter(time, INFINITY));
    *simulation = s;
    return BMR_OK;
}

void bmr_simulation_destroy(bmr_simulation *s) {
    if (!s || s->inside)
        return;
    bmr_kds_destroy(s->kds, s->allocator);
    bmr_release(s->allocator, s, sizeof *s);
}

// ---- questions ----

double bmr_simulation_time(const bmr_simulation *s) {
    return s->time;
}

const bmr_kds *bmr_simulation_kds(const bmr_simulation *s) {
    return s->kds;
}

bmr_simulation_counts bmr_simulation_get_counts(const bmr_simulation *s) {
    bmr_simulation_counts counts = s->counts;
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    counts.conditions = bmr_kds_conditions(s->kds, conditions);
    counts.bytes = bmr_kds_bytes(s->kds);
    return counts;
}

bmr_error bmr_simulation_audit(const bmr_simulation *s) {
    if (!s)
        return BMR_ERROR_NULL_ARGUMENT;
    const bmr_pair_motion motion = motion_of(s);
    const bmr_pose pose = bmr_pair_instant(&motion, s->time).pose;
    return bmr_kds_audit(s->kds, &pose);
}

// ---- the time of contact of two ----

/// The interval is run in so many parts, so that what lies behind the contact is not all computed.
#define PARTS 16

static void note_contact(void *context, const bmr_simulation_event *event) {
    double *time = context;
    if (event->report.kind == BMR_KDS_CONTACT && event->time < *time)
        *time = event->time;
}

bmr_error bmr_time_of_contact(const bmr_shape *a, const bmr_motion *motion_a, const bmr_shape *b,
                              const bmr_motion *motion_b, double from, double until, double margin,
                              const bmr_allocator *allocator, double *time) {
    if (!a || !motion_a || !b || !motion_b || !time || !a->polygon || !b->polygon)
        return BMR_ERROR_NULL_ARGUMENT;
    if (!isfinite(from) || !isfinite(until))
        return BMR_ERROR_NOT_FINITE;
    if (from > until)
        return BMR_ERROR_OUT_OF_RANGE;
    bmr_simulation_def def = bmr_default_simulation_def();
    bmr_error error = bmr_kds_find(
        a->hierarchies[BMR_HIERARCHY_DUDLEY] && b->hierarchies[BMR_HIERARCHY_DUDLEY] ? "lazy-dudley"
                                                                                     : "hybrid",
        &def.structure);
    def.kds.margin = margin;
    const bmr_shape shapes[2] = {*a, *b};
    bmr_motion *const motions[2] = {(bmr_motion *)motion_a, (bmr_motion *)motion_b}; // it only reads them
    double contact = INFINITY;
    bmr_simulation *simulation = NULL;
    if (error == BMR_OK)
        error = bmr_simulation_create(&def, shapes, motions, from, note_contact, &contact, allocator,
                                      &simulation);
    for (int part = 1; part <= PARTS && error == BMR_OK && contact == INFINITY; ++part) {
        const double end = part < PARTS ? from + (until - from) * ((double)part / PARTS) : until;
        error = bmr_simulation_run(simulation, fmax(end, bmr_simulation_time(simulation)));
    }
    bmr_simulation_destroy(simulation);
    if (error != BMR_OK && contact == INFINITY)
        return error;
    *time = contact;
    return BMR_OK;
}
