// SPDX-License-Identifier: MIT
// What the paper's table says of a structure: how many events a motion costs, and how many elementary steps
// all of its repairs take (tests/claims/steps shows that these are the time), as functions of the separation
// and of the number of vertices.
#include "checks.h"
#include "driven.h"
#include "motions.h"

#define VERTICES 1024
/// Nearest and farthest separation, in decades of the diameter: mu is below VERTICES at both.
#define NEAR 3
#define FAR 1
/// Vertices at which mu is n, and decades at which it is.
#define FEW 16
#define MANY 128
#define SATURATED 5
/// Of steps in n where mu is n. The compass hierarchy may have a logarithm more: 1.27 from 16 to 128
/// vertices.
#define MOST_EXPONENT 1.27

/// Of one motion; the steps of its start are left out.
typedef struct cost {
    double events, steps;
} cost;

static void add_steps(void *context, const test_drive_event *event) {
    cost *c = context;
    if (event->report.kind != BMR_KDS_START)
        c->steps += event->report.touched;
}

/// The mean of some motions past regular polygons that come as near as 10^-decade diameters.
static cost mean_cost(const char *name, test_path_kind kind, bool rotates, size_t n, int decade) {
    enum { SEEDS = 2 };
    const bmr_kds_info *info = test_structure(name);
    cost c = {0.0, 0.0};
    for (uint64_t seed = 1; seed <= SEEDS; ++seed) {
        test_random random = test_random_from(seed);
        own_kds_body a = test_kds_body_make(test_polygon(TEST_REGULAR, n, &random));
        own_kds_body b = info->domain == BMR_KDS_POINT
                             ? test_kds_point_make(0.0, 0.0)
                             : test_kds_body_make(test_polygon(TEST_REGULAR, n, &random));
        const double gap = 2.0 * a.polygon->radius * pow(10.0, -decade);
        const test_path path = test_path_make(kind, a.polygon, b.polygon, gap, rotates, &random);
        const test_drive how = {
            .path = &path, .audit_every = 1000, .margin = 1e-8, .on_event = add_steps, .context = &c};
        const test_drive_result r = driven(name, &a, &b, &how);
        c.events += (double)test_drive_events(&r);
    }
    c.events /= SEEDS;
    c.steps /= SEEDS;
    return c;
}

/// A structure, and the most that it may cost: for a decade of D / sigma on a convex pass, and for sqrt(D /
/// sigma) on an orbit. Of steps: twice what was measured, or a little less. 0: not asked.
typedef struct row {
    const char *name;
    cost a_decade, a_root;
} row;

static double root_of(int decades) {
    return pow(10.0, 0.5 * decades);
}

/// Is what separates near from far no more than a logarithm, of what the row asks for?
static bool is_logarithmic(const row *r, cost far, cost near) {
    return (r->a_decade.events <= 0.0 || near.events - far.events <= r->a_decade.events * (NEAR - FAR)) &&
           (r->a_decade.steps <= 0.0 || near.steps - far.steps <= r->a_decade.steps * (NEAR - FAR));
}

static void check_convex_passes(const row *r) {
    const test_path_kind convex[] = {TEST_PATH_LINE, TEST_PATH_PARABOLA};
    for (size_t k = 0; k < COUNT_OF(convex); ++k) {
        const cost away = mean_cost(r->name, convex[k], false, VERTICES, FAR),
                   close = mean_cost(r->name, convex[k], false, VERTICES, NEAR);
        printf("%s: convex pass %.1f, %.1f events, %.0f, %.0f steps\n", r->name, away.events, close.events,
               away.steps, close.steps);
        assert_true(is_logarithmic(r, away, close));
    }
}

