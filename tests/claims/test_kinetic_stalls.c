// SPDX-License-Identifier: MIT
// Courses on which a pair once had event after event while time stood still: a structure was left where it
// was, because what it computed of a border and what the search for failures computed differed by a rounding.
#include <math.h>
#include <stdlib.h>

#include "checks.h"

#include "boomerang/analysis.h"
#include "kds_driver.h"
#include "structure_named.h"

static test_kds_body body(bmr_outline kind, size_t n, uint64_t seed) {
    bmr_vec2 *points = malloc(n * sizeof *points);
    bmr_polygon *polygon = NULL;
    assert_non_null(points);
    assert_int_equal(bmr_outline_points(kind, n, seed, points), BMR_OK);
    assert_int_equal(bmr_polygon_create(points, n, NULL, &polygon), BMR_OK);
    free(points);
    return test_kds_body_make(polygon);
}

/// One of the courses.
typedef struct stall {
    const char *structure;
    bmr_family family;
    bmr_outline outline;
    size_t n;
    double ratio;
    uint64_t seed;
} stall;

typedef struct watch {
    size_t events, kept; ///< repairs, and those after which the condition that had failed is there again
    size_t seen;         ///< a control: of the conditions that are there, those that are seen
} watch;

static bool same_condition(const bmr_condition *k, const bmr_condition *l) {
    return k->kind == l->kind && k->owner == l->owner && k->label == l->label && k->offset == l->offset &&
           k->normal.x == l->normal.x && k->normal.y == l->normal.y && k->point.x == l->point.x &&
           k->point.y == l->point.y;
}

static bool waits_for(const bmr_kds *kds, const bmr_condition *condition) {
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    const size_t count = bmr_kds_conditions(kds, conditions);
    size_t i = 0;
    while (i < count && !same_condition(&conditions[i], condition))
        i++;
    return i < count;
}

static void observe(void *context, const bmr_simulation_event *event) {
    watch *w = context;
    if (event->report.kind == BMR_KDS_START || event->report.kind == BMR_KDS_NONE)
        return;
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    w->events++;
    w->kept += waits_for(event->kds, &event->failed);
    w->seen += bmr_kds_conditions(event->kds, conditions) > 0 && waits_for(event->kds, &conditions[0]);
}

static void follow(const stall *s) {
    test_kds_body a = body(s->outline, s->n, 2 * s->seed), b = body(s->outline, s->n, 2 * s->seed + 1);
    const bmr_family_def family = {s->family, s->ratio, s->seed, 0, 0};
    bmr_family_motion motion;
    assert_int_equal(bmr_family_create(&family, a.polygon, b.polygon, NULL, &motion), BMR_OK);
    watch w = {0, 0, 0};
    bmr_run_def def = {.structure = test_structure(s->structure),
                       .shapes = {a.shape, b.shape},
                       .simulation = bmr_default_simulation_def(),
                       .audit = true,
                       .observer = observe,
                       .context = &w};
    // Far below the separation, or the pair would be in contact.
    def.simulation.kds.margin = fmin(def.simulation.kds.margin, 1e-3 * motion.separation);
    const bmr_course course = {{a.polygon, b.polygon}, {motion.motions[0], motion.motions[1]}, 0.0, 1.0};
    bmr_run run;
    assert_int_equal(bmr_run_course(&def, &course, motion.diameter, NULL, &run), BMR_OK);
    printf("%s on %s, n %zu: %zu events\n", s->structure, bmr_family_name(s->family), s->n, w.events);
    assert_int_equal(run.audit, BMR_OK);
    assert_int_equal(run.counts.external, 0);
    assert_true(w.events > 100 && w.seen == w.events);
    assert_int_equal(w.kept, 0);
    bmr_family_destroy(&motion);
    test_kds_body_destroy(&a);
    test_kds_body_destroy(&b);
}

/// The side is crossed at 1e-4 of the pair's speed, and a little ahead the point is beyond it by less than a
/// rounding.
TEST(sides_that_are_crossed_at_a_small_angle) {
    static const stall stalls[] = {
        {"active-cell-compass", BMR_FAMILY_ORBIT, BMR_OUTLINE_REGULAR, 64, 300000.0, 1},
        {"tiling-compass", BMR_FAMILY_ORBIT, BMR_OUTLINE_REGULAR, 64, 300000.0, 1}};
    for (size_t i = 0; i < sizeof stalls / sizeof *stalls; i++)
        follow(&stalls[i]);
}
