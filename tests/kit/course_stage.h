// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_COURSE_STAGE_H
#define BMR_TEST_COURSE_STAGE_H

#include "boomerang/analysis.h"
#include "checks.h"
#include "kds_driver.h"

/// @file
/// Two bodies and one motion of them from a family. In C.

static inline bmr_polygon *ngon(bmr_ngon kind, size_t n, uint64_t seed) {
    bmr_vec2 *points = malloc(n * sizeof *points);
    assert_non_null(points);
    assert_int_equal(bmr_ngon_points(kind, n, seed, points), BMR_OK);
    bmr_polygon *polygon = made_polygon(points, n);
    free(points);
    return polygon;
}

static inline bmr_family_motion family_motion(bmr_family family, double ratio, uint64_t seed,
                                              const bmr_polygon *a, const bmr_polygon *b) {
    const bmr_family_def def = {family, ratio, seed, 0, 0};
    bmr_family_motion m;
    assert_int_equal(bmr_family_create(&def, a, b, NULL, &m), BMR_OK);
    return m;
}

/// Where the second body is in the first one's frame.
static inline bmr_pose relative_at(bmr_motion *const motions[2], double time) {
    const bmr_pose a = bmr_motion_pose(motions[0], time, NULL, NULL),
                   b = bmr_motion_pose(motions[1], time, NULL, NULL);
    return bmr_pose_relative(&a, &b);
}

/// A rests at the origin while B moves, from 0 to 1. It owns the motions.
static inline bmr_course course_along(const bmr_polygon *a, const bmr_polygon *b, bmr_motion_piece piece) {
    const bmr_course course = {
        {a, b}, {made_motion(bmr_piece_rest(bmr_pose_identity())), made_motion(piece)}, 0.0, 1.0};
    return course;
}
/// The same on a straight way.
static inline bmr_course course_past(const bmr_polygon *a, const bmr_polygon *b, double x, double y,
                                     double vx, double vy) {
    const bmr_pose from = {{x, y}, 1.0, 0.0};
    return course_along(a, b, bmr_piece_screw(0.0, from, bmr_vec2_make(vx, vy), 0.0));
}
static inline void leave_course(const bmr_course *course) {
    for (int k = 0; k < 2; ++k)
        bmr_motion_destroy(course->motions[k]);
}
#define own_course OWNED(leave_course) bmr_course

typedef struct stage {
    test_kds_body bodies[2];
    bmr_family_motion motion;
    bmr_course course;
} stage;

/// It owns the bodies.
static inline stage stage_with(test_kds_body a, test_kds_body b, bmr_family_def def) {
    stage s = {.bodies = {a, b}};
    assert_int_equal(bmr_family_create(&def, a.polygon, b.polygon, NULL, &s.motion), BMR_OK);
    s.course = (bmr_course){{a.polygon, b.polygon}, {s.motion.motions[0], s.motion.motions[1]}, 0.0, 1.0};
    return s;
}
static inline stage stage_of(bmr_polygon *a, bmr_polygon *b, bmr_family_def def) {
    return stage_with(test_kds_body_make(a), test_kds_body_make(b), def);
}

static inline void strike(stage *s) {
    bmr_family_destroy(&s->motion);
    test_kds_body_destroy(&s->bodies[0]);
    test_kds_body_destroy(&s->bodies[1]);
}
#define own_stage OWNED(strike) stage

/// Of a structure on a stage, audited at each event; `def` may have a margin and an observer.
static inline bmr_run run_of(const stage *s, const bmr_kds_info *structure, bmr_run_def def) {
    bmr_run run;
    def.structure = structure;
    def.audit = true;
    for (int k = 0; k < 2; ++k)
        def.shapes[k] = s->bodies[k].shape;
    assert_int_equal(bmr_run_course(&def, &s->course, s->motion.diameter, NULL, &run), BMR_OK);
    if (run.audit != BMR_OK)
        fail_msg("%s: %s", structure->name, bmr_error_describe(run.audit));
    return run;
}
static inline bmr_run plain_run_of(const stage *s, const bmr_kds_info *structure) {
    return run_of(s, structure, (bmr_run_def){.simulation = bmr_default_simulation_def()});
}

#endif
