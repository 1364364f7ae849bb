// SPDX-License-Identifier: MIT
// First failure times against long double: dense looks, minima between them sought out. Never late, at most
// the tolerance early. (On motions of every kind: random/fuzz_events.c.)
#include <float.h>

#include "boomerang/failure.h"
#include "checks.h"
#include "failure_oracle.h"
#include "motion_pieces.h"
#include "polygons.h"
#include "test_scale.h"

#define PI 3.14159265358979323846
#define BEGIN 0.0
#define END 4.0
#define LOOKS ORACLE_LOOKS

// ---- motions, and what they do in long double ----

typedef enum motion_kind {
    POLYNOMIAL,
    ALGEBRAIC,
    GLIDE,
    SPINNING,
    CHANGING,
    SAMPLED,
    MOTION_KINDS
} motion_kind;

typedef struct trial {
    oracle_trial moving;
    bmr_motion *motion_a, *motion_b;
} trial;

static double uniform(test_random *random, double low, double high) {
    return test_random_uniform(random, low, high);
}

static bmr_pose random_pose(test_random *random) {
    const double angle = uniform(random, -PI, PI);
    const bmr_pose pose = {{uniform(random, -3.0, 3.0), uniform(random, -3.0, 3.0)}, cos(angle), sin(angle)};
    return pose;
}

static bmr_motion_piece random_algebraic(test_random *random, size_t rotation_degree) {
    bmr_motion_piece piece = test_algebraic(uniform(random, BEGIN, END), (bmr_algebraic_piece){.degree = 0});
    bmr_algebraic_piece *w = &piece.as.algebraic;
    w->degree = test_random_below(random, BMR_MOTION_MAX_DEGREE + 1);
    double scale = 3.0;
    for (size_t k = 0; k <= w->degree; k++, scale /= 3.0) {
        w->x[k] = uniform(random, -scale, scale);
        w->y[k] = uniform(random, -scale, scale);
    }
    w->rotation_degree = rotation_degree;
    scale = 1.0;
    for (size_t k = 0; k <= rotation_degree; k++, scale /= 2.0) {
        w->a[k] = uniform(random, -scale, scale);
        w->b[k] = uniform(random, -scale, scale);
    }
    const bmr_pose start = random_pose(random);
    w->start_c = start.c;
    w->start_s = start.s;
    return piece;
}

static bmr_motion_piece random_screw(test_random *random, bool spins) {
    const bmr_vec2 velocity = {uniform(random, -2.0, 2.0), uniform(random, -2.0, 2.0)};
    return bmr_piece_screw(uniform(random, BEGIN, END), random_pose(random), velocity,
                           spins ? uniform(random, -6.0, 6.0) : 0.0);
}

static bmr_motion_piece random_piece(test_random *random, motion_kind kind) {
    switch (kind) {
    case POLYNOMIAL:
        return random_algebraic(random, 0);
    case ALGEBRAIC:
        return random_algebraic(random, 1 + test_random_below(random, 3));
    case GLIDE:
        return random_screw(random, false);
    default:
        return random_screw(random, true);
    }
}

/// `exact`: as the motion keeps it; samples are joined as the header says.
static bmr_motion *random_motion(test_random *random, motion_kind kind, oracle_plan *p) {
    bmr_motion *motion = NULL;
    if (kind == SAMPLED) {
        double times[6];
        bmr_pose poses[6];
        for (size_t i = 0; i < 6; i++) {
            times[i] = BEGIN + (END - BEGIN) * ((double)i + uniform(random, 0.1, 0.9)) / 6.0;
            poses[i] = random_pose(random);
        }
        assert_int_equal(bmr_motion_create_sampled(times, poses, 6, NULL, &motion), BMR_OK);
    } else {
        const bmr_motion_piece piece = random_piece(random, kind == CHANGING ? SPINNING : kind);
        assert_int_equal(bmr_motion_create(&piece, NULL, &motion), BMR_OK);
    }
    for (double t = BEGIN + 0.7; kind == CHANGING && t < END; t += 1.1) {
        // The pose stays, the plan changes.
        const bmr_pose pose = bmr_motion_pose(motion, t, NULL, NULL);
        bmr_motion_piece piece = random_piece(random, (motion_kind)test_random_below(random, 4));
        test_piece_begin(&piece, t, pose);
        assert_int_equal(bmr_motion_change(motion, t, &piece), BMR_OK);
    }
    // What the pieces are is test_kinetic_motion's business.
    oracle_read_plan(motion, p);
    return motion;
}

static bmr_condition random_condition(test_random *random, int kind) {
    const bmr_pose q = random_pose(random);
    const bmr_vec2 point = {uniform(random, -2.0, 2.0), uniform(random, -2.0, 2.0)};
    const int owner = (int)test_random_below(random, 2);
    if (kind == BMR_CONDITION_TURN) {
        const bmr_pose w = random_pose(random);
        return bmr_condition_turn(owner, bmr_vec2_make(q.c, q.s), bmr_vec2_make(w.c, w.s), 0);
    }
    if (kind == BMR_CONDITION_DISKS)
        return bmr_condition_disks(q.position, point, uniform(random, 0.0, 4.0), 0);
    return bmr_condition_beyond(owner, bmr_vec2_make(q.c, q.s), uniform(random, -3.0, 3.0), point, 0);
}

static trial make_trial(test_random *random, motion_kind a, motion_kind b, int condition) {
    trial r;
    memset(&r, 0, sizeof r);
    r.motion_a = random_motion(random, a, &r.moving.a);
    r.motion_b = random_motion(random, b, &r.moving.b);
    r.moving.condition = random_condition(random, condition);
    return r;
}

