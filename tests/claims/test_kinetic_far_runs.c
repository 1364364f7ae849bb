// SPDX-License-Identifier: MIT
// Searches that would take more steps than anybody waits for end with an error, and a pair at rest takes
// none. (Without their bounds each of these calls runs for minutes or for ever.)
#include "boomerang/failure.h"
#include "boomerang/simulation.h"
#include "checks.h"
#include "kds_driver.h"
#include "motions.h"

static bmr_motion_piece screw(double origin, double x, double velocity_y, double spin) {
    bmr_pose pose = bmr_pose_identity();
    pose.position.x = x;
    return bmr_piece_screw(origin, pose, bmr_vec2_make(0.0, velocity_y), spin);
}

// ---- failure times ----

static bmr_error failure_of(double spin, double until, double *time) {
    own_motion *still = made_motion(bmr_piece_rest(bmr_pose_identity())),
               *spinning = made_motion(screw(0.0, 3.0, 0.0, spin));
    // A corner that is never nearer than two.
    const bmr_condition k = bmr_condition_beyond(0, bmr_vec2_make(1.0, 0.0), 0.0, bmr_vec2_make(0.0, 1.0), 0);
    const bmr_failure_options options = bmr_default_failure_options();
    const bmr_error error = bmr_failure_time(&k, still, spinning, 0.0, until, &options, time);
    return error;
}

TEST(too_many_turns_are_refused) {
    const double cases[][2] = {{1.0, 1e9}, {1e9, 1.0}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        double time = -1.0;
        assert_int_equal(failure_of(cases[i][0], cases[i][1], &time), BMR_ERROR_OUT_OF_RANGE);
        assert_true(time == -1.0);
    }
    // So fast that the rounding of the time hides all turns, or that the bounds overflow: any answer will do.
    for (double spin = 1e12; spin < 1e301; spin *= 1e36) {
        double time = -1.0;
        const bmr_error error = failure_of(spin, 1.0, &time);
        assert_true(error == BMR_OK || error == BMR_ERROR_OUT_OF_RANGE || error == BMR_ERROR_NOT_FINITE);
        assert_true((time == -1.0) == (error != BMR_OK));
    }
    // The control: a thousand turns are followed.
    double time = -1.0;
    assert_int_equal(failure_of(1.0, 6283.0, &time), BMR_OK);
    assert_true(time == INFINITY);
}

// ---- contacts ----

typedef struct contact_case {
    double start, until, contact_step, velocity;
    bmr_error error;
} contact_case;

static void check_contact(const contact_case *c) {
    static const bmr_vec2 box[] = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};
    test_kds_body body[2];
    bmr_shape shapes[2];
    for (int side = 0; side < 2; side++) {
        bmr_polygon *polygon = made_polygon(box, 4);
        body[side] = test_kds_body_make(polygon);
        shapes[side] = body[side].shape;
    }
    // They move as one.
    bmr_motion *motions[2] = {made_motion(screw(c->start, 0.0, c->velocity, 0.0)),
                              made_motion(screw(c->start, 1.5, c->velocity, 0.0))};
    bmr_simulation_def def = bmr_default_simulation_def();
    def.structure = bmr_kds_at(0);
    for (size_t k = 0; def.structure->domain == BMR_KDS_POINT; k++)
        def.structure = bmr_kds_at(k);
    def.contact_step = c->contact_step;
    bmr_simulation *simulation = NULL;
    assert_int_equal(bmr_simulation_create(&def, shapes, motions, c->start, NULL, NULL, NULL, &simulation),
                     BMR_OK);
    assert_int_equal(bmr_simulation_run(simulation, c->until), c->error);
    if (c->error == BMR_OK && c->velocity == 0.0) {
        // The control: a change of plan ends the rest, and is seen.
        const bmr_motion_piece away = screw(c->until, 4.0, 0.0, 0.0);
        assert_int_equal(bmr_motion_change(motions[1], c->until, &away), BMR_OK);
        assert_int_equal(bmr_simulation_replan(simulation), BMR_OK);
        assert_false(bmr_kds_in_contact(bmr_simulation_kds(simulation)));
    }
    bmr_simulation_destroy(simulation);
    for (int side = 0; side < 2; side++) {
        bmr_motion_destroy(motions[side]);
        test_kds_body_destroy(&body[side]);
    }
}

TEST(a_contact_at_rest_takes_no_steps) {
    const contact_case cases[] = {
        {0.0, 1e9, 0.1, 0.0, BMR_OK}, {1e16, 2e16, 0.1, 0.0, BMR_OK}, {0.0, 1.0, 1e-300, 0.0, BMR_OK}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        check_contact(&cases[i]);
}

TEST(too_many_samples_of_a_contact_are_refused) {
    const contact_case cases[] = {{1e16, 2e16, 0.1, 1e-16, BMR_ERROR_OUT_OF_RANGE},
                                  {0.0, 1.0, 1e-300, 1.0, BMR_ERROR_OUT_OF_RANGE},
                                  {0.0, 100.0, 0.1, 1.0, BMR_OK}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        check_contact(&cases[i]);
}
