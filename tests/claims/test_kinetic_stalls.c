// SPDX-License-Identifier: MIT
// No pair has event after event while time stands still. A structure is repaired where what it computes of a
// border and what the search for failures computes differ by a rounding; and it goes on where a motion turns
// round, slowly, right after a condition has failed.
#include "boomerang/simulation.h"
#include "checks.h"
#include "course_stage.h"
#include "kds_driver.h"
#include "motions.h"

/// One of the courses.
typedef struct stall {
    const char *structure;
    bmr_family family;
    bmr_ngon ngon;
    size_t n;
    double ratio;
    uint64_t seed;
} stall;

typedef struct watch {
    size_t events, kept; ///< repairs, and those after which the condition that had failed is there again
    size_t seen;         ///< a control: of the conditions that are there, those that are seen
} watch;

static void observe(void *context, const bmr_simulation_event *event) {
    watch *w = context;
    if (event->report.kind == BMR_KDS_START || event->report.kind == BMR_KDS_NONE)
        return;
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    w->events++;
    w->kept += test_waits_for(event->kds, &event->failed);
    w->seen += bmr_kds_conditions(event->kds, conditions) > 0 && test_waits_for(event->kds, &conditions[0]);
}

static void follow(const stall *s) {
    own_stage two = stage_of(ngon(s->ngon, s->n, 2 * s->seed), ngon(s->ngon, s->n, 2 * s->seed + 1),
                             (bmr_family_def){s->family, s->ratio, s->seed, 0, 0});
    watch w = {0, 0, 0};
    bmr_run_def def = {.simulation = bmr_default_simulation_def(), .observer = observe, .context = &w};
    // Far below the separation, or the pair would be in contact.
    def.simulation.kds.margin = fmin(def.simulation.kds.margin, 1e-3 * two.motion.separation);
    const bmr_run run = run_of(&two, test_structure(s->structure), def);
    printf("%s on %s, n %zu: %zu events\n", s->structure, bmr_family_name(s->family), s->n, w.events);
    assert_int_equal(run.counts.external, 0);
    assert_true(w.events > 100 && w.seen == w.events);
    assert_int_equal(w.kept, 0);
}

/// The side is crossed at 1e-4 of the pair's speed, and a little ahead the point is beyond it by less than a
/// rounding.
TEST(sides_that_are_crossed_at_a_small_angle) {
    static const stall stalls[] = {
        {"active-cell-compass", BMR_FAMILY_ORBIT, BMR_NGON_REGULAR, 64, 300000.0, 1},
        {"tiling-dudley", BMR_FAMILY_ORBIT, BMR_NGON_REGULAR, 64, 300000.0, 1}};
    for (size_t i = 0; i < sizeof stalls / sizeof *stalls; i++)
        follow(&stalls[i]);
}

/// All edges of two equal regular polygons become parallel at once, and B turns so slowly that a little later
/// it has turned by less than a rounding: each page is turned once.
TEST(who_turns_slowly_past_parallel_edges_turns_few_pages) {
    static const char *const names[] = {"active-cell-compass", "active-cell-dudley"};
    test_random random = test_random_from(1);
    uint64_t pages = 0;
    for (size_t i = 0; i < 100; i++) {
        const size_t n = 4 + 4 * (i % 4);
        own_kds_body a = test_kds_body_make(ngon(BMR_NGON_REGULAR, n, 1));
        own_kds_body b = test_kds_body_make(ngon(BMR_NGON_REGULAR, n, 1));
        const double way = test_random_uniform(&random, -3.0, 3.0),
                     gap = exp(test_random_uniform(&random, -9.0, 0.0));
        const double spin = exp(test_random_uniform(&random, log(1e-12), log(1e-7)));
        bmr_pose from = test_pose_at(a.polygon, b.polygon, way, -0.5 * spin, gap);
        const bmr_vec2 along = {-sin(way), cos(way)};
        from.position = bmr_sub(from.position, along);
        own_course course =
            course_along(a.polygon, b.polygon, bmr_piece_screw(0.0, from, bmr_scale(2.0, along), spin));
        const bmr_run_def def = {
            test_structure(names[i % 2]), {a.shape, b.shape}, bmr_default_simulation_def(), true, NULL, NULL};
        bmr_run run;
        assert_int_equal(bmr_run_course(&def, &course, 1.0, NULL, &run), BMR_OK);
        assert_int_equal(run.audit, BMR_OK);
        assert_true(run.counts.events[BMR_KDS_PAGE_TURN] <= n);
        pages += run.counts.events[BMR_KDS_PAGE_TURN];
    }
    assert_true(pages > 10);
}