static void drop_trial(trial *r) {
    bmr_motion_destroy(r->motion_a);
    bmr_motion_destroy(r->motion_b);
}

// ---- the verdict ----

static double failure(const trial *r, double after, bmr_root_method method, double tolerance) {
    bmr_failure_options options = bmr_default_failure_options();
    options.method = method;
    options.tolerance = tolerance;
    double time = -1.0;
    assert_int_equal(
        bmr_failure_time(&r->moving.condition, r->motion_a, r->motion_b, after, END, &options, &time),
        BMR_OK);
    assert_true(time >= after);
    return time;
}

/// Until its true value is clearly positive there.
static bool starts_positive(const trial *r, double after) {
    long double size;
    const long double value = oracle_value(&r->moving, after, &size);
    return value > 1e-6L * size;
}

/// The condition that holds where this one does not.
static void negate(bmr_condition *k) {
    k->normal = bmr_neg(k->normal);
    k->offset = -k->offset;
}

/// Changes of sign that a dense look sees; *clear: no two are so close, and no
/// value at an extremum so near to zero, that one of them might be missed.
static size_t sign_changes(const trial *r, double after, double *last, bool *clear) {
    const int looks = 8 * LOOKS;
    const long double step = ((long double)END - (long double)after) / looks;
    long double size, before = oracle_value(&r->moving, after, &size), earlier = before;
    size_t changes = 0;
    *clear = fabsl(before) > 1e-3L * size;
    for (int i = 1; i <= looks; i++) {
        const long double here = oracle_value(&r->moving, (long double)after + step * i, &size);
        if ((here > 0.0L) != (before > 0.0L)) {
            changes++;
            *last = (double)((long double)after + step * i);
        }
        const bool extremum = (before - earlier) * (here - before) <= 0.0L;
        *clear = *clear && !(extremum && fabsl(before) < 1e-3L * size);
        earlier = before;
        before = here;
    }
    *clear = *clear && fabsl(before) > 1e-3L * size;
    return changes;
}

/// From one failure to that of the opposite condition, and back: what a
/// structure does that rolls to and fro. Every change of sign is found, each
/// once, and none is found where it was found before.
TEST(a_condition_and_its_opposite_take_turns) {
    test_random random = {5};
    const size_t rounds = test_scaled(12);
    size_t chains = 0, links = 0;
    for (size_t round = 0; round < rounds; round++)
        for (int a = 0; a < MOTION_KINDS; a++)
            for (int b = 0; b < MOTION_KINDS; b++)
                for (int k = 0; k < BMR_CONDITION_DISKS; k++) {
                    trial r = make_trial(&random, (motion_kind)a, (motion_kind)b, k);
                    double last = 0.0;
                    bool clear;
                    const size_t expected = sign_changes(&r, BEGIN, &last, &clear);
                    if (clear) {
                        if (!(oracle_value(&r.moving, BEGIN, NULL) > 0.0L))
                            negate(&r.moving.condition);
                        const bmr_root_method method = round % 2 ? BMR_ROOT_GSL : BMR_ROOT_BERNSTEIN;
                        size_t found = 0;
                        for (double time = failure(&r, BEGIN, method, 1e-12); !isinf(time);
                             time = failure(&r, time, method, 1e-12)) {
                            assert_true(time <= last);
                            if (++found > expected)
                                break;
                            negate(&r.moving.condition);
                        }
                        if (found != expected)
                            printf("kinds %d %d condition %d: %zu of %zu\n", a, b, k, found, expected);
                        assert_int_equal(found, expected);
                        chains++;
                        links += found;
                    }
                    drop_trial(&r);
                }
    printf("%zu chains, %zu changes of sign\n", chains, links);
    assert_true(chains > rounds * 20 && links > chains);
}

/// Degree 8 everywhere: conditions of degree 24 to 48.
/// Section 2, failure times: when a certificate fails is a root of a polynomial.
TEST(the_highest_degrees_are_judged_too) {
    test_random random = {88};
    const size_t rounds = test_scaled(150);
    size_t failing = 0;
    for (size_t round = 0; round < rounds; round++)
        for (int k = 0; k < BMR_CONDITION_KIND_COUNT; k++) {
            trial r = make_trial(&random, GLIDE, GLIDE, k);
            bmr_motion **const motions[] = {&r.motion_a, &r.motion_b};
            oracle_plan *const plans[] = {&r.moving.a, &r.moving.b};
            for (int i = 0; i < 2; i++) {
                bmr_motion_destroy(*motions[i]);
                bmr_motion_piece piece = random_algebraic(&random, BMR_MOTION_MAX_DEGREE);
                for (piece.as.algebraic.degree = 0; piece.as.algebraic.degree < BMR_MOTION_MAX_DEGREE;)
                    piece = random_algebraic(&random, BMR_MOTION_MAX_DEGREE);
                assert_int_equal(bmr_motion_create(&piece, NULL, motions[i]), BMR_OK);
                plans[i]->pieces[0] = piece;
            }
            if (starts_positive(&r, BEGIN)) {
                for (int method = 0; method <= BMR_ROOT_GSL; method++) {
                    const double time = failure(&r, BEGIN, (bmr_root_method)method, 1e-12);
                    const oracle_verdict v = oracle_judge(&r.moving, BEGIN, END, time, 1e-11, LOOKS);
                    if (v.late || v.early)
                        printf("method %d condition %d time %.17g late %d early %d "
                               "worst %Lg\n",
                               method, k, time, v.late, v.early, v.worst);
                    assert_false(v.late);
                    assert_false(v.early);
                    failing += !isinf(time);
                }
            }
            drop_trial(&r);
        }
    assert_true(failing > rounds / 2);
}
