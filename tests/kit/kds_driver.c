// SPDX-License-Identifier: MIT
#include "kds_driver.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hierarchies.h"
#include "kds/structure.h"
#include "motions.h"

#define TWO_PI 6.283185307179586

/// So many repairs without the time going on, or without the conditions growing, are a loop.
#define BURST 200

/// What the rounding of a structure may cost at contact, as part of the extents (bmr_kds_def).
#define CONTACT_ROUNDING 1e-9

const bmr_kds_info *test_structure(const char *name) {
    const bmr_kds_info *info = NULL;
    if (bmr_kds_find(name, &info) != BMR_OK) {
        char text[1024];
        bmr_kds_describe_unknown(name, text, sizeof text);
        fprintf(stderr, "%s\n", text);
        abort();
    }
    return info;
}

test_kds_body test_kds_body_make(bmr_polygon *polygon) {
    test_kds_body body = {polygon, {NULL, NULL, NULL}, {.polygon = polygon}};
    for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT; ++kind)
        body.shape.hierarchies[kind] = body.hierarchies[kind] =
            test_hierarchy((bmr_hierarchy_kind)kind, polygon);
    return body;
}

test_kds_body test_kds_point_make(double x, double y) {
    const bmr_vec2 point = {x, y};
    bmr_polygon *polygon = NULL;
    if (bmr_polygon_create(&point, 1, NULL, &polygon) != BMR_OK)
        abort();
    return test_kds_body_make(polygon);
}

void test_kds_body_destroy(test_kds_body *body) {
    for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT; ++kind)
        bmr_hierarchy_destroy(body->hierarchies[kind], NULL);
    bmr_polygon_destroy(body->polygon, NULL);
}

bmr_instant test_path_at(const test_path *path, double t) {
    bmr_instant now = {{path->cubic[0], 1.0, 0.0}, {0.0, 0.0}, 0.0};
    double power = 1.0; // t^(k-1)
    for (int k = 1; k < 4; ++k) {
        now.pose.position = bmr_add(now.pose.position, bmr_scale(power * t, path->cubic[k]));
        now.velocity = bmr_add(now.velocity, bmr_scale(k * power, path->cubic[k]));
        power *= t;
    }
    for (int k = 0; k < TEST_PATH_HARMONICS; ++k) {
        if (path->radius[k] == 0.0)
            continue; // most paths have none
        const double w = path->frequency[k], a = w * t + path->phase[k];
        const bmr_vec2 around = bmr_scale(path->radius[k], bmr_vec2_make(cos(a), sin(a)));
        now.pose.position = bmr_add(now.pose.position, around);
        now.velocity = bmr_add(now.velocity, bmr_scale(w, bmr_left(around)));
    }
    double angle = path->angle + path->spin * t;
    now.spin = path->spin;
    if (path->swing != 0.0) {
        const double w = path->swing_frequency;
        angle += path->swing * sin(w * t);
        now.spin += path->swing * w * cos(w * t);
    }
    now.pose.c = cos(angle);
    now.pose.s = sin(angle);
    return now;
}

static double length(bmr_vec2 v) {
    return hypot(v.x, v.y);
}

void test_path_bounds(const test_path *path, double *speed, double *spin, double *reach) {
    *speed = 0.0;
    *reach = length(path->cubic[0]);
    for (int k = 1; k < 4; ++k) {
        *speed += k * length(path->cubic[k]);
        *reach += length(path->cubic[k]);
    }
    for (int k = 0; k < TEST_PATH_HARMONICS; ++k) {
        *speed += fabs(path->radius[k] * path->frequency[k]);
        *reach += fabs(path->radius[k]);
    }
    *spin = fabs(path->spin) + fabs(path->swing * path->swing_frequency);
}

