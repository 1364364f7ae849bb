// SPDX-License-Identifier: MIT
#include "boomerang/simulation.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "boomerang/time_of_contact.h"
#include "geometry/memory.h"
#include "kinetic/event_queue.h"
#include "kinetic/failure.h"
#include "kinetic/motion.h"

/// The search for a pair's next event goes ahead by this many times the time between its last events, then by
/// twice that, and so on. So most searches find the event at once, and few look far beyond it in vain.
#define AHEAD 4.0

/// The first search of a pair, which has had no events yet, goes over this part of the run.
#define FIRST_PART 0x1p-4
/// No search goes over less than this part of the run. After a burst of events the time between them is so
/// short that it would have to be doubled too often.
#define LEAST_PART 0x1p-16

/// A structure may still report contact where the distance has just risen above the one that ends it. It is
/// asked again after a tolerance, two, four, and so on, so many times: by default up to a millionth of a unit
/// of time later.
#define LEAVE_RETRIES 20

/// What the queue has a pair for.
typedef enum reason {
    LOOK, ///< to be searched further
    FAIL, ///< a condition fails
    LEAVE,
    JUMP
} reason;

typedef struct pair {
    bmr_event_item item;
    bmr_kds *kds;
    size_t a, b;
    reason next;
    size_t failing;          ///< FAIL: index of the condition
    bmr_condition condition; ///< FAIL: itself
    double searched;         ///< nothing happens until then but what the queue has
    double from;             ///< where its next search begins
    double period;           ///< about the time between its last events
    double burst_start;
    unsigned burst;
    unsigned retries; ///< LEAVE: of the structure's start
} pair;

struct bmr_simulation {
    const bmr_allocator *allocator;
    bmr_simulation_def def;
    size_t bytes, body_count, pair_count;
    bmr_shape *shapes;
    const bmr_motion **motions;
    pair *pairs;
    bmr_event_queue queue;
    bmr_simulation_observer observer;
    void *context;
    double time, reached; ///< now; as far as any run went
    bmr_simulation_counts counts;
};

bmr_simulation_def bmr_default_simulation_def(void) {
    const bmr_simulation_def def = {NULL, bmr_default_kds_def(), bmr_default_failure_options(), 0.1};
    return def;
}

static double tolerance_at(const bmr_simulation *s, double time) {
    return s->def.failure.tolerance * fmax(1.0, fabs(time));
}

static bmr_pair_motion motion_of(const bmr_simulation *s, const pair *p) {
    const bmr_pair_motion motion = {s->motions[p->a], s->motions[p->b], s->shapes[p->a].polygon,
                                    s->shapes[p->b].polygon};
    return motion;
}

// ---- searching ----

static void schedule(bmr_simulation *s, pair *p, double time) {
    bmr_event_queue_set(&s->queue, &p->item, time);
}

/// The first failure of any condition in (from, to]; INFINITY: none.
static bmr_error first_failure(const bmr_simulation *s, pair *p, const bmr_condition *conditions,
                               size_t count, double from, double to, double *time) {
    const bmr_error error = bmr_first_failure(conditions, count, s->motions[p->a], s->motions[p->b], from, to,
                                              &s->def.failure, time, &p->failing);
    if (error == BMR_OK && *time < INFINITY)
        p->condition = conditions[p->failing];
    return error;
}

