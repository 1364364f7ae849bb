// SPDX-License-Identifier: MIT
// Every registered structure on points, segments, boxes and needles that lie parallel: edges without an
// inside and cones of half a turn, or nearly, are where conditions that overlap elsewhere may not.
#include <math.h>

#include "checks.h"

#include "boomerang/simulation.h"
#include "kds_driver.h"

enum { POINT, SEGMENT, BOX, NEEDLE, RHOMB, SHAPES };

/// The needle is as thick as the rounding of its length, the rhomb as the overlap of two cones.
#define NEEDLE_HEIGHT 1e-15
#define RHOMB_HEIGHT 1e-13

/// Twice the most measured: 4 of those that do not turn, 12 of those that do. The stalls to be caught have
/// 1001.
#define MOST_EVENTS 24

static test_kds_body body_of(int shape) {
    static const bmr_vec2 points[SHAPES][4] = {
        {{0.0, 0.0}},
        {{-1.0, 0.0}, {1.0, 0.0}},
        {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}},
        {{-1.0, 0.0}, {1.0, 0.0}, {1.0, NEEDLE_HEIGHT}},
        {{-1.0, 0.0}, {0.0, -RHOMB_HEIGHT}, {1.0, 0.0}, {0.0, RHOMB_HEIGHT}}};
    static const size_t counts[SHAPES] = {1, 2, 4, 3, 4};
    bmr_polygon *polygon = NULL;
    assert_int_equal(bmr_polygon_create(points[shape], counts[shape], NULL, &polygon), BMR_OK);
    return test_kds_body_make(polygon);
}

static double height_of(int shape) {
    return shape == BOX ? 1.0 : 0.0;
}

typedef struct pair {
    const bmr_kds_info *info;
    test_kds_body body[2];
    double touching; ///< the height of B at which it lies on A
} pair;

typedef void (*pair_check)(const pair *p);

/// Every structure on every pair of shapes that it takes.
static void for_each_pair(pair_check check) {
    for (int a = 0; a < SHAPES; a++)
        for (int b = 0; b < SHAPES; b++) {
            pair p = {NULL, {body_of(a), body_of(b)}, height_of(a) + height_of(b)};
            for (size_t k = 0; k < bmr_kds_count(); k++) {
                p.info = bmr_kds_at(k);
                if (p.info->domain != BMR_KDS_POINT || b == POINT)
                    check(&p);
            }
            for (int side = 0; side < 2; side++)
                test_kds_body_destroy(&p.body[side]);
        }
}

/// Starts of both kinds of pose: beside one another (their ends in line) and above one another.
static void check_starts(const pair *p) {
    static const bmr_vec2 beside[] = {{4.0, 0.0}, {-4.0, 0.0}};
    static const double gaps[] = {1.0, 1e-3}, shifts[] = {0.0, 0.5, 1.0, -2.0};
    enum { BESIDE = sizeof beside / sizeof *beside, SHIFTS = sizeof shifts / sizeof *shifts };
    const bmr_kds_def def = bmr_default_kds_def();
    bmr_kds *kds = NULL;
    assert_int_equal(bmr_kds_create(p->info, &def, &p->body[0].shape, &p->body[1].shape, NULL, &kds), BMR_OK);
    for (int i = 0; i < BESIDE + 4 * SHIFTS; i++) {
        const int k = i - BESIDE, upside = k % 2 == 0 ? 1 : -1;
        bmr_instant now = {bmr_pose_identity(), {0.0, 0.0}, 0.0};
        now.pose.position =
            k < 0 ? beside[i] : bmr_vec2_make(shifts[k / 4], upside * (p->touching + gaps[k / 2 % 2]));
        bmr_kds_report report;
        bmr_kds_start(kds, &now, &report);
        assert_true(report.apart);
        assert_int_equal(bmr_kds_audit(kds, &now.pose), BMR_OK);
        bmr_condition c[BMR_KDS_MAX_CONDITIONS];
        const size_t count = bmr_kds_conditions(kds, c);
        assert_true(count > 0);
        for (size_t n = 0; n < count; n++)
            assert_true(bmr_condition_value(&c[n], &now.pose) > 0.0);
        // The control: what was proved there is not true where they lie on one another.
        now.pose.position = bmr_vec2_make(0.0, 0.0);
        assert_int_not_equal(bmr_kds_audit(kds, &now.pose), BMR_OK);
    }
    bmr_kds_destroy(kds, NULL);
}

