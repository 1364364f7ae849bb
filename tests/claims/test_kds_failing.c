// SPDX-License-Identifier: MIT
// When a condition counts as failed, and the rate that decides it close to zero.
#include "../../core/kds/failing.h"
#include "checks.h"

/// A motion that bends and turns, with its rates.
static bmr_instant instant_at(double time) {
    const double angle = 0.3 + 0.7 * time;
    const bmr_instant now = {
        .pose = {.position = {1.5 + 0.4 * time, -0.5 + 0.9 * time * time}, .c = cos(angle), .s = sin(angle)},
        .velocity = {0.4, 1.8 * time},
        .spin = 0.7};
    return now;
}

TEST(rates_are_derivatives_of_values) {
    const bmr_vec2 normal = {0.6, 0.8}, point = {-0.28, 0.96}, center = {0.2, -0.3};
    const bmr_condition conditions[] = {
        bmr_condition_beyond(0, normal, 0.1, point, 0), bmr_condition_beyond(1, normal, 0.1, point, 0),
        bmr_condition_turn(0, normal, point, 0), bmr_condition_turn(1, normal, point, 0),
        bmr_condition_disks(center, point, 0.5, 0)};
    const double step = 1e-6;
    for (size_t i = 0; i < sizeof conditions / sizeof *conditions; ++i) {
        double most = 0.0;
        for (double time = -2.0; time <= 2.0; time += 0.125) {
            const bmr_instant before = instant_at(time - step), now = instant_at(time),
                              after = instant_at(time + step);
            const double slope = (bmr_condition_value(&conditions[i], &after.pose) -
                                  bmr_condition_value(&conditions[i], &before.pose)) /
                                 (2.0 * step);
            const double rate = bmr_condition_rate(&conditions[i], &now);
            // A central difference is off by step^2 and by an ulp of the values over the step.
            assert_true(fabs(rate - slope) <= 1e-8);
            most = fmax(most, fabs(rate));
        }
        assert_true(most > 0.1); // there is a rate to be wrong about
    }
}

TEST(centers_that_coincide_have_no_rate) {
    bmr_instant now = instant_at(0.0);
    const bmr_condition disks = bmr_condition_disks(now.pose.position, bmr_vec2_make(0.0, 0.0), 0.5, 0);
    assert_true(bmr_condition_rate(&disks, &now) == 0.0);
}

TEST(close_to_zero_the_rate_decides) {
    const double tolerance = 1e-10;
    bmr_instant now = instant_at(0.0);
    const double far = hypot(now.pose.position.x, now.pose.position.y);
    for (int sign = -1; sign <= 1; sign += 2) {
        now.velocity = bmr_scale(sign, now.pose.position); // away from the origin, or towards it
        const struct {
            double above;
            bool fails;
        } cases[] = {{1e-9, false}, {5e-11, sign < 0}, {-5e-11, true}, {-1e-9, true}, {NAN, true}};
        for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
            const bmr_condition disks = bmr_condition_disks(bmr_vec2_make(0.0, 0.0), bmr_vec2_make(0.0, 0.0),
                                                            far - cases[i].above, 0);
            assert_int_equal(bmr_condition_fails(&disks, &now, tolerance), cases[i].fails);
        }
    }
}
