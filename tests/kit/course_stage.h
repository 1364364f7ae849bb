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
    bmr_polygon *polygon = NULL;
    assert_non_null(points);
    assert_int_equal(bmr_outline_points(kind, n, seed, points), BMR_OK);
    assert_int_equal(bmr_polygon_create(points, n, NULL, &polygon), BMR_OK);
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

#endif