test_path test_path_make(test_path_kind kind, const bmr_polygon *a, const bmr_polygon *b, double gap,
                         bool rotates, test_random *random) {
    test_path path;
    memset(&path, 0, sizeof path);
    const double side = test_random_uniform(random, 0.0, TWO_PI);
    path.angle = test_random_uniform(random, 0.0, TWO_PI);
    const bmr_pose near = test_pose_at(a, b, side, path.angle, gap);
    const bmr_vec2 out = {cos(side), sin(side)}, along = bmr_left(out);
    const double size = a->radius + b->radius;
    // Times run from 0 to 1, and the path is nearest at 1/2: p(t) = near + along k (t - 1/2) + out b (t -
    // 1/2)^2 + along q (t - 1/2)^3.
    const double k = size * test_random_uniform(random, 2.0, 6.0);
    double bend = 0.0, twist = 0.0;
    bmr_vec2 v = bmr_scale(k, along);
    if (kind == TEST_PATH_PARABOLA || kind == TEST_PATH_CUBIC)
        bend = size * test_random_uniform(random, 1.0, 6.0);
    if (kind == TEST_PATH_CUBIC)
        twist = size * test_random_uniform(random, -9.0, 9.0);
    if (kind == TEST_PATH_HIT) // the centres meet at time 1
        v = bmr_scale(2.0, bmr_sub(bmr_sub(a->center, bmr_rotate(&near, b->center)), near.position));
    const bmr_vec2 w = bmr_scale(bend, out), x = bmr_scale(twist, along);
    path.cubic[0] = bmr_add(bmr_add(near.position, bmr_scale(-0.5, v)),
                            bmr_add(bmr_scale(0.25, w), bmr_scale(-0.125, x)));
    path.cubic[1] = bmr_add(bmr_sub(v, w), bmr_scale(0.75, x));
    path.cubic[2] = bmr_sub(w, bmr_scale(1.5, x));
    path.cubic[3] = x;
    if (kind == TEST_PATH_ORBIT || kind == TEST_PATH_WANDER) {
        memset(path.cubic, 0, sizeof path.cubic);
        path.cubic[0] = a->center;
        path.radius[0] = size + gap;
        path.frequency[0] = test_random_below(random, 2) ? TWO_PI : -TWO_PI;
        path.phase[0] = side;
    }
    if (kind == TEST_PATH_WANDER)
        for (int h = 1; h < TEST_PATH_HARMONICS; ++h) {
            path.radius[h] = 0.4 * size * test_random_uniform(random, 0.1, 1.0);
            path.frequency[h] = TWO_PI * test_random_uniform(random, -12.0, 12.0);
            path.phase[h] = test_random_uniform(random, 0.0, TWO_PI);
        }
    if (rotates) {
        path.spin = test_random_uniform(random, -TWO_PI, TWO_PI);
        path.swing = test_random_uniform(random, 0.0, 1.0);
        path.swing_frequency = TWO_PI * test_random_uniform(random, 0.0, 3.0);
        // At the middle the angle shall be the one the gap was measured at.
        path.angle -= 0.5 * path.spin + path.swing * sin(0.5 * path.swing_frequency);
        // So that the centres of a HIT still meet, whatever the angle at its end.
        const bmr_instant end = test_path_at(&path, 1.0);
        const bmr_vec2 off = bmr_sub(bmr_rotate(&end.pose, b->center), bmr_rotate(&near, b->center));
        if (kind == TEST_PATH_HIT)
            path.cubic[2] = bmr_sub(path.cubic[2], off);
    }
    return path;
}

/// A drive at work.
typedef struct drive {
    bmr_kds *kds;
    const bmr_polygon *a, *b;
    const test_drive *def;
    test_drive_result *result;
    double time, resolution;
    double speed, spin; ///< the fastest that a BEYOND or DISKS, and a TURN condition can fall
    size_t count;
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    bool armed[BMR_KDS_MAX_CONDITIONS]; ///< was above 0 since the last event
    bool fresh;                         ///< nothing has moved since the last event
    unsigned burst;                     ///< repairs since `burst_time`
    double burst_time;
    unsigned stalls; ///< repairs since all conditions were seen above 0
} drive;

/// No pair farther apart may be in contact.
static double contact_reach(const drive *d) {
    return d->kds->def.margin + CONTACT_ROUNDING * (d->a->extent + d->b->extent);
}

