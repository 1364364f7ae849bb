// SPDX-License-Identifier: MIT
// Two moving polygons: events in time order, valid at every event and between them, contacts where an
// independent distance says so, changes of plan that cost each condition once. With every structure:
// tests/random/fuzz_structures.cpp.
#include "boomerang/simulation.h"
#include "checks.h"
#include "failing_allocator.h"
#include "kds/structure.h"
#include "kds_driver.h"
#include "motions.h"

#define PI 3.14159265358979323846

// ---- scenes ----

typedef struct scene {
    test_kds_body bodies[2];
    bmr_shape shapes[2];
    bmr_motion *motions[2];
} scene;

static double uniform(test_random *random, double low, double high) {
    return test_random_uniform(random, low, high);
}

static bmr_pose pose_of(double x, double y, double angle) {
    const bmr_pose pose = {{x, y}, cos(angle), sin(angle)};
    return pose;
}

/// A body that begins somewhere on the table and stays near it for some units of time.
static bmr_motion_piece random_plan(test_random *random, double table, double origin, bmr_pose pose) {
    const bmr_vec2 velocity = {uniform(random, -0.4, 0.4) * table, uniform(random, -0.4, 0.4) * table};
    if (test_random_below(random, 2))
        return bmr_piece_screw(origin, pose, velocity,
                               test_random_below(random, 3) ? uniform(random, -3.0, 3.0) : 0.0);
    bmr_algebraic_piece w = {.degree = 3, .x = {0.0, velocity.x}, .y = {0.0, velocity.y}};
    for (size_t k = 2; k <= w.degree; k++) {
        w.x[k] = uniform(random, -0.1, 0.1) * table;
        w.y[k] = uniform(random, -0.1, 0.1) * table;
    }
    w.rotation_degree = test_random_below(random, 2);
    w.b[1] = uniform(random, -1.0, 1.0);
    bmr_motion_piece piece = test_algebraic(origin, w);
    test_piece_begin(&piece, origin, pose);
    return piece;
}

static bmr_pose random_place(test_random *random, double table) {
    return pose_of(uniform(random, -table, table), uniform(random, -table, table), uniform(random, -PI, PI));
}

static scene make_scene(test_random *random, size_t vertices) {
    scene s;
    const double table = 3.0;
    for (size_t i = 0; i < 2; i++) {
        s.bodies[i] = test_kds_body_make(test_polygon(
            i % 2 ? TEST_ELLIPSE : TEST_REGULAR, 3 + test_random_below(random, (uint32_t)vertices), random));
        s.shapes[i] = s.bodies[i].shape;
        const bmr_motion_piece piece = random_plan(random, table, 0.0, random_place(random, table));
        assert_int_equal(bmr_motion_create(&piece, NULL, &s.motions[i]), BMR_OK);
    }
    return s;
}

static void drop_scene(scene *s) {
    for (size_t i = 0; i < 2; i++) {
        bmr_motion_destroy(s->motions[i]);
        test_kds_body_destroy(&s->bodies[i]);
    }
}
#define own_scene OWNED(drop_scene)

static double distance_at(const scene *s, double time) {
    const bmr_pose p = bmr_motion_pose(s->motions[0], time, NULL, NULL);
    const bmr_pose q = bmr_motion_pose(s->motions[1], time, NULL, NULL);
    const bmr_pose relative = bmr_pose_relative(&p, &q);
    return test_distance(s->bodies[0].polygon, s->bodies[1].polygon, &relative);
}

// ---- what the observer checks ----

typedef struct watch {
    const scene *scene;
    double margin, last;
    bool contact;
    size_t events, failed_audits, out_of_order;
    double worst_contact; ///< distance at contact and leaving, less the margin
} watch;

static void observe(void *context, const bmr_simulation_event *event) {
    watch *w = context;
    w->events++;
    w->out_of_order += event->time < w->last;
    w->last = event->time;
    w->failed_audits += bmr_kds_audit(event->kds, &event->pose) != BMR_OK;
    const bool contact = bmr_kds_in_contact(event->kds);
    if (event->report.kind == BMR_KDS_CONTACT || event->report.kind == BMR_KDS_LEAVE) {
        const double off = fabs(distance_at(w->scene, event->time) - w->margin);
        if (event->time > 0.0)
            w->worst_contact = fmax(w->worst_contact, off);
    }
    assert_true(event->report.kind != BMR_KDS_LEAVE || w->contact);
    w->contact = contact;
}