TEST(starts_on_parallel_edges_hold) {
    for_each_pair(check_starts);
}

/// B's motion for 8 units of time, looked at so many times.
static void run(const pair *p, bmr_motion_piece piece, uint64_t contacts) {
    const double until = 8.0;
    const int looks = 20;
    const bmr_motion_piece rest = bmr_piece_rest(bmr_pose_identity());
    bmr_motion *motions[2] = {NULL, NULL};
    assert_int_equal(bmr_motion_create(&rest, NULL, &motions[0]), BMR_OK);
    assert_int_equal(bmr_motion_create(&piece, NULL, &motions[1]), BMR_OK);
    const bmr_shape shapes[2] = {p->body[0].shape, p->body[1].shape};
    bmr_simulation_def def = bmr_default_simulation_def();
    def.structure = p->info;
    bmr_simulation *simulation = NULL;
    assert_int_equal(bmr_simulation_create(&def, shapes, motions, 2, 0.0, NULL, NULL, NULL, &simulation),
                     BMR_OK);
    for (int i = 1; i <= looks; i++) {
        assert_int_equal(bmr_simulation_run(simulation, until * i / looks), BMR_OK);
        assert_int_equal(bmr_simulation_audit(simulation), BMR_OK);
    }
    const bmr_simulation_counts counts = bmr_simulation_get_counts(simulation);
    uint64_t events = 0;
    for (int k = 0; k < BMR_KDS_EVENT_KIND_COUNT; k++)
        events += counts.events[k];
    assert_true(events >= 1 && events <= MOST_EVENTS);
    assert_int_equal(counts.external, contacts);
    bmr_simulation_destroy(simulation);
    for (int side = 0; side < 2; side++)
        bmr_motion_destroy(motions[side]);
}

static bmr_motion_piece moving(double x, double y, double velocity_x, double velocity_y, double spin) {
    bmr_pose pose = bmr_pose_identity();
    pose.position = bmr_vec2_make(x, y);
    return bmr_piece_screw(0.0, pose, bmr_vec2_make(velocity_x, velocity_y), spin);
}

static void check_runs(const pair *p) {
    static const double gaps[] = {1.0, 1e-3};
    for (int i = 0; i < 2; i++) {
        const double y = p->touching + gaps[i];
        run(p, moving(0.0, y, 0.0, 0.0, 0.0), 0);  // at rest
        run(p, moving(0.5, -y, 0.0, 0.0, 0.0), 0); // below
        run(p, moving(-4.0, y, 1.0, 0.0, 0.0), 0); // sliding past
        run(p, moving(4.0, -y, -1.0, 0.0, 0.0), 0);
        if (p->info->domain == BMR_KDS_RIGID)
            run(p, moving(0.0, y + 1.0, 0.0, 0.0, 1.0), 0); // through all directions
    }
    // The control: one that comes down to lie on the other touches.
    run(p, moving(0.0, p->touching + 1.0, 0.0, -0.125, 0.0), 1);
}

/// So slowly that a condition that is a little below zero where the turn begins stays so for long.
static void check_slow_turns(const pair *p) {
    static const double spins[] = {1e-3, 1e-9, 1e-12};
    if (p->info->domain != BMR_KDS_RIGID)
        return;
    for (int i = 0; i < 6; i++) {
        const double spin = i % 2 == 0 ? spins[i / 2] : -spins[i / 2], y = p->touching + 1.0;
        run(p, moving(0.0, y, 0.0, 0.0, spin), 0);
        run(p, moving(0.5, -y, 0.0, 0.0, spin), 0);
        run(p, moving(-4.0, y, 1.0, 0.0, spin), 0);
    }
}

TEST(slow_turns_go_on_without_a_stall) {
    for_each_pair(check_slow_turns);
}

TEST(rest_slides_and_turns_go_on_without_a_stall) {
    for_each_pair(check_runs);
}
