// SPDX-License-Identifier: MIT
// A kinetic structure of one's own, behind boomerang/kds.h: the line across the closest points, fixed to A,
// and every vertex of B watched. Then a run of it beside one of the paper's. Links boomerang::kinetic, and so
// GSL.
#include <stdio.h>

#include "boomerang/kinetic.h"
#include "kds/structure.h" // core's own: what a structure provides

/// What the structure remembers of a pair.
typedef struct own_line {
    bmr_line line;           ///< A's frame: all of A is on or behind it
    uint32_t hint_a, hint_b; ///< the vertices that the last search ended at
} own_line;

/// Each vertex of B has a condition, and there are only so many.
static bmr_error prepare(bmr_kds *kds) {
    return kds->shapes[1].polygon->count <= BMR_KDS_MAX_CONDITIONS ? BMR_OK : BMR_ERROR_OUT_OF_RANGE;
}

/// A new line, across the closest points; false: contact. Where rounding leaves nothing of the gap, that is
/// contact, too.
static bool start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    own_line *own = (own_line *)(void *)kds->state;
    const bmr_polygon *a = kds->shapes[0].polygon, *b = kds->shapes[1].polygon;
    double distance;
    (void)report; // bmr_kds_closest counts its steps
    if (!bmr_kds_closest(kds, &now->pose, &own->hint_a, &own->hint_b, &own->line.normal, &distance) ||
        distance < kds->def.margin + 1e-10 * (a->extent + b->extent))
        return false;
    own->line.offset = bmr_dot(own->line.normal, a->vertices[own->hint_a]);
    return true;
}

/// What must hold: every vertex of B is beyond the line by more than the margin.
static size_t conditions(const bmr_kds *kds, bmr_condition *conditions) {
    const own_line *own = (const own_line *)(const void *)kds->state;
    const bmr_polygon *b = kds->shapes[1].polygon;
    for (uint32_t i = 0; i < b->count; ++i)
        conditions[i] = bmr_condition_beyond(0, own->line.normal, own->line.offset + kds->def.margin,
                                             b->vertices[i], (int)i);
    return b->count;
}

/// A vertex is on the line: the closest points are looked for anew, from where they were.
static bool repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    bmr_condition all[BMR_KDS_MAX_CONDITIONS];
    if (failed >= conditions(kds, all) || bmr_condition_value(&all[failed], &now->pose) > 0.0)
        return true; // too early: nothing has failed
    report->kind = BMR_KDS_PUSH;
    report->line_changed = true;
    return start(kds, now, report);
}

static void proof(const bmr_kds *kds, bmr_kds_proof *proof) {
    const own_line *own = (const own_line *)(const void *)kds->state;
    *proof = (bmr_kds_proof){.line = own->line, .nearest = kds->shapes[1].polygon->vertices[own->hint_b]};
}

static const bmr_kds_class implementation = {.state_bytes = sizeof(own_line),
                                             .prepare = prepare,
                                             .start = start,
                                             .conditions = conditions,
                                             .repair = repair,
                                             .proof = proof};
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
    const bmr_vec2 hexagon[] = {{2, 0}, {1, 1}, {-1, 1}, {-2, 0}, {-1, -1}, {1, -1}};
    bmr_polygon *polygon = NULL;
    bmr_hierarchy *hierarchy = NULL;
    if (bmr_polygon_create(hexagon, 6, NULL, &polygon) != BMR_OK ||
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
        error = bmr_simulation_create(&def, shapes, motions, 2, 0.0, at_event, &audit, NULL, &simulation);
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
