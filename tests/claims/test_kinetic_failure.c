// SPDX-License-Identifier: MIT
// First failure times of the highest degree against long double: dense looks, minima between them sought out.
// Never late, at most the tolerance early. (On motions of every kind: random/fuzz_events.c.)
#include "boomerang/failure.h"
#include "checks.h"
#include "failure_oracle.h"
#include "motion_pieces.h"
#include "polygons.h"
#include "test_scale.h"

#define PI 3.14159265358979323846
#define END 4.0

static double in(test_random *random, double low, double high) {
    return test_random_uniform(random, low, high);
}

static bmr_vec2 random_direction(test_random *random) {
    const double angle = in(random, -PI, PI);
    return bmr_vec2_make(cos(angle), sin(angle));
}

/// Of degree 8 in everything.
static bmr_motion_piece random_piece(test_random *random) {
    bmr_algebraic_piece w = {.degree = BMR_MOTION_MAX_DEGREE, .rotation_degree = BMR_MOTION_MAX_DEGREE};
    double scale = 1.0;
    for (size_t k = 0; k <= BMR_MOTION_MAX_DEGREE; k++) {
        const double place = 3.0 * pow(3.0, -(double)k);
        w.x[k] = in(random, -place, place);
        w.y[k] = in(random, -place, place);
        w.a[k] = in(random, -scale, scale);
        w.b[k] = in(random, -scale, scale);
        scale /= 2.0;
    }
    bmr_motion_piece piece = test_algebraic(in(random, 0.0, END), w);
    const bmr_vec2 start = random_direction(random);
    piece.as.algebraic.start_c = start.x;
    piece.as.algebraic.start_s = start.y;
    return piece;
}

static bmr_condition random_condition(test_random *random, int kind) {
    const bmr_vec2 normal = random_direction(random), other = random_direction(random),
                   point = {in(random, -2.0, 2.0), in(random, -2.0, 2.0)};
    const int owner = (int)test_random_below(random, 2);
    if (kind == BMR_CONDITION_TURN)
        return bmr_condition_turn(owner, normal, other, 0);
    if (kind == BMR_CONDITION_DISKS)
        return bmr_condition_disks(bmr_scale(3.0, other), point, in(random, 0.0, 4.0), 0);
    return bmr_condition_beyond(owner, normal, in(random, -3.0, 3.0), point, 0);
}

/// Conditions of degree 24 to 48, by both ways to find their roots.
/// Section 2, failure times: when a certificate fails is a root of a polynomial.
TEST(the_highest_degrees_are_judged_too) {
    test_random random = {88};
    const size_t rounds = test_scaled(150);
    size_t failing = 0;
    for (size_t round = 0; round < rounds; round++)
        for (int k = 0; k < BMR_CONDITION_KIND_COUNT; k++) {
            const bmr_motion_piece of_a = random_piece(&random), of_b = random_piece(&random);
            own_motion *a = made_motion(of_a), *b = made_motion(of_b);
            oracle_trial trial = {.condition = random_condition(&random, k)};
            oracle_read_plan(a, &trial.a);
            oracle_read_plan(b, &trial.b);
            long double size;
            if (!(oracle_value(&trial, 0.0L, &size) > 1e-6L * size))
                continue;
            for (int method = 0; method <= BMR_ROOT_GSL; method++) {
                bmr_failure_options options = bmr_default_failure_options();
                options.method = (bmr_root_method)method;
                options.tolerance = 1e-12;
                double time = -1.0;
                assert_int_equal(bmr_failure_time(&trial.condition, a, b, 0.0, END, &options, &time), BMR_OK);
                const oracle_verdict v = oracle_judge(&trial, 0.0, END, time, 1e-11, ORACLE_LOOKS);
                if (time < 0.0 || v.late || v.early)
                    fail_msg("round %zu, method %d, condition %d: time %.17g, late %d, early %d, worst %Lg",
                             round, method, k, time, v.late, v.early, v.worst);
                failing += !isinf(time);
            }
        }
    assert_true(failing > rounds / 2);
}