/// Finds the pair's next event in (p->from, to] and puts it in the queue; if there is none, the pair is to be
/// looked at again after `to`.
static bmr_error search(bmr_simulation *s, pair *p, double to) {
    const bmr_pair_motion motion = motion_of(s, p);
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    const bool contact = bmr_kds_in_contact(p->kds);
    const size_t count = bmr_kds_conditions(p->kds, conditions);
    if (!contact)
        s->counts.failure_times += count;
    const double target = s->def.kds.margin + s->def.kds.hysteresis;
    double from = p->from;
    double window =
        fmax(LEAST_PART * (to - from), p->period > 0.0 ? AHEAD * p->period : FIRST_PART * (to - from));
    for (; from < to; window *= 2.0) {
        double end = fmin(to, fmax(from + window, nextafter(from, INFINITY)));
        const double jump = bmr_pair_next_jump(&motion, from, end);
        end = fmin(end, jump);
        double time = INFINITY;
        if (contact) {
            time = bmr_pair_leaves(&motion, from, end, target, s->def.contact_step, tolerance_at(s, from));
            if (isnan(time))
                return BMR_ERROR_OUT_OF_RANGE;
        } else {
            const bmr_error error = first_failure(s, p, conditions, count, from, end, &time);
            if (error != BMR_OK)
                return error;
        }
        if (time < jump && time <= end) {
            p->next = contact ? LEAVE : FAIL;
            p->retries = 0;
            schedule(s, p, time);
            return BMR_OK;
        }
        if (jump <= end) {
            p->next = JUMP;
            schedule(s, p, jump);
            return BMR_OK;
        }
        from = end;
    }
    p->next = LOOK;
    p->searched = fmax(p->from, to);
    schedule(s, p, nextafter(p->searched, INFINITY));
    return BMR_OK;
}

// ---- events ----

static void observe(bmr_simulation *s, const pair *p, bmr_simulation_event *event) {
    s->counts.events[event->report.kind]++;
    s->counts.touched += event->report.touched;
    const bmr_kds_event_kind kind = event->report.kind;
    s->counts.lines += event->report.line_changed && kind != BMR_KDS_START && kind != BMR_KDS_LEAVE;
    event->pair = (size_t)(p - s->pairs);
    event->a = p->a;
    event->b = p->b;
    event->kds = p->kds;
    bmr_kds_get_proof(p->kds, &event->after);
    if (s->observer)
        s->observer(s->context, event);
}

/// A start: at creation, after a jump, or on leaving contact. A pair that stays in contact is no event.
static void start(bmr_simulation *s, pair *p, double time, bool first) {
    const bmr_pair_motion motion = motion_of(s, p);
    const bmr_instant now = bmr_pair_instant(&motion, time);
    bmr_simulation_event event;
    memset(&event, 0, sizeof event);
    event.time = time;
    event.pose = now.pose;
    const bool contact = !first && bmr_kds_in_contact(p->kds);
    bmr_kds_start(p->kds, &now, &event.report);
    s->counts.external += !first && contact == event.report.apart;
    p->from = time;
    if (!contact || event.report.apart)
        observe(s, p, &event);
}

/// False: the pair jumps before it could be repaired, which is its next event.
static bool repair(bmr_simulation *s, pair *p, double time) {
    const bmr_pair_motion motion = motion_of(s, p);
    const double later = bmr_repair_time(&motion, &p->condition, time, tolerance_at(s, time), INFINITY);
    const double jump = bmr_pair_next_jump(&motion, time, later);
    if (jump <= later) {
        p->next = JUMP;
        schedule(s, p, jump);
        return false;
    }
    const bmr_instant now = bmr_pair_instant(&motion, later);
    bmr_simulation_event event;
    memset(&event, 0, sizeof event);
    event.time = time;
    event.pose = now.pose;
    event.failed = p->condition;
    bmr_kds_get_proof(p->kds, &event.before);
    bmr_kds_repair(p->kds, &now, p->failing, &event.report);
    s->counts.external += event.report.kind == BMR_KDS_CONTACT;
    p->period = fmax(later - p->from, 0.5 * p->period);
    p->from = later;
    observe(s, p, &event);
    return true;
}

/// For a pair that is far enough apart, but whose structure still reports contact. True: it was scheduled to
/// be asked again soon. False: it waits for the next time that the pair comes apart.
static bool leave_later(bmr_simulation *s, pair *p, double time) {
    const bmr_pair_motion motion = motion_of(s, p);
    const double later = time + ldexp(tolerance_at(s, time), (int)p->retries);
    if (p->retries++ >= LEAVE_RETRIES || !(later > time) ||
        bmr_pair_next_jump(&motion, time, later) <= later ||
        !(bmr_pair_separation(&motion, later) > s->def.kds.margin + s->def.kds.hysteresis))
        return false;
    schedule(s, p, later);
    return true;
}