/// Returns what the nearest orbit costs.
static cost check_orbit(const row *r, bool rotates) {
    const cost far = mean_cost(r->name, TEST_PATH_ORBIT, rotates, VERTICES, FAR),
               near = mean_cost(r->name, TEST_PATH_ORBIT, rotates, VERTICES, NEAR);
    const double exponent = log10(near.events / far.events) / (NEAR - FAR);
    printf("%s: orbit %.1f, %.1f events: exponent %.2f; %.0f, %.0f steps\n", r->name, far.events, near.events,
           exponent, far.steps, near.steps);
    if (r->a_root.events > 0.0)
        assert_true(exponent >= 0.4 && exponent <= 0.65 && near.events <= r->a_root.events * root_of(NEAR));
    // Control: an orbit does not bend away.
    assert_true(near.events - far.events > r->a_decade.events * (NEAR - FAR));
    assert_true(near.steps - far.steps > r->a_decade.steps * (NEAR - FAR));
    return near;
}

/// Where mu is n: steps of an orbit of MANY vertices.
static double check_saturated_orbit(const row *r, bool rotates) {
    const cost few = mean_cost(r->name, TEST_PATH_ORBIT, rotates, FEW, SATURATED),
               many = mean_cost(r->name, TEST_PATH_ORBIT, rotates, MANY, SATURATED);
    printf("%s: mu = n: %.0f and %.0f steps for %d and %d vertices\n", r->name, few.steps, many.steps, FEW,
           MANY);
    assert_true(log(many.steps / few.steps) / log((double)MANY / FEW) <= MOST_EXPONENT);
    return many.steps;
}

static void check_translations(const row *r) {
    check_convex_passes(r);
    const cost near = check_orbit(r, false);
    if (r->a_root.steps > 0.0) {
        assert_true(near.steps <= r->a_root.steps * root_of(NEAR));
        assert_true(check_saturated_orbit(r, false) <= r->a_root.steps * MANY);
    }
}

/// Lemma 3.3(c): a convex curve at distance s meets O(log(D/s)) compass triangles.
/// Lemma 3.4(c): a convex curve at distance s meets O(log(D/s)) Dudley triangles.
/// Theorem 5.1: a point: O(min{log log n, log(D/s)}) an event, O(log mu) or O(mu) events.
/// Measured: up to 2 events a decade. All structures of a point are here that are no rivals.
TEST(all_repairs_of_a_point_take_the_logarithm_of_mu_or_mu) {
    static const row rows[] = {{"triangle-levels-compass", {3.0, 20.0}, {5.0, 20.0}},
                               {"triangle-levels-dudley", {3.0, 0.0}, {5.0, 0.0}},
                               {"triangle-binary-dudley", {3.0, 20.0}, {5.0, 20.0}},
                               {"point-lazy-dudley", {3.0, 12.0}, {5.0, 15.0}},
                               {"point-inflated-compass", {3.0, 0.0}, {5.0, 0.0}},
                               {"point-inflated-dudley", {3.0, 0.0}, {5.0, 0.0}},
                               {"point-complex", {3.0, 0.0}, {5.0, 0.0}}};
    for (const row *r = rows; r < rows + COUNT_OF(rows); ++r)
        check_translations(r);
    size_t of_points = 0;
    for (size_t i = 0; i < bmr_kds_count(); ++i)
        of_points += bmr_kds_at(i)->domain == BMR_KDS_POINT && bmr_kds_at(i)->role != BMR_KDS_RIVAL;
    assert_int_equal(of_points, COUNT_OF(rows));
}

/// Theorem 5.2: translations: O(log min{n, D/s}) an event, O(log mu) or O(mu) events.
/// Measured: 2.9 events a decade for the lazy structures, 0.8 to 2.3 for those that are allowed 5; 2.9 to 4.4
/// roots for those that are allowed 6. A line meets 3 log2(D / sigma) + 2 cells of the compass; of the
/// Dudley hierarchy as many as the root, see below.
TEST(translations_cost_what_the_table_says) {
    static const row rows[] = {{"lazy-compass", {4.0, 100.0}, {10.0, 150.0}},
                               {"lazy-dudley", {4.0, 100.0}, {10.0, 150.0}},
                               {"active-cell-compass", {10.0, 200.0}, {15.0, 200.0}},
                               {"active-cell-dudley", {22.0, 200.0}, {15.0, 200.0}},
                               {"sum-triangle-dudley", {5.0, 0.0}, {6.0, 0.0}},
                               {"inflated-translation", {5.0, 0.0}, {6.0, 0.0}},
                               {"inflated-window", {5.0, 0.0}, {6.0, 0.0}},
                               {"free-fd2", {5.0, 0.0}, {6.0, 0.0}}};
    for (const row *r = rows; r < rows + COUNT_OF(rows); ++r)
        check_translations(r);
    // Control: a rival has no such bounds: not of events, and its time is n on a convex path, however far
    // away.
    assert_true(mean_cost("closest-features", TEST_PATH_ORBIT, false, VERTICES, FAR).events >
                10.0 * root_of(FAR));
    assert_true(mean_cost("closest-features", TEST_PATH_LINE, false, VERTICES, FAR).steps >
                20.0 * 20.0 * (NEAR - FAR));
}