static void audit(drive *d, const bmr_pose *pose) {
    const bmr_error error = bmr_kds_audit(d->kds, pose);
    if (error != BMR_OK && d->result->false_audits++ == 0) {
        d->result->error = error;
        bmr_kds_proof proof = {0};
        bmr_kds_get_proof(d->kds, &proof);
        fprintf(stderr,
                "%s, %u and %u vertices: the audit at t = %.17g, level %d, line (%.17g, %.17g) of %c: %s\n",
                d->kds->info->name, d->a->count, d->b->count, d->time, proof.level, proof.line.normal.x,
                proof.line.normal.y, proof.owner == 0 ? 'A' : 'B', bmr_error_describe(error));
    }
    // Another way to the distance than the audit's.
    const double distance = test_distance(d->a, d->b, pose);
    d->result->nearest = fmin(d->result->nearest, distance);
    if (!bmr_kds_in_contact(d->kds) && distance <= 0.0)
        ++d->result->missed_contacts;
}

/// After a start or repair: takes the conditions anew.
static void rearm(drive *d, const bmr_pose *pose) {
    d->count = bmr_kds_conditions(d->kds, d->conditions);
    for (size_t i = 0; i < d->count; ++i)
        d->armed[i] = bmr_condition_value(&d->conditions[i], pose) > 0.0;
    d->fresh = true;
}

static void tell(drive *d, const bmr_instant *now, const bmr_kds_report *report,
                 const bmr_condition *failed) {
    ++d->result->events[report->kind];
    if (!report->apart && report->kind == BMR_KDS_CONTACT) {
        if (test_distance(d->a, d->b, &now->pose) > contact_reach(d))
            ++d->result->false_contacts;
        if (d->result->contact_time > d->time)
            d->result->contact_time = d->time;
    }
    if (d->def->on_event) {
        test_drive_event event = {d->time, *now, *report, {{0, 0}, 0, {0, 0}, 0, 0, 0, {0}}, d->kds};
        if (failed)
            event.failed = *failed;
        d->def->on_event(d->def->context, &event);
    }
}

static void start(drive *d, const bmr_instant *now) {
    bmr_kds_report report;
    const bool contact = bmr_kds_in_contact(d->kds);
    bmr_kds_start(d->kds, now, &report);
    if (!contact || report.apart) // contact that goes on is no event
        tell(d, now, &report, NULL);
    rearm(d, &now->pose);
    audit(d, &now->pose);
}

static bool same_line(const bmr_kds_proof *p, const bmr_kds_proof *q) {
    return p->owner == q->owner && p->line.normal.x == q->line.normal.x &&
           p->line.normal.y == q->line.normal.y && p->line.offset == q->line.offset;
}

static void repair(drive *d, const bmr_instant *now, size_t failed) {
    const bmr_condition condition = d->conditions[failed];
    bmr_condition before[BMR_KDS_MAX_CONDITIONS];
    memcpy(before, d->conditions, sizeof before);
    const size_t count = d->count;
    bmr_kds_proof old, made;
    bmr_kds_report report;
    const bool was_apart = bmr_kds_get_proof(d->kds, &old);
    bmr_kds_repair(d->kds, now, failed, &report);
    if (was_apart && bmr_kds_get_proof(d->kds, &made) && !report.line_changed && !same_line(&old, &made))
        ++d->result->silent_lines;
    tell(d, now, &report, &condition);
    rearm(d, &now->pose);
    if (report.kind == BMR_KDS_NONE &&
        (count != d->count || memcmp(before, d->conditions, count * sizeof *before) != 0))
        ++d->result->changed_by_none;
    audit(d, &now->pose);
    if (d->time - d->burst_time > d->resolution) {
        d->burst_time = d->time;
        d->burst = 0;
    }
    if (++d->burst > BURST || ++d->stalls > BURST)
        ++d->result->dead_repairs;
}

/// How far time may safely go: no armed condition can reach 0 before. At least the resolution.
static double cautious_step(const drive *d, const bmr_pose *pose) {
    double step = 0.01;
    for (size_t i = 0; i < d->count; ++i)
        if (d->armed[i]) {
            const bool turn = d->conditions[i].kind == BMR_CONDITION_TURN;
            const double rate = turn ? d->spin : d->speed;
            const double value = bmr_condition_value(&d->conditions[i], pose);
            if (rate * step > value)
                step = value / rate;
        } else // must be seen to grow
            step = 0.0;
    return fmax(step, d->resolution);
}

