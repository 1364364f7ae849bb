// SPDX-License-Identifier: MIT
// First failure times against long double: dense looks, minima between them
// sought out, on random motions of every kind. Never late, at most the
// tolerance early.
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "boomerang/failure.h"
#include "polygons.h"
#include "test_scale.h"

#define PI 3.14159265358979323846
#define BEGIN 0.0
#define END 4.0
#define LOOKS 600

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

/// A motion as it was asked for.
typedef struct plan {
    size_t count;
    double from[8];
    bmr_motion_piece pieces[8];
} plan;

typedef struct place {
    long double x, y, c, s;
} place;

static long double horner(const double *c, size_t degree, long double u) {
    long double value = c[degree];
    for (size_t k = degree; k-- > 0;)
        value = value * u + (long double)c[k];
    return value;
}

static place place_at(const plan *p, long double t) {
    size_t i = 0;
    while (i + 1 < p->count && (long double)p->from[i + 1] <= t)
        i++;
    const bmr_motion_piece *piece = &p->pieces[i];
    const long double u = t - (long double)piece->origin;
    place at;
    long double c, s, c0, s0;
    if (piece->kind == BMR_PIECE_SCREW) {
        const bmr_screw_motion *w = &piece->as.screw;
        at.x = (long double)w->start.position.x + u * (long double)w->velocity.x;
        at.y = (long double)w->start.position.y + u * (long double)w->velocity.y;
        c = cosl((long double)w->spin * u);
        s = sinl((long double)w->spin * u);
        c0 = w->start.c;
        s0 = w->start.s;
    } else {
        const bmr_algebraic_piece *w = &piece->as.algebraic;
        at.x = horner(w->x, w->degree, u);
        at.y = horner(w->y, w->degree, u);
        const long double a = horner(w->a, w->rotation_degree, u), b = horner(w->b, w->rotation_degree, u);
        c = (a * a - b * b) / (a * a + b * b);
        s = 2.0L * a * b / (a * a + b * b);
        c0 = w->start_c;
        s0 = w->start_s;
    }
    const long double unit = hypotl(c0, s0);
    at.c = (c * c0 - s * s0) / unit;
    at.s = (s * c0 + c * s0) / unit;
    return at;
}

typedef struct trial {
    plan a, b;
    bmr_motion *motion_a, *motion_b;
    bmr_condition condition;
} trial;

/// The condition's value; *size: the lengths that go into it.
static long double value_at(const trial *r, long double t, long double *size) {
    const bmr_condition *k = &r->condition;
    const place o = place_at(k->owner == 0 ? &r->a : &r->b, t),
                x = place_at(k->owner == 0 ? &r->b : &r->a, t);
    const long double nx = o.c * (long double)k->normal.x - o.s * (long double)k->normal.y,
                      ny = o.s * (long double)k->normal.x + o.c * (long double)k->normal.y;
    const long double px = x.c * (long double)k->point.x - x.s * (long double)k->point.y,
                      py = x.s * (long double)k->point.x + x.c * (long double)k->point.y;
    const long double n = hypotl(nx, ny), p = hypotl(px, py);
    const long double ways = hypotl(o.x, o.y) + hypotl(x.x, x.y);
    if (size)
        *size = k->kind == BMR_CONDITION_TURN    ? n * p
                : k->kind == BMR_CONDITION_DISKS ? n + p + ways + fabsl((long double)k->offset)
                                                 : n * (p + ways) + fabsl((long double)k->offset);
    if (k->kind == BMR_CONDITION_TURN)
        return nx * py - ny * px;
    if (k->kind == BMR_CONDITION_DISKS)
        return hypotl(px + x.x - o.x - nx, py + x.y - o.y - ny) - (long double)k->offset;
    return nx * (px + x.x - o.x) + ny * (py + x.y - o.y) - (long double)k->offset;
}

static double uniform(test_random *random, double low, double high) {
    return test_random_uniform(random, low, high);
}

static bmr_pose random_pose(test_random *random) {
    const double angle = uniform(random, -PI, PI);
    const bmr_pose pose = {{uniform(random, -3.0, 3.0), uniform(random, -3.0, 3.0)}, cos(angle), sin(angle)};
    return pose;
}

static bmr_motion_piece random_algebraic(test_random *random, size_t rotation_degree) {
    bmr_motion_piece piece;
    memset(&piece, 0, sizeof piece);
    piece.kind = BMR_PIECE_ALGEBRAIC;
    piece.origin = uniform(random, BEGIN, END);
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
static bmr_motion *random_motion(test_random *random, motion_kind kind, plan *p) {
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
        if (piece.kind == BMR_PIECE_SCREW) {
            piece.as.screw.start = pose;
        } else {
            piece.as.algebraic.x[0] = pose.position.x;
            piece.as.algebraic.y[0] = pose.position.y;
            piece.as.algebraic.a[0] = 1.0;
            piece.as.algebraic.b[0] = 0.0;
            piece.as.algebraic.start_c = pose.c;
            piece.as.algebraic.start_s = pose.s;
        }
        piece.origin = t;
        assert_int_equal(bmr_motion_change(motion, t, &piece), BMR_OK);
    }
    // Read it back: what the pieces are is test_kinetic_motion's business.
    p->count = 0;
    double t = -INFINITY;
    do {
        double end;
        p->from[p->count] = t;
        p->pieces[p->count++] = *bmr_motion_piece_at(motion, t, &end);
        t = end;
    } while (!isinf(t));
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
    r.motion_a = random_motion(random, a, &r.a);
    r.motion_b = random_motion(random, b, &r.b);
    r.condition = random_condition(random, condition);
    return r;
}