/// Counts an event of the pair. True: there were too many within one tolerance.
static bool is_burst(const bmr_simulation *s, pair *p, double time) {
    if (!(time - p->burst_start <= tolerance_at(s, time))) {
        p->burst_start = time;
        p->burst = 0;
    }
    return ++p->burst > BMR_SIMULATION_BURST;
}

static bmr_error process(bmr_simulation *s, pair *p, double time, double until) {
    if (p->next == LOOK) {
        p->from = p->searched;
        return search(s, p, until);
    }
    if (is_burst(s, p, time))
        return BMR_ERROR_STALLED;
    if (p->next == FAIL) {
        if (!repair(s, p, time))
            return BMR_OK;
    } else {
        start(s, p, time, false);
    }
    if (p->next == LEAVE && bmr_kds_in_contact(p->kds) && leave_later(s, p, time))
        return BMR_OK;
    return search(s, p, until);
}

bmr_error bmr_simulation_run(bmr_simulation *s, double until) {
    if (!s)
        return BMR_ERROR_NULL_ARGUMENT;
    if (!isfinite(until))
        return BMR_ERROR_NOT_FINITE;
    if (until < s->time)
        return BMR_ERROR_OUT_OF_RANGE;
    s->reached = fmax(s->reached, until);
    while (bmr_event_queue_time(&s->queue) <= until) {
        pair *p = (pair *)(void *)s->queue.heap[0].item;
        const double time = bmr_event_queue_time(&s->queue);
        if (p->next != LOOK)
            s->time = fmax(s->time, time);
        const bmr_error error = process(s, p, time, until);
        if (error != BMR_OK)
            return error;
    }
    s->time = until;
    return BMR_OK;
}

bmr_error bmr_simulation_replan(bmr_simulation *s, size_t body) {
    if (!s)
        return BMR_ERROR_NULL_ARGUMENT;
    if (body >= s->body_count)
        return BMR_ERROR_OUT_OF_RANGE;
    const uint64_t before = s->counts.failure_times;
    bmr_error error = BMR_OK;
    for (size_t other = 0; other < s->body_count && error == BMR_OK; other++) {
        if (other == body)
            continue;
        const size_t a = other < body ? other : body, b = other < body ? body : other;
        pair *p = &s->pairs[a * (2 * s->body_count - a - 1) / 2 + b - a - 1];
        const bmr_pair_motion motion = motion_of(s, p);
        if (bmr_pair_jumps_at(&motion, s->time))
            start(s, p, s->time, false);
        p->from = fmax(p->from, s->time);
        error = search(s, p, s->reached);
    }
    s->counts.replanned += s->counts.failure_times - before;
    return error;
}

// ---- creation ----

static bool def_makes_sense(const bmr_simulation_def *def) {
    return isfinite(def->failure.tolerance) && def->failure.tolerance > 0.0 && isfinite(def->contact_step) &&
           def->contact_step > 0.0;
}

/// Of two events of one time: the pair of the lower number.
static bool comes_first(const bmr_event_item *a, const bmr_event_item *b) {
    return a < b;
}

static bmr_error make(size_t bodies, const bmr_allocator *allocator, bmr_simulation **made) {
    // As many shapes and motions are in memory, so only the pairs can be too many.
    if (bodies - 1 > SIZE_MAX / sizeof(pair) / bodies)
        return BMR_ERROR_TOO_LARGE;
    const size_t pairs = bodies * (bodies - 1) / 2;
    const size_t bytes = sizeof(bmr_simulation) + pairs * (sizeof(pair) + sizeof(bmr_event_entry)) +
                         bodies * (sizeof(bmr_shape) + sizeof(bmr_motion *));
    bmr_simulation *s = bmr_allocate(allocator, bytes);
    if (!s)
        return BMR_ERROR_NO_MEMORY;
    memset(s, 0, bytes);
    s->allocator = allocator;
    s->bytes = bytes;
    s->body_count = bodies;
    s->pair_count = pairs;
    s->pairs = (void *)(s + 1);
    s->queue.heap = (void *)(s->pairs + pairs);
    s->shapes = (void *)(s->queue.heap + pairs);
    s->motions = (void *)(s->shapes + bodies);
    s->queue.capacity = pairs;
    s->queue.before = comes_first;
    *made = s;
    return BMR_OK;
}

