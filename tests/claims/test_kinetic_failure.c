// SPDX-License-Identifier: MIT
// Failure times whose answers are known by thought: roots at the beginning, touches, jumps, bad arguments.
// (On motions of every kind, up to the highest degree: random/fuzz_events.c.)
#include "boomerang/failure.h"
#include "checks.h"
#include "kinetic/failure.h"
#include "motions.h"
#include "polygons.h"

#define AFTER 3.0

static bmr_motion *still, *moving;

static void drop(void) {
    bmr_motion_destroy(still);
    bmr_motion_destroy(moving);
    still = moving = NULL;
}

static double failure_of(const bmr_condition *k, double after, double until) {
    const bmr_failure_options options = bmr_default_failure_options();
    double time = -1.0;
    assert_int_equal(bmr_failure_time(k, still, moving, after, until, &options, &time), BMR_OK);
    return time;
}

/// When x(t) = sum c[k] (t - AFTER)^k first fails, looked for from AFTER on.
static double failure_of_polynomial(const double *c, size_t degree, double until) {
    bmr_algebraic_piece path = {.degree = degree};
    memcpy(path.x, c, (degree + 1) * sizeof *c);
    still = made_motion(bmr_piece_rest(bmr_pose_identity()));
    moving = made_motion(test_algebraic(AFTER, path));
    const bmr_condition k = bmr_condition_beyond(0, bmr_vec2_make(1.0, 0.0), 0.0, bmr_vec2_make(0.0, 0.0), 0);
    const double time = failure_of(&k, AFTER, until);
    drop();
    return time;
}

typedef struct start_case {
    double c[5];
    double time; ///< after AFTER
} start_case;

TEST(what_is_zero_at_the_beginning_is_judged_by_where_it_goes) {
    const double never = (double)INFINITY;
    const start_case cases[] = {
        {{0.0, 1.0}, never},               // grows
        {{0.0, -1.0}, 0.0},                // falls
        {{0.0, 0.0, 1.0}, never},          // touches
        {{0.0, 0.0, -1.0}, 0.0},           //
        {{0.0, 0.0, 0.0, 1.0}, never},     // flat, then grows
        {{0.0, 0.0, 0.0, -1.0}, 0.0},      //
        {{0.0, 1.0, -1.0}, 1.0},           // grows and comes back
        {{0.0, 0.0, 1.0, -1.0}, 1.0},      //
        {{0.0, 0.0, 0.0, 2.0, -1.0}, 2.0}, //
        {{0.0}, 0.0},                      // zero for ever
        {{1.0}, never},                    //
        {{-1.0}, 0.0},                     // long past
        {{-1.0, 1.0}, 0.0},                // long past, and growing
        {{-1e-13, 1.0}, never},            // an event was early by a tenth of the tolerance
        {{-1e-13, 1.0, -1.0}, 1.0},        //
        {{-1e-13, -1.0}, 0.0},             //
        {{1e-300, 1.0}, never},            //
        {{1e-300, -1.0}, 0.0},             //
        {{-1e-300, 1.0}, never},           //
        {{0.0, 1e-7}, never},              // slowly
        {{0.0, -1e-7}, 0.0},               //
        {{1e-12, -1e-7}, 1e-5},            //
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const double time = failure_of_polynomial(cases[i].c, 4, AFTER + 10.0);
        const double expected = AFTER + cases[i].time;
        const bool good = isinf(expected) ? isinf(time) : fabs(time - expected) < 2e-8 && time >= AFTER;
        if (!good)
            printf("case %zu: %.17g\n", i, time - AFTER);
        assert_true(good);
    }
}

/// What is zero up to rounding when the grace of a start is over has grown; what is clearly below has not.
TEST(a_start_below_zero_has_grown_where_its_grace_ends_at_zero) {
    const double grace = bmr_start_grace(AFTER, bmr_default_failure_options().tolerance * AFTER);
    const double grown[] = {-grace, 1.0}, below[] = {-1.1 * grace, 1.0};
    assert_true(isinf(failure_of_polynomial(grown, 1, AFTER + 10.0)));
    assert_true(failure_of_polynomial(below, 1, AFTER + 10.0) == AFTER);
}

/// A rounding of a thousand below zero, and so slow that no few tolerances of time lead out of it.
TEST(rounding_below_zero_is_zero) {
    for (int spinning = 0; spinning < 2; spinning++)
        for (int sign = -1; sign <= 1; sign += 2) {
            const bmr_pose pose = {{nextafter(1000.0, 0.0), 0.0}, 1.0, 0.0};
            still = made_motion(bmr_piece_rest(bmr_pose_identity()));
            moving =
                made_motion(bmr_piece_screw(AFTER, pose, bmr_vec2_make(1e-7 * sign, 0.0), (double)spinning));
            bmr_condition k =
                bmr_condition_beyond(0, bmr_vec2_make(1.0, 0.0), 1000.0, bmr_vec2_make(0.0, 0.0), 0);
            const double time = failure_of(&k, AFTER, AFTER + 9.0);
            assert_true(sign > 0 ? isinf(time) : time == AFTER);
            // A path of polynomials is judged by the far future where the time asked for is too short.
            const double soon = failure_of(&k, AFTER, AFTER + 1e-9);
            assert_true(spinning || (sign > 0 ? isinf(soon) : soon == AFTER));
            // The control: a millionth below is more than rounding.
            k.offset += 1e-6;
            assert_true(failure_of(&k, AFTER, AFTER + 9.0) == AFTER);
            drop();
        }
}

/// The product of (t - shift - k/8), k = 1 .. 8, in powers of t.
static bmr_motion_piece eight_roots(double origin, double shift) {
    bmr_algebraic_piece w = {.degree = 8, .x = {1.0}};
    for (int k = 0; k < 8; k++)
        for (int i = k + 1; i >= 0; i--)
            w.x[i] = (i > 0 ? w.x[i - 1] : 0.0) - (shift + (k + 1) / 8.0) * (i <= k ? w.x[i] : 0.0);
    return test_algebraic(origin, w);
}

/// Section 2, failure times: when a certificate fails is a root of a polynomial.
/// A structure that waits for a condition and for its opposite in turn once never came past a root of a path
/// of degree 8, at a tolerance of 1e-11.
TEST(eight_roots_are_eight_events) {
    bmr_failure_options options = bmr_default_failure_options();
    options.tolerance = 1e-11;
    for (int far = 0; far < 2; far++) {
        still = made_motion(bmr_piece_rest(bmr_pose_identity()));
        moving = made_motion(far ? eight_roots(0.0, 100.0) : eight_roots(100.0, 0.0));
        bmr_condition k = bmr_condition_beyond(0, bmr_vec2_make(1.0, 0.0), 0.0, bmr_vec2_make(0.0, 0.0), 0);
        size_t events = 0;
        double time = 99.0;
        for (; events < 9; events++) {
            double next;
            assert_int_equal(bmr_failure_time(&k, still, moving, time, 110.0, &options, &next), BMR_OK);
            if (isinf(next))
                break;
            time = next;
            k.normal = bmr_neg(k.normal);
            // Around a far origin all digits of the value are lost before the first root: enough to know
            // that no call hangs.
            assert_true(far || fabs(time - 100.0 - (double)(events + 1) / 8.0) < 1e-8);
        }
        assert_true(far || events == 8);
        drop();
    }
}