/// The index of an armed condition that has failed at the pose, or `count`.
static size_t failed_at(const drive *d, const bmr_pose *pose) {
    for (size_t i = 0; i < d->count; ++i)
        if (d->armed[i] && !(bmr_condition_value(&d->conditions[i], pose) > 0.0))
            return i;
    return d->count;
}

/// The first failure in (low, high], at whose end one has failed: to the last bit of the time.
static size_t bisect(drive *d, double low, double high) {
    while (high - low > 1e-15) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high)
            break;
        const bmr_instant now = test_path_at(d->def->path, middle);
        if (failed_at(d, &now.pose) < d->count)
            high = middle;
        else
            low = middle;
    }
    d->time = high;
    const bmr_instant now = test_path_at(d->def->path, high);
    return failed_at(d, &now.pose);
}

static void advance(drive *d) {
    const bmr_instant here = test_path_at(d->def->path, d->time);
    const double next = fmin(1.0, d->time + cautious_step(d, &here.pose));
    const bmr_instant there = test_path_at(d->def->path, next);
    const bool fresh = d->fresh;
    d->fresh = false;
    if (failed_at(d, &there.pose) < d->count) {
        const size_t failed = bisect(d, d->time, next);
        const bmr_instant now = test_path_at(d->def->path, d->time);
        repair(d, &now, failed);
        return;
    }
    d->time = next;
    bool all = true;
    for (size_t i = 0; i < d->count; ++i) {
        if (d->armed[i])
            continue;
        all = false;
        d->armed[i] = bmr_condition_value(&d->conditions[i], &there.pose) > 0.0;
        if (!d->armed[i] && !fresh) { // it had its time to grow
            repair(d, &there, i);
            return;
        }
    }
    if (all)
        d->stalls = 0;
}

test_drive_result test_drive_run(bmr_kds *kds, const bmr_polygon *a, const bmr_polygon *b,
                                 const test_drive *def) {
    test_drive_result result = {.contact_time = INFINITY, .nearest = INFINITY};
    drive d = {.kds = kds, .a = a, .b = b, .def = def, .result = &result, .burst_time = -1.0};
    d.resolution = def->resolution > 0.0 ? def->resolution : 1e-6;
    double speed, reach;
    test_path_bounds(def->path, &speed, &d.spin, &reach);
    d.speed = speed + d.spin * (2.0 * (a->extent + b->extent) + reach);
    const unsigned every = def->audit_every > 0 ? def->audit_every : 16;
    bmr_instant now = test_path_at(def->path, 0.0);
    start(&d, &now);
    for (unsigned step = 1; d.time < 1.0 && result.dead_repairs == 0; ++step) {
        if (bmr_kds_in_contact(kds)) {
            if (def->stop_at_contact)
                break;
            d.time = fmin(1.0, d.time + fmax(d.resolution, 1e-3));
            now = test_path_at(def->path, d.time);
            start(&d, &now);
            continue;
        }
        advance(&d);
        if (step % every == 0 && !d.fresh) {
            now = test_path_at(def->path, d.time);
            audit(&d, &now.pose);
        }
    }
    return result;
}

uint64_t test_drive_events(const test_drive_result *result) {
    uint64_t events = 0;
    for (int kind = 0; kind < BMR_KDS_EVENT_KIND_COUNT; ++kind)
        if (kind != BMR_KDS_START && kind != BMR_KDS_LEAVE && kind != BMR_KDS_CONTACT && kind != BMR_KDS_NONE)
            events += result->events[kind];
    return events;
}

static bool same_condition(const bmr_condition *k, const bmr_condition *l) {
    return k->kind == l->kind && k->owner == l->owner && k->label == l->label && k->offset == l->offset &&
           k->normal.x == l->normal.x && k->normal.y == l->normal.y && k->point.x == l->point.x &&
           k->point.y == l->point.y;
}

bool test_waits_for(const bmr_kds *kds, const bmr_condition *condition) {
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    const size_t count = bmr_kds_conditions(kds, conditions);
    size_t i = 0;
    while (i < count && !same_condition(&conditions[i], condition))
        i++;
    return i < count;
}