#define MOST_EVENTS 24
/// The way back is slower by this.
#define SLOWER 0x1p-6

typedef struct event_times {
    size_t count;
    double time[MOST_EVENTS];
} event_times;

static void note(void *context, const bmr_simulation_event *event) {
    event_times *times = context;
    const bmr_kds_event_kind kind = event->report.kind;
    const bool failure = kind != BMR_KDS_START && kind != BMR_KDS_LEAVE && kind != BMR_KDS_NONE;
    if (failure && times->count < MOST_EVENTS)
        times->time[times->count++] = event->time;
}

typedef struct scene {
    const bmr_kds_info *info;
    test_kds_body a, b;
    bmr_motion_piece there;
} scene;

static scene make_scene(const bmr_kds_info *info) {
    test_random random = test_random_from(11);
    const bool point = info->domain == BMR_KDS_POINT;
    const double spin = info->domain == BMR_KDS_RIGID ? 5.0 : 0.0;
    const bmr_pose from = {{-3.0, 2.0}, 0.8, 0.6};
    scene s = {.info = info, .there = bmr_piece_screw(0.0, from, bmr_vec2_make(3.0, -1.2), spin)};
    s.a = test_kds_body_make(test_polygon(TEST_CIRCLE, 24, &random));
    s.b = point ? test_kds_point_make(0.0, 0.0) : test_kds_body_make(test_polygon(TEST_ELLIPSE, 12, &random));
    return s;
}

static void destroy_scene(scene *s) {
    test_kds_body_destroy(&s->a);
    test_kds_body_destroy(&s->b);
}

/// Runs to `end`; from `turn` on B goes back.
static bmr_error run(const scene *s, double turn, double end, event_times *times) {
    const bmr_motion_piece rest = bmr_piece_rest(bmr_pose_identity());
    bmr_motion *motions[2];
    assert_int_equal(bmr_motion_create(&rest, NULL, &motions[0]), BMR_OK);
    assert_int_equal(bmr_motion_create(&s->there, NULL, &motions[1]), BMR_OK);
    if (turn < end) {
        bmr_vec2 velocity;
        double spin;
        const bmr_pose pose = bmr_motion_pose(motions[1], turn, &velocity, &spin);
        const bmr_motion_piece back = bmr_piece_screw(
            turn, pose, bmr_vec2_make(-SLOWER * velocity.x, -SLOWER * velocity.y), -SLOWER * spin);
        assert_int_equal(bmr_motion_change(motions[1], turn, &back), BMR_OK);
    }
    bmr_simulation_def def = bmr_default_simulation_def();
    def.structure = s->info;
    const bmr_shape shapes[2] = {s->a.shape, s->b.shape};
    bmr_simulation *simulation;
    assert_int_equal(
        bmr_simulation_create(&def, shapes, motions, 0.0, times ? note : NULL, times, NULL, &simulation),
        BMR_OK);
    bmr_error error = bmr_simulation_run(simulation, end);
    if (error == BMR_OK)
        error = bmr_simulation_audit(simulation);
    bmr_simulation_destroy(simulation);
    bmr_motion_destroy(motions[0]);
    bmr_motion_destroy(motions[1]);
    return error;
}

TEST(every_structure_goes_on_where_the_motion_turns_back_after_a_failure) {
    static const double after[] = {0.0, 1e-12, 2e-12, 4e-12, 8e-12, 16e-12};
    for (size_t k = 0; k < bmr_kds_count(); k++) {
        scene s = make_scene(bmr_kds_at(k));
        event_times times = {0};
        assert_int_equal(run(&s, INFINITY, 1.5, &times), BMR_OK);
        assert_true(times.count > 0);
        for (size_t i = 0; i < times.count; i++)
            for (size_t j = 0; j < sizeof after / sizeof *after; j++) {
                const double turn = times.time[i] + after[j];
                const bmr_error error = run(&s, turn, turn + 0.1, NULL);
                if (error != BMR_OK)
                    fail_msg("%s: event %zu, turned back %g after it: %s", s.info->name, i, after[j],
                             bmr_error_describe(error));
            }
        destroy_scene(&s);
    }
}
