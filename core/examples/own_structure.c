// SPDX-License-Identifier: MIT
// A kinetic structure of one's own, behind boomerang/kds.h: the line across the closest points, fixed to A,
// and a few vertices of B watched. Then a run of it beside one of the paper's. Links boomerang::kinetic, and
// so GSL.
#include <math.h>
#include <stdio.h>

#include "boomerang/kinetic.h"
#include "kds/structure.h"     // core's own: what a structure provides
#include "kds/windowed_line.h" // core's own: a line, and what stands for the other body

/// What the structure remembers of a pair is one windowed line: the line, and a few vertices of B around its
/// nearest one. They stand for all of B while B turns no farther than a bracket of directions.
static bmr_windowed_line *line_of(bmr_kds *kds) {
    return (bmr_windowed_line *)(void *)kds->state;
}
static const bmr_windowed_line *kept_line(const bmr_kds *kds) {
    return (const bmr_windowed_line *)(const void *)kds->state;
}

/// A new line, across the closest points; false: contact.
static bool start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    bmr_windowed_line *line = line_of(kds);
    uint32_t near[2] = {line->support[0], line->support[1]};
    bmr_vec2 direction;
    double distance;
    (void)report; // bmr_windowed_closest counts its steps
    if (!bmr_windowed_closest(kds, &now->pose, near, &direction, &distance))
        return false;
    bmr_windowed_line_set(line, kds, &now->pose, 0, direction, near);
    bmr_windowed_exact(line, kds, &now->pose, 0);
    return true;
}

/// What must hold: the window's vertices are beyond the line by more than the margin, and B's direction is in
/// the bracket. At most BMR_KDS_MAX_CONDITIONS, however many vertices B has.
static size_t conditions(const bmr_kds *kds, bmr_condition *conditions) {
    return bmr_windowed_conditions(kept_line(kds), kds->def.margin, conditions);
}

/// A condition has failed. If B has only turned out of the bracket, the line still separates and gets other
/// vertices of B. Otherwise the closest points are looked for anew, from where they were.
static bool repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    bmr_windowed_line *line = line_of(kds);
    const bmr_windowed_failure failure = bmr_windowed_fails(line, kds, now);
    (void)failed; // others may have failed at the same time
    if (!failure.crossed && failure.rolled == 0)
        return true; // too early: nothing has failed
    report->kind = BMR_KDS_ROLL;
    if (!failure.crossed) {
        bmr_windowed_exact(line, kds, &now->pose, failure.rolled);
        if (!bmr_windowed_fails(line, kds, now).crossed)
            return true;
    }
    report->kind = BMR_KDS_PUSH;
    report->line_changed = true;
    return start(kds, now, report);
}

static void proof(const bmr_kds *kds, bmr_kds_proof *proof) {
    bmr_windowed_proof(kept_line(kds), proof);
}

/// Beside the line, which is always audited: do the window's vertices stand for all of B?
static bmr_error audit(const bmr_kds *kds, const bmr_pose *b_in_a) {
    return bmr_windowed_audit(kept_line(kds), kds, b_in_a);
}

static const bmr_kds_class implementation = {.state_bytes = sizeof(bmr_windowed_line),
                                             .start = start,
                                             .conditions = conditions,
                                             .repair = repair,
                                             .proof = proof,
                                             .audit = audit};
static const bmr_kds_info own_structure = {.name = "own-line",
                                           .title = "the line across the closest points, fixed to A",
                                           .section = "an exercise",
                                           .domain = BMR_KDS_RIGID,
                                           .role = BMR_KDS_CONTROL,
                                           .hierarchy = -1,
                                           .implementation = &implementation};

/// One event: the structure is audited there, from nothing but the two polygons.
static void at_event(void *context, const bmr_simulation_event *event) {
    bmr_error *worst = context;
    if (*worst == BMR_OK)
        *worst = bmr_kds_audit(event->kds, &event->pose);
}

int main(void) {
    enum { VERTICES = 100 };
    bmr_vec2 ellipse[VERTICES];
    for (int i = 0; i < VERTICES; ++i) {
        const double angle = 2.0 * 3.14159265358979 * i / VERTICES;
        ellipse[i] = bmr_vec2_make(2.0 * cos(angle), sin(angle));
    }
    bmr_polygon *polygon = NULL;
    bmr_hierarchy *hierarchy = NULL;
    if (bmr_polygon_create(ellipse, VERTICES, NULL, &polygon) != BMR_OK ||
        bmr_hierarchy_build_dudley(polygon, NULL, &hierarchy) != BMR_OK)
        return 1;
    bmr_shape shape = {.polygon = polygon};
    shape.hierarchies[BMR_HIERARCHY_DUDLEY] = hierarchy;
    const bmr_shape shapes[2] = {shape, shape};
    const bmr_kds_info *structures[2] = {&own_structure, NULL};
    bmr_error error = bmr_kds_find("lazy-dudley", &structures[1]);

    // B passes A from the left and turns by 3 radians on the way.
    const bmr_pose left = {{-6.0, 3.2}, 1.0, 0.0};
    const bmr_motion_piece rest = bmr_piece_rest(bmr_pose_identity()),
                           pass = bmr_piece_screw(0.0, left, bmr_vec2_make(3.0, 0.0), 0.75);
    bmr_motion *motions[2] = {NULL, NULL};
    if (error == BMR_OK)
        error = bmr_motion_create(&rest, NULL, &motions[0]);
    if (error == BMR_OK)
        error = bmr_motion_create(&pass, NULL, &motions[1]);
    for (int k = 0; k < 2 && error == BMR_OK; ++k) {
        bmr_simulation_def def = bmr_default_simulation_def();
        def.structure = structures[k];
        bmr_simulation *simulation = NULL;
        bmr_error audit = BMR_OK;
        error = bmr_simulation_create(&def, shapes, motions, 0.0, at_event, &audit, NULL, &simulation);
        if (error != BMR_OK)
            break;
        error = bmr_simulation_run(simulation, 4.0);
        const bmr_simulation_counts counts = bmr_simulation_get_counts(simulation);
        printf("%-12s %llu lines, %llu elementary steps; audits: %s\n", structures[k]->name,
               (unsigned long long)counts.lines, (unsigned long long)counts.touched,
               audit == BMR_OK ? "all true" : bmr_error_describe(audit));
        bmr_simulation_destroy(simulation);
        error = error == BMR_OK ? audit : error;
    }
    bmr_motion_destroy(motions[0]);
    bmr_motion_destroy(motions[1]);
    bmr_hierarchy_destroy(hierarchy, NULL);
    bmr_polygon_destroy(polygon, NULL);
    return error == BMR_OK ? 0 : 1;
}