/// Lemma 4.4(b): a convex curve meets O(log(D/s)) and O(sqrt(D/s)) mixed triangles.
/// Lemma mixed2 (b) and Table 1: a line may cost the mixed Dudley hierarchy the square root. Measured: x 3.8.
TEST(a_line_costs_the_mixed_dudley_hierarchy_no_more_than_the_square_root) {
    const double far = mean_cost("active-cell-dudley", TEST_PATH_LINE, false, VERTICES, FAR).events,
                 near = mean_cost("active-cell-dudley", TEST_PATH_LINE, false, VERTICES, NEAR).events;
    assert_true(near > far && near <= root_of(NEAR - FAR) * far);
    const double rival = mean_cost("closest-features", TEST_PATH_LINE, false, VERTICES, NEAR).events;
    assert_true(rival > 10.0 * near); // control
}

/// Theorem 5.3: rigid motions: O(log min{n, D/s}) an event, O(mu^2) events.
/// The bound for rigid motion is linear in D / sigma: a factor of 100 here. Measured: 1.6 to 2.0, and 6.6
/// with the three-vertex window. Lazy structures are far from it: 7.3 events a decade on a pass, and the root
/// on an orbit. The steps of an orbit on which the other body turns are mu, with a factor of 90 to 130.
TEST(a_tumbling_motion_costs_far_less_than_the_linear_bound) {
    static const row rows[] = {
        {"lazy-compass", {10.0, 0.0}, {10.0, 150.0}},      {"lazy-dudley", {10.0, 0.0}, {10.0, 150.0}},
        {"active-cell-compass", {0.0, 0.0}, {0.0, 200.0}}, {"active-cell-dudley", {0.0, 0.0}, {0.0, 200.0}},
        {"inflated-window", {0.0, 0.0}, {0.0, 0.0}},       {"free-fd2", {0.0, 0.0}, {0.0, 0.0}}};
    const double rival = mean_cost("closest-features", TEST_PATH_LINE, true, VERTICES, NEAR).events;
    for (const row *r = rows; r < rows + COUNT_OF(rows); ++r) {
        const cost far = mean_cost(r->name, TEST_PATH_LINE, true, VERTICES, FAR),
                   near = mean_cost(r->name, TEST_PATH_LINE, true, VERTICES, NEAR);
        printf("%s: tumbling pass %.1f, %.1f events\n", r->name, far.events, near.events);
        assert_true(near.events > far.events && near.events <= root_of(NEAR - FAR) * far.events);
        assert_true(is_logarithmic(r, far, near));
        assert_true(10.0 * near.events < rival); // control
        if (r->a_root.steps <= 0.0)
            continue;
        const cost orbit = r->a_root.events > 0.0 ? check_orbit(r, true)
                                                  : mean_cost(r->name, TEST_PATH_ORBIT, true, VERTICES, NEAR);
        const double many = check_saturated_orbit(r, true);
        assert_true(orbit.steps <= r->a_root.steps * pow(10.0, NEAR));
        assert_true(many <= r->a_root.steps * MANY * MANY);
        // What this motion costs, and a tenth: 112 mu where the separation is what counts, 75 mu where n is.
        assert_true(orbit.steps <= 123.0 * root_of(NEAR) && many <= 82.0 * MANY);
    }
    // Control: a rival's time is not bounded by the separation.
    assert_true(mean_cost("closest-features", TEST_PATH_ORBIT, true, VERTICES, NEAR).steps >
                123.0 * root_of(NEAR));
}