static bmr_simulation *begin(const scene *s, const bmr_kds_info *structure, watch *w,
                             const bmr_allocator *allocator) {
    bmr_simulation_def def = bmr_default_simulation_def();
    def.structure = structure;
    memset(w, 0, sizeof *w);
    w->scene = s;
    w->margin = def.kds.margin;
    w->last = -INFINITY;
    bmr_simulation *simulation = NULL;
    assert_int_equal(
        bmr_simulation_create(&def, s->shapes, s->motions, 0.0, observe, w, allocator, &simulation), BMR_OK);
    return simulation;
}

/// Between events: what the simulation says of contact is what the distance says, and the proof holds.
static void check_between(const scene *s, const bmr_simulation *simulation) {
    assert_int_equal(bmr_simulation_audit(simulation), BMR_OK);
    const double distance = distance_at(s, bmr_simulation_time(simulation)),
                 margin = bmr_default_kds_def().margin;
    // The two may differ only where the distance is the margin, up to 1e-8.
    if (fabs(distance - margin) > 1e-8)
        assert_int_equal(bmr_kds_in_contact(bmr_simulation_kds(simulation)), distance < margin);
}

/// Some that can do anything.
static const bmr_kds_info *some_structure(size_t index) {
    static const char *const names[] = {"free-fd2", "lazy-dudley", "inflated-window"};
    const bmr_kds_info *info = test_structure(names[index % (sizeof names / sizeof *names)]);
    assert_non_null(info);
    return info;
}

TEST(a_new_plan_costs_each_condition_once) {
    test_random random = test_random_from(99);
    size_t events = 0, contacts = 0;
    for (int pair = 0; pair < 45; pair++) {
        own_scene scene s = make_scene(&random, 20);
        watch w;
        bmr_simulation *simulation = begin(&s, some_structure(0), &w, NULL);
        for (int change = 1; change <= 40; change++) {
            const double now = 0.1 * change;
            assert_int_equal(bmr_simulation_run(simulation, now), BMR_OK);
            const size_t body = test_random_below(&random, 2);
            const bmr_pose pose = bmr_motion_pose(s.motions[body], now, NULL, NULL);
            const bmr_motion_piece piece = random_plan(&random, 4.0, now, pose);
            assert_int_equal(bmr_motion_change(s.motions[body], now, &piece), BMR_OK);
            const bmr_simulation_counts before = bmr_simulation_get_counts(simulation);
            const size_t conditions = w.contact ? 0 : before.conditions;
            const size_t seen = w.events;
            assert_int_equal(bmr_simulation_replan(simulation), BMR_OK);
            const bmr_simulation_counts after = bmr_simulation_get_counts(simulation);
            assert_int_equal(after.failure_times - before.failure_times, conditions);
            assert_int_equal(after.replanned - before.replanned, conditions);
            assert_int_equal(w.events, seen); // a new plan is no event
            check_between(&s, simulation);
            contacts += w.contact;
        }
        assert_int_equal(w.out_of_order, 0);
        events += w.events;
        bmr_simulation_destroy(simulation);
    }
    assert_true(events > 100 && contacts > 100); // (compilers draw in other orders: other scenes)
}

/// One runs into the other. In every second round it jumps away before the structure can be repaired.
TEST(a_jump_just_behind_a_failure_comes_first) {
    test_random random = test_random_from(1);
    own_scene scene s = make_scene(&random, 5);
    const bmr_motion_piece rests = bmr_piece_rest(pose_of(0.0, 0.0, 0.0)),
                           away = bmr_piece_rest(pose_of(-50.0, 0.0, 0.0));
    assert_int_equal(bmr_motion_change(s.motions[1], 0.0, &rests), BMR_OK);
    for (int round = 0; round < 12; round++) {
        const bmr_motion_piece comes =
            bmr_piece_screw(0.0, pose_of(-9.0, 0.0, 0.3), bmr_vec2_make(9.0 + round, 0.0), 0.0);
        if (round % 2 == 0)
            assert_int_equal(bmr_motion_change(s.motions[0], 0.0, &comes), BMR_OK);
        watch w;
        bmr_simulation *simulation = begin(&s, some_structure(0), &w, NULL);
        for (int i = 1; i < 100 && !w.contact; i++)
            assert_int_equal(bmr_simulation_run(simulation, 0.01 * i), BMR_OK);
        assert_true(w.contact == (round % 2 == 0));
        assert_int_equal(bmr_motion_change(s.motions[0], nextafter(w.last, INFINITY), &away), BMR_OK);
        bmr_simulation_destroy(simulation);
    }
}