static void drop_trial(trial *r) {
    bmr_motion_destroy(r->motion_a);
    bmr_motion_destroy(r->motion_b);
}

// ---- the verdict ----

/// What a value may be below zero, in parts of the lengths that go into it: the
/// header's 1e-14, times the growth over one interval and the number of terms
/// of the algebraic ones.
#define VALUE_SLACK 2e-12L

typedef struct verdict {
    bool late, early;
    long double worst; ///< the least value before the time, over the lengths involved
} verdict;

/// The least value in [low, high] around `middle`, by golden section.
static long double least_near(const trial *r, long double low, long double high) {
    const long double ratio = 0.6180339887498949L;
    long double p = high - ratio * (high - low), q = low + ratio * (high - low);
    long double fp = value_at(r, p, NULL), fq = value_at(r, q, NULL);
    for (int i = 0; i < 60; i++) {
        if (fp < fq) {
            high = q;
            q = p;
            fq = fp;
            p = high - ratio * (high - low);
            fp = value_at(r, p, NULL);
        } else {
            low = p;
            p = q;
            fp = fq;
            q = low + ratio * (high - low);
            fq = value_at(r, q, NULL);
        }
    }
    return fminl(fp, fq);
}

/// Judges a failure time (INFINITY: none until END).
static verdict judge(const trial *r, double after, double time, double tolerance) {
    verdict v = {false, false, 0.0L};
    const long double last = fminl((long double)time, (long double)END);
    const long double step = (last - (long double)after) / LOOKS;
    long double size, before = INFINITY, here = value_at(r, after, &size), worst = 0.0L;
    for (int i = 1; i <= LOOKS && step > 0.0L; i++) {
        const long double t = (long double)after + step * i - (i == LOOKS ? 1e-17L : 0.0L);
        const long double next = value_at(r, t, &size);
        if (i < LOOKS)
            worst = fminl(worst, next / size);
        if (here <= before && here <= next && i > 1 && here < 0.05L * size)
            worst = fminl(worst, least_near(r, t - 2.0L * step, t) / size);
        before = here;
        here = next;
    }
    // Nearer and nearer to the end, and there.
    for (int i = 0; i < 60 && step > 0.0L; i++) {
        const long double value = value_at(r, last - ldexpl(step, -i), &size);
        worst = fminl(worst, value / size);
    }
    if (!isinf(time))
        worst = fminl(worst, value_at(r, last, &size) / size);
    v.worst = worst;
    v.late = worst < -VALUE_SLACK;
    if (!isinf(time)) {
        v.early = true;
        for (int i = 0; i <= LOOKS && v.early; i++) {
            const long double part = (long double)tolerance * (LOOKS - i) / LOOKS;
            v.early = value_at(r, (long double)time + part, &size) > VALUE_SLACK * size;
        }
    }
    return v;
}

static double failure(const trial *r, double after, bmr_root_method method, double tolerance) {
    bmr_failure_options options = bmr_default_failure_options();
    options.method = method;
    options.tolerance = tolerance;
    double time = -1.0;
    assert_int_equal(bmr_failure_time(&r->condition, r->motion_a, r->motion_b, after, END, &options, &time),
                     BMR_OK);
    assert_true(time >= after);
    return time;
}

/// Until its true value is clearly positive there.
static bool starts_positive(const trial *r, double after) {
    long double size;
    const long double value = value_at(r, after, &size);
    return value > 1e-6L * size;
}

