// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_COURSE_STAGE_H
#define BMR_TEST_COURSE_STAGE_H

#include "boomerang/analysis.h"
#include "checks.h"
#include "kds_driver.h"

/// @file
/// Two bodies and one motion of them from a family. In C.

static inline bmr_polygon *outline(bmr_outline kind, size_t n, uint64_t seed) {
    bmr_vec2 *points = malloc(n * sizeof *points);
    assert_non_null(points);
    assert_int_equal(bmr_outline_points(kind, n, seed, points), BMR_OK);
    bmr_polygon *polygon = made_polygon(points, n);
    free(points);
    return polygon;
}

typedef struct stage {
    test_kds_body bodies[2];
    bmr_family_motion motion;
    bmr_course course;
} stage;

/// It owns the polygons.
static inline stage stage_of(bmr_polygon *a, bmr_polygon *b, bmr_family_def def) {
    stage s = {.bodies = {test_kds_body_make(a), test_kds_body_make(b)}};
    assert_int_equal(bmr_family_create(&def, a, b, NULL, &s.motion), BMR_OK);
    s.course = (bmr_course){{a, b}, {s.motion.motions[0], s.motion.motions[1]}, 0.0, 1.0};
    return s;
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