/// One comes straight at the other, which rests.
static scene make_collision(test_random *random) {
    scene s = make_scene(random, 5);
    const bmr_motion_piece rests = bmr_piece_rest(pose_of(0.0, 0.0, 0.0)),
                           comes =
                               bmr_piece_screw(0.0, pose_of(-9.0, 0.0, 0.3), bmr_vec2_make(9.0, 0.0), 0.0);
    assert_int_equal(bmr_motion_change(s.motions[0], 0.0, &comes), BMR_OK);
    assert_int_equal(bmr_motion_change(s.motions[1], 0.0, &rests), BMR_OK);
    return s;
}

TEST(a_run_that_fails_repeats_no_event) {
    test_random random = test_random_from(3);
    own_scene scene s = make_collision(&random);
    bmr_simulation_def def = bmr_default_simulation_def();
    def.structure = some_structure(0);
    def.contact_step = 1e-300; // too many samples of a contact
    watch w = {.scene = &s, .margin = def.kds.margin, .last = -INFINITY};
    bmr_simulation *simulation = NULL;
    assert_int_equal(bmr_simulation_create(&def, s.shapes, s.motions, 0.0, observe, &w, NULL, &simulation),
                     BMR_OK);
    assert_int_equal(bmr_simulation_run(simulation, 9.0), BMR_ERROR_OUT_OF_RANGE);
    assert_true(w.contact);
    const size_t events = w.events;
    const double time = bmr_simulation_time(simulation);
    assert_int_equal(bmr_simulation_run(simulation, time), BMR_OK); // nothing is left to do until then
    assert_int_equal(w.events, events);
    bmr_simulation_destroy(simulation);
}

/// An observer that takes B away as soon as there is an event of this kind.
typedef struct meddler {
    const scene *scene;
    bmr_simulation *simulation;
    bmr_kds_event_kind kind;
    size_t events, of_kind;
} meddler;

static void meddle(void *context, const bmr_simulation_event *event) {
    meddler *m = context;
    m->events++;
    m->of_kind += event->report.kind == m->kind;
    if (!m->simulation)
        return; // the first start
    assert_int_equal(bmr_simulation_run(m->simulation, 9.0), BMR_ERROR_OUT_OF_RANGE);
    bmr_simulation_destroy(m->simulation);
    if (event->report.kind == m->kind) {
        const bmr_motion_piece away = bmr_piece_rest(pose_of(0.0, 50.0 + (double)m->events, 0.0));
        assert_int_equal(bmr_motion_change(m->scene->motions[1], event->time, &away), BMR_OK);
        assert_int_equal(bmr_simulation_replan(m->simulation), BMR_OK);
    }
}

TEST(an_observer_may_change_a_plan_and_neither_run_nor_destroy) {
    const bmr_kds_event_kind kinds[] = {BMR_KDS_CONTACT, BMR_KDS_LEAVE};
    for (int i = 0; i < 2; i++) {
        test_random random = test_random_from(3);
        own_scene scene s = make_collision(&random);
        bmr_simulation_def def = bmr_default_simulation_def();
        def.structure = some_structure(0);
        meddler m = {.scene = &s, .kind = kinds[i]};
        bmr_simulation *simulation = NULL;
        assert_int_equal(bmr_simulation_create(&def, s.shapes, s.motions, 0.0, meddle, &m, NULL, &simulation),
                         BMR_OK);
        m.simulation = simulation;
        assert_int_equal(bmr_simulation_run(simulation, 9.0), BMR_OK);
        assert_int_equal(m.of_kind, 1);
        assert_int_equal(bmr_simulation_get_counts(simulation).events[BMR_KDS_LEAVE], 1);
        assert_false(bmr_kds_in_contact(bmr_simulation_kds(simulation)));
        assert_int_equal(bmr_simulation_audit(simulation), BMR_OK);
        // Who takes B elsewhere at each start has the simulation stall.
        m.kind = BMR_KDS_START;
        const bmr_motion_piece away = bmr_piece_rest(pose_of(-50.0, 0.0, 0.0));
        assert_int_equal(bmr_motion_change(s.motions[1], 9.0, &away), BMR_OK);
        assert_int_equal(bmr_simulation_replan(simulation), BMR_ERROR_STALLED);
        assert_true(m.of_kind >= BMR_SIMULATION_BURST);
        // It stands there: where B is now the structure knows nothing of.
        assert_int_equal(bmr_simulation_run(simulation, 20.0), BMR_ERROR_STALLED);
        assert_true(bmr_simulation_time(simulation) == 9.0);
        bmr_simulation_destroy(simulation);
    }
}

