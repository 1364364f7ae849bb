// SPDX-License-Identifier: MIT
// The total update time of the theorems: the elementary steps of all repairs of a whole motion
// (tests/claims/steps shows that these are the time), as a function of the separation and of the number of
// vertices.
#include "checks.h"
#include "kds_driver.h"
#include "motions.h"

#define VERTICES 1024
/// Separations, in decades of the diameter: mu is below VERTICES at all of them.
#define NEAR 3
#define FAR 1

/// Steps of all repairs, the start left out.
typedef struct total {
    double steps;
} total;

static void add_steps(void *context, const test_drive_event *event) {
    total *t = context;
    if (event->report.kind != BMR_KDS_START)
        t->steps += event->report.touched;
}

/// The mean of some motions that come as near as 10^-decade diameters.
static double total_steps(const char *name, test_path_kind kind, bool rotates, size_t n, int decade) {
    const size_t seeds = test_scaled(2);
    const bmr_kds_info *info = test_structure(name);
    total t = {0.0};
    for (size_t seed = 1; seed <= seeds; ++seed) {
        test_random random = {seed};
        own_kds_body a = test_kds_body_make(test_polygon(TEST_REGULAR, n, &random));
        own_kds_body b = info->domain == BMR_KDS_POINT
                             ? test_kds_point_make(0.0, 0.0)
                             : test_kds_body_make(test_polygon(TEST_REGULAR, n, &random));
        bmr_kds_def def = bmr_default_kds_def();
        def.margin = 1e-8;
        const double gap = 2.0 * a.polygon->radius * pow(10.0, -decade);
        const test_path path = test_path_make(kind, a.polygon, b.polygon, gap, rotates, &random);
        const test_drive how = {
            .path = &path, .audit_every = 1000, .margin = def.margin, .on_event = add_steps, .context = &t};
        own_kds *kds = made_kds(info, &def, &a.shape, &b.shape);
        const test_drive_result r = test_drive_run(kds, a.polygon, b.polygon, &how);
        assert_true(test_drive_is_sound(&r));
    }
    return t.steps / (double)seeds;
}

/// What one of the paper's structures is allowed: steps for each decade of D/s on a convex path, and for each
/// unit of mu on any other. Twice what was measured, or a little less.
typedef struct allowance {
    const char *name;
    double a_decade, a_root;
} allowance;

static const allowance points[] = {{"triangle-levels-compass", 20.0, 20.0},
                                   {"triangle-binary-dudley", 20.0, 20.0},
                                   {"point-lazy-dudley", 12.0, 15.0}};
static const allowance pairs[] = {{"active-cell-compass", 200.0, 200.0},
                                  {"active-cell-dudley", 200.0, 200.0},
                                  {"lazy-compass", 100.0, 150.0},
                                  {"lazy-dudley", 100.0, 150.0}};

/// Vertices at which mu is n, and decades at which it is.
#define FEW 16
#define MANY 128
#define SATURATED 5
/// In n where mu is n. The compass hierarchy may have a logarithm more: 1.27 from 16 to 128 vertices.
#define MOST_EXPONENT 1.27

static void look_at(const allowance *a) {
    double straight = 0.0;
    const test_path_kind convex[] = {TEST_PATH_LINE, TEST_PATH_PARABOLA};
    for (size_t k = 0; k < COUNT_OF(convex); ++k) {
        const double far = total_steps(a->name, convex[k], false, VERTICES, FAR),
                     near = total_steps(a->name, convex[k], false, VERTICES, NEAR);
        assert_true(near - far <= a->a_decade * (NEAR - FAR));
        straight = fmax(straight, near);
    }
    const double far = total_steps(a->name, TEST_PATH_ORBIT, false, VERTICES, FAR),
                 near = total_steps(a->name, TEST_PATH_ORBIT, false, VERTICES, NEAR),
                 few = total_steps(a->name, TEST_PATH_ORBIT, false, FEW, SATURATED),
                 many = total_steps(a->name, TEST_PATH_ORBIT, false, MANY, SATURATED);
    printf("%s: %.0f steps on a convex path, %.0f and %.0f on orbits at D/s = 10 and 1000; mu = n: "
           "%.0f and %.0f for %d and %d vertices\n",
           a->name, straight, far, near, few, many, FEW, MANY);
    assert_true(near <= a->a_root * pow(10.0, 0.5 * NEAR));
    assert_true(log(many / few) / log((double)MANY / FEW) <= MOST_EXPONENT);
    assert_true(many <= a->a_root * MANY);
    assert_true(near - far > a->a_decade * (NEAR - FAR)); // control: an orbit does not bend away
}

/// Theorem 5.1: a point: O(min{log log n, log(D/s)}) an event, O(log mu) or O(mu) events.
TEST(all_repairs_of_a_point_take_the_logarithm_of_mu_or_mu) {
    for (size_t i = 0; i < COUNT_OF(points); ++i)
        look_at(&points[i]);
    // Control: a rival's time is n on a convex path, however far away.
    const double rival = total_steps("closest-features", TEST_PATH_LINE, false, VERTICES, FAR);
    assert_true(rival > 20.0 * points[0].a_decade * (NEAR - FAR));
}

/// Theorem 5.2: translations: O(log min{n, D/s}) an event, O(log mu) or O(mu) events.
TEST(all_repairs_of_a_translation_take_the_logarithm_of_mu_or_mu) {
    for (size_t i = 0; i < COUNT_OF(pairs); ++i)
        look_at(&pairs[i]);
}

/// Theorem 5.3: rigid motions: O(log min{n, D/s}) an event, O(mu^2) events.
/// Measured, an orbit on which the other body turns: mu, with a factor of 90 to 130.
TEST(all_repairs_of_a_rigid_motion_take_less_than_the_square_of_mu) {
    for (size_t i = 0; i < COUNT_OF(pairs); ++i) {
        const double near = total_steps(pairs[i].name, TEST_PATH_ORBIT, true, VERTICES, NEAR),
                     few = total_steps(pairs[i].name, TEST_PATH_ORBIT, true, FEW, SATURATED),
                     many = total_steps(pairs[i].name, TEST_PATH_ORBIT, true, MANY, SATURATED);
        printf("%s: %.0f steps at D/s = 1000, mu = n: %.0f and %.0f\n", pairs[i].name, near, few, many);
        assert_true(near <= pairs[i].a_root * pow(10.0, NEAR));
        assert_true(many <= pairs[i].a_root * MANY * MANY);
        // What this motion costs, and a tenth: 112 mu where the separation is what counts, 75 mu where n is.
        assert_true(near <= 123.0 * pow(10.0, 0.5 * NEAR) && many <= 82.0 * MANY);
        assert_true(log(many / few) / log((double)MANY / FEW) <= MOST_EXPONENT);
    }
    // Control: a rival's time is not bounded by the separation.
    const double rival = total_steps("closest-features", TEST_PATH_ORBIT, true, VERTICES, NEAR);
    printf("closest-features: %.0f steps\n", rival);
    assert_true(rival > 123.0 * pow(10.0, 0.5 * NEAR));
}
