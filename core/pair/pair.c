// SPDX-License-Identifier: MIT
#include "boomerang/pair.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "pair/step.h"

/// A pose whose c^2 + s^2 is off 1 by more is no rigid motion, and nothing is proved about it.
#define UNIT_TOLERANCE 1e-3

/// Of the need, what a certificate's own relative rounding and the distance query's tolerance may hide: 2^-22
/// and 2e-8, and room for the squares of these.
#define NEED_LOSS 4e-7

const char *bmr_structure_name(bmr_structure structure) {
    switch (structure) {
    case BMR_LAZY_COMPASS:
        return "lazy-compass";
    case BMR_LAZY_DUDLEY:
        return "lazy-dudley";
    case BMR_LAZY_DOBKIN_KIRKPATRICK:
        return "lazy-dobkin-kirkpatrick";
    case BMR_FREE_DIRECTION:
        return "free-direction";
    case BMR_STRUCTURE_COUNT:
        break;
    }
    return NULL;
}

const char *bmr_event_name(bmr_event_kind kind) {
    switch (kind) {
    case BMR_EVENT_START:
        return "start";
    case BMR_EVENT_PUSH:
        return "push";
    case BMR_EVENT_STAB:
        return "stab";
    case BMR_EVENT_ROLL:
        return "roll";
    case BMR_EVENT_COARSEN:
        return "coarsen";
    case BMR_EVENT_CONTACT:
        return "contact";
    case BMR_EVENT_LEAVE:
        return "leave";
    case BMR_EVENT_KIND_COUNT:
        break;
    }
    return NULL;
}

bmr_pair_def bmr_default_pair_def(void) {
    const bmr_pair_def def = {BMR_LAZY_COMPASS, 0.0, 0.0};
    return def;
}

void bmr_pair_init(bmr_pair *pair) {
    memset(pair, 0, sizeof *pair);
    pair->state = BMR_PAIR_NEW;
}

void bmr_step_tell(const bmr_step *step, bmr_event_kind kind, int level_before, int level_after, double gap) {
    const bmr_observer *observer = step->observer;
    if (!observer)
        return;
    if (observer->counters)
        ++observer->counters->events[kind];
    if (observer->on_event) {
        const bmr_event event = {kind, level_before, level_after, step->pair, step->pose, gap};
        observer->on_event(observer->context, &event);
    }
}

void bmr_step_count_levels(const bmr_step *step, int levels) {
    if (step->observer && step->observer->counters)
        step->observer->counters->levels += (uint64_t)levels;
}

bmr_simplex bmr_contact_simplex(const bmr_pair *pair) {
    const uint32_t packed[3] = {pair->edge, pair->other, pair->other_after};
    bmr_simplex simplex = bmr_simplex_make(0, 0);
    simplex.count = pair->simplex;
    for (uint32_t i = 0; i < 3; ++i) { // past the count: read by nobody
        simplex.a[i] = packed[i] & 0xffffu;
        simplex.b[i] = packed[i] >> 16;
    }
    return simplex;
}

bmr_answer bmr_contact_enter(bmr_step *step, const bmr_simplex *simplex, int level) {
    bmr_pair *pair = step->pair;
    const bool entering = pair->state != BMR_PAIR_CONTACT;
    const int level_before = pair->state == BMR_PAIR_NEW ? BMR_LEVEL_DISKS : pair->level;
    uint32_t packed[3] = {0, 0, 0};
    for (uint32_t i = 0; i < simplex->count; ++i)
        packed[i] = simplex->a[i] | simplex->b[i] << 16;
    pair->edge = packed[0];
    pair->other = packed[1];
    pair->other_after = packed[2];
    pair->simplex = (uint8_t)simplex->count;
    pair->state = BMR_PAIR_CONTACT;
    pair->level = (int8_t)level;
    pair->free = 0;
    if (entering)
        bmr_step_tell(step, BMR_EVENT_CONTACT, level_before, level, 0.0);
    return BMR_STAB_POLYGON;
}

bool bmr_step_closest(const bmr_step *step, bmr_simplex *simplex, bmr_closest *closest) {
    return bmr_closest_direction(step->shapes[0]->polygon, step->shapes[1]->polygon, step->pose, step->reach,
                                 BMR_CLOSEST_SLACK, simplex, closest);
}

static bmr_check look(const bmr_pair *pair, const bmr_pose *b_in_a, double margin, double *gap) {
    if (pair->level == BMR_LEVEL_DISKS) {
        *gap = bmr_disks_gap(&pair->certificate, b_in_a);
        return *gap > margin ? BMR_CHECK_HOLDS : BMR_CHECK_CROSSED;
    }
    return bmr_certificate_check_pair(&pair->certificate, b_in_a, pair->owner, margin, gap);
}

bool bmr_step_holds(const bmr_step *step, double need, double *gap) {
    return look(step->pair, step->pose, need, gap) == BMR_CHECK_HOLDS;
}

/// False for NaN and infinity too.
static bool is_rigid(const bmr_pose *q) {
    return fabs(q->c * q->c + q->s * q->s - 1.0) <= UNIT_TOLERANCE &&
           fabs(q->position.x) + fabs(q->position.y) <= DBL_MAX;
}

static bmr_failure failure_of(const bmr_pair *pair, bmr_check check) {
    if (pair->state == BMR_PAIR_NEW)
        return BMR_FAILURE_NEW;
    if (pair->state == BMR_PAIR_CONTACT)
        return BMR_FAILURE_CONTACT;
    if (pair->level == BMR_LEVEL_DISKS)
        return BMR_FAILURE_DISKS;
    return check == BMR_CHECK_ROLLED ? BMR_FAILURE_ROLLED : BMR_FAILURE_CROSSED;
}

/// Out of line: what is done when the quick look says no.
static bmr_answer repair(bmr_pair *pair, const bmr_pair_def *def, const bmr_shape *a, const bmr_shape *b,
                         const bmr_pose *b_in_a, const bmr_observer *observer, bmr_check check, double *gap) {
    bmr_step step = {pair, def, {a, b}, b_in_a, observer, def->margin, 0.0};
    if (pair->state == BMR_PAIR_CONTACT)
        step.need += def->hysteresis;
    step.reach =
        step.need * (1.0 + NEED_LOSS) + BMR_CERTIFICATE_LOSS * (a->polygon->extent + b->polygon->extent);
    const bmr_failure failure = failure_of(pair, check);
    *gap = 0.0;
    const bmr_answer answer = def->structure == BMR_FREE_DIRECTION ? bmr_free_repair(&step, failure, gap)
                                                                   : bmr_lazy_repair(&step, failure, gap);
    if (answer != BMR_APART)
        *gap = 0.0;
    return answer;
}

bmr_answer bmr_pair_advance(bmr_pair *pair, const bmr_pair_def *def, const bmr_shape *a, const bmr_shape *b,
                            const bmr_pose *b_in_a, const bmr_observer *observer, double *gap) {
    double unwanted;
    if (!gap)
        gap = &unwanted;
    if (observer && observer->counters)
        ++observer->counters->checks;
    if (!is_rigid(b_in_a)) {
        bmr_pair_init(pair);
        *gap = 0.0;
        return BMR_STAB_POLYGON;
    }
    bmr_check check = BMR_CHECK_CROSSED;
    if (pair->state == BMR_PAIR_APART) {
        check = look(pair, b_in_a, def->margin, gap);
        if (check == BMR_CHECK_HOLDS)
            return BMR_APART;
    }
    return repair(pair, def, a, b, b_in_a, observer, check, gap);
}