TEST(pairs_run_long_and_take_no_memory) {
    test_random random = test_random_from(2);
    size_t events = 0;
    for (int pair = 0; pair < 190; pair++) {
        own_scene scene s = make_scene(&random, 60);
        test_heap heap;
        test_heap_init(&heap, SIZE_MAX);
        watch w;
        bmr_simulation *simulation = begin(&s, some_structure((size_t)pair), &w, &heap.allocator);
        const size_t asked = heap.asked;
        assert_int_equal(asked, 2);
        assert_int_equal(bmr_simulation_run(simulation, 3.0 * (double)test_scaled(1)), BMR_OK);
        assert_int_equal(heap.asked, asked);
        assert_true(bmr_simulation_get_counts(simulation).bytes < heap.bytes);
        assert_int_equal(w.out_of_order, 0);
        assert_int_equal(w.failed_audits, 0);
        assert_true(w.worst_contact < 1e-8);
        assert_int_equal(bmr_simulation_audit(simulation), BMR_OK);
        events += w.events;
        bmr_simulation_destroy(simulation);
        assert_int_equal(heap.blocks, 0);
        assert_int_equal(heap.wrong_sizes, 0);
    }
    assert_true(events > 400);
}

// ---- controls: a structure that is wrong ----

/// Claims for ever that the line x = 1 of A separates, and waits for a condition of one point: B's origin.
typedef struct liar {
    double offset;
} liar;
static const double *lie_of(const bmr_kds *kds) {
    return &((const liar *)(const void *)kds->state)->offset;
}
static bool lie_start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    (void)now, (void)report;
    ((liar *)(void *)kds->state)->offset = 1.0;
    return true;
}
static size_t lie_conditions(const bmr_kds *kds, bmr_condition *conditions) {
    conditions[0] =
        bmr_condition_beyond(0, bmr_vec2_make(1.0, 0.0), *lie_of(kds), bmr_vec2_make(0.0, 0.0), 0);
    return 1;
}
static bool lie_repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    (void)kds, (void)now, (void)failed;
    report->kind = BMR_KDS_PUSH; // nothing is repaired
    return true;
}
static void lie_proof(const bmr_kds *kds, bmr_kds_proof *proof) {
    memset(proof, 0, sizeof *proof);
    proof->line.normal = bmr_vec2_make(1.0, 0.0);
    proof->line.offset = *lie_of(kds);
}

TEST(what_is_wrong_is_seen_and_ends) {
    static const bmr_kds_class lies = {sizeof(liar),   NULL,       NULL,      lie_start,
                                       lie_conditions, lie_repair, lie_proof, NULL};
    const bmr_kds_info info = {"liar", "", "", BMR_KDS_RIGID, false, -1, &lies};
    test_random random = test_random_from(8);
    own_scene scene s = make_scene(&random, 10);
    for (size_t i = 0; i < 2; i++) {
        bmr_motion_destroy(s.motions[i]);
        const bmr_motion_piece piece = bmr_piece_screw(0.0, pose_of(4.0 * (double)i, 0.0, 0.0),
                                                       bmr_vec2_make(-1.0 * (double)i, 0.0), 0.0);
        assert_int_equal(bmr_motion_create(&piece, NULL, &s.motions[i]), BMR_OK);
    }
    bmr_simulation_def def = bmr_default_simulation_def();
    def.structure = &info;
    watch w;
    memset(&w, 0, sizeof w);
    w.scene = &s;
    bmr_simulation *simulation = NULL;
    assert_int_equal(bmr_simulation_create(&def, NULL, s.motions, 0.0, observe, &w, NULL, &simulation),
                     BMR_ERROR_NULL_ARGUMENT);
    assert_int_equal(bmr_simulation_create(&def, s.shapes, s.motions, 0.0, observe, &w, NULL, &simulation),
                     BMR_OK);
    // B's vertices pass the line before its origin does.
    assert_int_equal(bmr_simulation_run(simulation, 2.9), BMR_OK);
    assert_int_equal(bmr_simulation_audit(simulation), BMR_ERROR_FALSE_CERTIFICATE);
    // At 3 the condition fails, and goes on failing: the guard ends it.
    assert_int_equal(bmr_simulation_run(simulation, 9.0), BMR_ERROR_STALLED);
    assert_true(fabs(bmr_simulation_time(simulation) - 3.0) < 1e-8);
    assert_true(w.events > BMR_SIMULATION_BURST && w.failed_audits >= BMR_SIMULATION_BURST);
    bmr_simulation_destroy(simulation);
}
