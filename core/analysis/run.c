// SPDX-License-Identifier: MIT
// One structure along one course, and what that cost.
#include <math.h>
#include <string.h>

#include "analysis/course.h"
#include "geometry/distance.h"
#include "geometry/length.h"

// ---- a course: its poses, and how fast it is ----

bool bmr_course_is_valid(const bmr_course *course) {
    return isfinite(course->from) && isfinite(course->to) && course->from <= course->to;
}

bmr_pose bmr_course_pose(const bmr_course *course, double time) {
    const bmr_pose a = bmr_motion_pose(course->motions[0], time, NULL, NULL),
                   b = bmr_motion_pose(course->motions[1], time, NULL, NULL);
    return bmr_pose_relative(&a, &b);
}

double bmr_course_piece_end(const bmr_course *course, double time) {
    double end_a, end_b;
    bmr_motion_piece_at(course->motions[0], time, &end_a);
    bmr_motion_piece_at(course->motions[1], time, &end_b);
    return fmin(course->to, fmin(end_a, end_b));
}

double bmr_course_speed(const bmr_course *course, double from, double to, double weight) {
    const bmr_motion_piece *a = bmr_motion_piece_at(course->motions[0], from, NULL),
                           *b = bmr_motion_piece_at(course->motions[1], from, NULL);
    // A's frame sees B's origin move by its own speed, A's, and A's spin at its distance.
    const double own_a = bmr_motion_piece_speed(a, from, to, 0.0),
                 own_b = bmr_motion_piece_speed(b, from, to, 0.0);
    const bmr_pose pose = bmr_course_pose(course, from);
    const double reach = hypot(pose.position.x, pose.position.y) + (own_a + own_b) * (to - from);
    // The speed at a radius is at least that of the turning there less that of the origin.
    const double turning_a = bmr_motion_piece_speed(a, from, to, weight + reach) + own_a,
                 turning_b = weight > 0.0 ? bmr_motion_piece_speed(b, from, to, weight) + own_b : 0.0;
    return own_a + own_b + turning_a + turning_b;
}

double bmr_pose_distance(const bmr_polygon *a, const bmr_polygon *b, const bmr_pose *b_in_a) {
    bmr_simplex simplex = bmr_simplex_make(0, 0);
    bmr_closest closest;
    return bmr_closest_direction(a, b, b_in_a, 0.0, 0.0, &simplex, &closest) ? closest.separation : 0.0;
}

/// A displacement (in units of the distance) or rotation below this is none.
#define STILL 1e-9

bmr_hysteresis bmr_hysteresis_make(void) {
    const bmr_hysteresis h = {INFINITY, INFINITY, INFINITY, 0, {{0.0, 0.0}, 1.0, 0.0}, 0.0};
    return h;
}

void bmr_hysteresis_add(bmr_hysteresis *hysteresis, const bmr_polygon *a, const bmr_polygon *b,
                        double diameter, const bmr_pose *b_in_a) {
    bmr_hysteresis *h = hysteresis;
    if (h->distance > 0.0) {
        const double moved =
            hypot(b_in_a->position.x - h->pose.position.x, b_in_a->position.y - h->pose.position.y) /
            h->distance;
        const double turned = diameter * fabs(bmr_pose_turn(&h->pose, b_in_a)) / h->distance;
        h->intervals++;
        h->both = fmin(h->both, moved + turned);
        if (turned <= STILL)
            h->displacement = fmin(h->displacement, moved);
        if (moved <= STILL)
            h->rotation = fmin(h->rotation, turned);
    }
    h->pose = *b_in_a;
    h->distance = bmr_pose_distance(a, b, b_in_a);
}

typedef struct watch {
    const bmr_run_def *def;
    const bmr_course *course;
    double diameter;
    bmr_run *run;
} watch;

static bool is_repair(bmr_kds_event_kind kind) {
    return kind != BMR_KDS_START && kind != BMR_KDS_LEAVE && kind != BMR_KDS_CONTACT && kind != BMR_KDS_NONE;
}

static void observe(void *context, const bmr_simulation_event *event) {
    watch *w = context;
    bmr_run *run = w->run;
    if (event->report.kind != BMR_KDS_NONE) {
        bmr_hysteresis_add(&run->hysteresis, w->course->polygons[0], w->course->polygons[1], w->diameter,
                           &event->pose);
        if (!event->report.apart)
            run->hysteresis.distance = 0.0;
    }
    if (is_repair(event->report.kind)) {
        run->events++;
        run->lines += event->report.line_changed ? 1 : 0;
        run->qualities.touched += event->report.touched;
        run->qualities.touched_most = fmax(run->qualities.touched_most, event->report.touched);
    }
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    run->qualities.conditions =
        fmax(run->qualities.conditions, (double)bmr_kds_conditions(event->kds, conditions));
    if (w->def->audit && run->audit == BMR_OK)
        run->audit = bmr_kds_audit(event->kds, &event->pose);
    if (w->def->observer)
        w->def->observer(w->def->context, event);
}

/// Runs to half time, has a change of plan announced that changes nothing, and runs on.
static bmr_error run_through(bmr_simulation *simulation, const bmr_course *course, bmr_run *run) {
    bmr_error error = bmr_simulation_run(simulation, 0.5 * (course->from + course->to));
    const uint64_t before = bmr_simulation_get_counts(simulation).replanned;
    if (error == BMR_OK)
        error = bmr_simulation_replan(simulation);
    run->qualities.replanned = (double)(bmr_simulation_get_counts(simulation).replanned - before);
    return error == BMR_OK ? bmr_simulation_run(simulation, course->to) : error;
}

bmr_error bmr_run_course(const bmr_run_def *def, const bmr_course *course, double diameter,
                         const bmr_allocator *allocator, bmr_run *run) {
    if (!def || !course || !run || !def->structure)
        return BMR_ERROR_NULL_ARGUMENT;
    if (!bmr_course_is_valid(course))
        return BMR_ERROR_OUT_OF_RANGE;
    bmr_run result;
    memset(&result, 0, sizeof result);
    result.hysteresis = bmr_hysteresis_make();
    watch w = {def, course, diameter, &result};
    bmr_simulation_def simulation_def = def->simulation;
    simulation_def.structure = def->structure;
    bmr_simulation *simulation = NULL;
    bmr_error error = bmr_simulation_create(&simulation_def, def->shapes, course->motions, course->from,
                                            observe, &w, allocator, &simulation);
    if (error != BMR_OK)
        return error;
    error = run_through(simulation, course, &result);
    if (error == BMR_OK) {
        result.counts = bmr_simulation_get_counts(simulation);
        result.qualities.bytes = (double)result.counts.bytes;
        result.qualities.touched /= fmax((double)result.events, 1.0);
        result.qualities.efficiency = (double)result.events / fmax((double)result.counts.external, 1.0);
        *run = result;
    }
    bmr_simulation_destroy(simulation);
    return error;
}