static void no_failure_is_late_and_none_early(void **state) {
    (void)state;
    test_random random = {20261121};
    const size_t rounds = test_scaled(40);
    size_t judged = 0, failing = 0, controls = 0, caught = 0;
    long double worst = 0.0L;
    for (size_t round = 0; round < rounds; round++)
        for (int a = 0; a < MOTION_KINDS; a++)
            for (int b = 0; b < MOTION_KINDS; b++)
                for (int k = 0; k < BMR_CONDITION_KIND_COUNT; k++) {
                    trial r = make_trial(&random, (motion_kind)a, (motion_kind)b, k);
                    const double after = uniform(&random, BEGIN, 0.5 * END);
                    const double tolerance = pow(10.0, uniform(&random, -13.0, -3.0));
                    if (starts_positive(&r, after)) {
                        const double time = failure(&r, after, BMR_ROOT_BERNSTEIN, tolerance);
                        const double width = 1.01 * tolerance * fmax(1.0, fabs(time));
                        const verdict v = judge(&r, after, time, isinf(time) ? 0.0 : width);
                        if (v.late || v.early)
                            print_message("round %zu kinds %d %d condition %d: time %.17g "
                                          "late %d early %d "
                                          "worst %Lg tolerance %g\n",
                                          round, a, b, k, time, v.late, v.early, v.worst, tolerance);
                        assert_false(v.late);
                        assert_false(v.early);
                        worst = fminl(worst, v.worst);
                        judged++;
                        failing += !isinf(time);
                        // The control: a time that is late, or none, is caught where there
                        // is one.
                        if (!isinf(time) && time + 0.02 < END) {
                            controls++;
                            caught += judge(&r, after, time + 0.02, 0.0).late;
                        }
                    }
                    drop_trial(&r);
                }
    print_message("%zu judged, %zu with a failure, worst value %Lg of the "
                  "lengths; controls %zu of %zu\n",
                  judged, failing, worst, caught, controls);
    assert_true(failing > judged / 5 && judged - failing > judged / 10);
    assert_true(caught > controls * 9 / 10);
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
    long double size, before = value_at(r, after, &size), earlier = before;
    size_t changes = 0;
    *clear = fabsl(before) > 1e-3L * size;
    for (int i = 1; i <= looks; i++) {
        const long double here = value_at(r, (long double)after + step * i, &size);
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
static void a_condition_and_its_opposite_take_turns(void **state) {
    (void)state;
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
                        if (!(value_at(&r, BEGIN, NULL) > 0.0L))
                            negate(&r.condition);
                        const bmr_root_method method = round % 2 ? BMR_ROOT_GSL : BMR_ROOT_BERNSTEIN;
                        size_t found = 0;
                        for (double time = failure(&r, BEGIN, method, 1e-12); !isinf(time);
                             time = failure(&r, time, method, 1e-12)) {
                            assert_true(time <= last);
                            if (++found > expected)
                                break;
                            negate(&r.condition);
                        }
                        if (found != expected)
                            print_message("kinds %d %d condition %d: %zu of %zu\n", a, b, k, found, expected);
                        assert_int_equal(found, expected);
                        chains++;
                        links += found;
                    }
                    drop_trial(&r);
                }
    print_message("%zu chains, %zu changes of sign\n", chains, links);
    assert_true(chains > rounds * 20 && links > chains);
}

static void both_methods_find_the_same_root(void **state) {
    (void)state;
    test_random random = {77};
    const size_t rounds = test_scaled(600);
    size_t failing = 0, touches = 0;
    double worst = 0.0;
    for (size_t round = 0; round < rounds; round++)
        for (int a = 0; a <= GLIDE; a++)
            for (int b = 0; b <= GLIDE; b++)
                for (int k = 0; k < BMR_CONDITION_KIND_COUNT; k++) {
                    trial r = make_trial(&random, (motion_kind)a, (motion_kind)b, k);
                    if (starts_positive(&r, BEGIN)) {
                        const double s = failure(&r, BEGIN, BMR_ROOT_BERNSTEIN, 1e-12);
                        const double t = failure(&r, BEGIN, BMR_ROOT_GSL, 1e-12);
                        const double first = fmin(s, t);
                        if (!isinf(first) && fabs(s - t) > 1e-9) {
                            // Only a touch may be found by one and not by the other.
                            long double size;
                            const long double least =
                                least_near(&r, (long double)first - 1e-5L, (long double)first + 1e-5L);
                            value_at(&r, first, &size);
                            assert_true(fabsl(least) < VALUE_SLACK * size);
                            touches++;
                        } else if (!isinf(first)) {
                            worst = fmax(worst, fabs(s - t));
                            failing++;
                        }
                    }
                    drop_trial(&r);
                }
    print_message("%zu equal roots, %zu touches, largest difference %g\n", failing, touches, worst);
    assert_true(failing > rounds * 5 && touches * 1000 < failing + 1000);
}

/// Degree 8 everywhere: conditions of degree 24 to 48.
static void the_highest_degrees_are_judged_too(void **state) {
    (void)state;
    test_random random = {88};
    const size_t rounds = test_scaled(150);
    size_t failing = 0;
    for (size_t round = 0; round < rounds; round++)
        for (int k = 0; k < BMR_CONDITION_KIND_COUNT; k++) {
            trial r = make_trial(&random, GLIDE, GLIDE, k);
            bmr_motion **const motions[] = {&r.motion_a, &r.motion_b};
            plan *const plans[] = {&r.a, &r.b};
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
                    const verdict v = judge(&r, BEGIN, time, 1e-11);
                    if (v.late || v.early)
                        print_message("method %d condition %d time %.17g late %d early %d "
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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_failure_is_late_and_none_early),
        cmocka_unit_test(a_condition_and_its_opposite_take_turns),
        cmocka_unit_test(both_methods_find_the_same_root),
        cmocka_unit_test(the_highest_degrees_are_judged_too),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