/// One structure for each pair, by a, then b.
static bmr_error make_pairs(bmr_simulation *s) {
    pair *p = s->pairs;
    for (size_t a = 0; a < s->body_count; a++)
        for (size_t b = a + 1; b < s->body_count; b++, p++) {
            p->item.place = BMR_NOT_QUEUED;
            p->a = a;
            p->b = b;
            p->burst_start = -INFINITY;
            const bmr_error error = bmr_kds_create(s->def.structure, &s->def.kds, &s->shapes[a],
                                                   &s->shapes[b], s->allocator, &p->kds);
            if (error != BMR_OK)
                return error;
        }
    return BMR_OK;
}

bmr_error bmr_simulation_create(const bmr_simulation_def *def, const bmr_shape *shapes,
                                bmr_motion *const *motions, size_t count, double time,
                                bmr_simulation_observer observer, void *context,
                                const bmr_allocator *allocator, bmr_simulation **simulation) {
    if (!def || !def->structure || !shapes || !motions || !simulation)
        return BMR_ERROR_NULL_ARGUMENT;
    if (!isfinite(time))
        return BMR_ERROR_NOT_FINITE;
    if (count < 2 || !def_makes_sense(def))
        return BMR_ERROR_OUT_OF_RANGE;
    for (size_t i = 0; i < count; i++)
        if (!motions[i])
            return BMR_ERROR_NULL_ARGUMENT;
    bmr_simulation *s;
    bmr_error error = make(count, allocator, &s);
    if (error != BMR_OK)
        return error;
    s->def = *def;
    s->observer = observer;
    s->context = context;
    s->time = s->reached = time;
    for (size_t i = 0; i < count; i++) {
        s->shapes[i] = shapes[i];
        s->motions[i] = motions[i];
    }
    error = make_pairs(s);
    if (error != BMR_OK) {
        bmr_simulation_destroy(s);
        return error;
    }
    for (pair *p = s->pairs; p < s->pairs + s->pair_count; p++) {
        start(s, p, time, true);
        p->next = LOOK;
        p->searched = time;
        schedule(s, p, nextafter(time, INFINITY));
    }
    *simulation = s;
    return BMR_OK;
}

void bmr_simulation_destroy(bmr_simulation *s) {
    if (!s)
        return;
    for (size_t i = 0; i < s->pair_count; i++)
        bmr_kds_destroy(s->pairs[i].kds, s->allocator);
    bmr_release(s->allocator, s, s->bytes);
}

// ---- questions ----

double bmr_simulation_time(const bmr_simulation *s) {
    return s->time;
}

const bmr_kds *bmr_simulation_pair(const bmr_simulation *s, size_t index, size_t *a, size_t *b) {
    const pair *p = &s->pairs[index];
    if (a)
        *a = p->a;
    if (b)
        *b = p->b;
    return p->kds;
}

bmr_simulation_counts bmr_simulation_get_counts(const bmr_simulation *s) {
    bmr_simulation_counts counts = s->counts;
    counts.pairs = s->pair_count;
    counts.queue_bytes = s->pair_count * (sizeof(bmr_event_entry) + sizeof(bmr_event_item));
    for (size_t i = 0; i < s->pair_count; i++) {
        bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
        counts.conditions += bmr_kds_conditions(s->pairs[i].kds, conditions);
        counts.pair_bytes += sizeof s->pairs[i] - sizeof(bmr_event_item) + bmr_kds_bytes(s->pairs[i].kds);
    }
    return counts;
}

bmr_error bmr_simulation_audit(const bmr_simulation *s) {
    if (!s)
        return BMR_ERROR_NULL_ARGUMENT;
    for (size_t i = 0; i < s->pair_count; i++) {
        const bmr_pair_motion motion = motion_of(s, &s->pairs[i]);
        const bmr_pose pose = bmr_pair_instant(&motion, s->time).pose;
        const bmr_error error = bmr_kds_audit(s->pairs[i].kds, &pose);
        if (error != BMR_OK)
            return error;
    }
    return BMR_OK;
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
        error = bmr_simulation_create(&def, shapes, motions, 2, from, note_contact, &contact, allocator,
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
