// SPDX-License-Identifier: MIT
// Theorem transpoly's other half: not how many events a translation has, but what each of them costs. A step
// is a vertex, an edge, a node or a cell that is looked at (tests/claims/steps shows that this is the time).
#include "checks.h"
#include "driven.h"

static const size_t sizes[] = {64, 2048, 32768};
/// D/s is 2 to the power of these.
static const int powers[] = {3, 5, 8, 12, 15};
#define SIZES COUNT_OF(sizes)
#define POWERS COUNT_OF(powers)
/// Those powers at which no polygon of `sizes` is in the annulus next to it, where D/s exceeds n.
#define POWERS_OUTSIDE 2

/// The exponent that is allowed. Measured: 0.2 for the lazy structures, 0 for the active cell, which has most
/// events where they are cheapest, 0.8 for the inflated one.
#define MOST_EXPONENT 1.2

/// From the fewest vertices to the most, at one separation.
#define MOST_GROWTH 1.5

/// The bodies, one pair for each size.
typedef struct pairs {
    test_kds_body a[SIZES], b[SIZES];
} pairs;

static pairs pairs_make(uint64_t seed) {
    pairs made;
    test_random random = test_random_from(seed);
    for (size_t i = 0; i < SIZES; ++i) {
        made.a[i] = test_kds_body_make(test_polygon(TEST_ELLIPSE, sizes[i], &random));
        made.b[i] = test_kds_body_make(test_polygon(TEST_REGULAR, sizes[i], &random));
    }
    return made;
}

static void pairs_destroy(pairs *made) {
    for (size_t i = 0; i < SIZES; ++i) {
        test_kds_body_destroy(&made->a[i]);
        test_kds_body_destroy(&made->b[i]);
    }
}

/// Of the repairs of one structure, one size and one separation.
typedef struct effort {
    double steps, most;
    size_t events;
} effort;

static void weigh(void *context, const test_drive_event *event) {
    effort *e = context;
    const bmr_kds_report *r = &event->report;
    if (r->kind == BMR_KDS_START || r->kind >= BMR_KDS_CONTACT)
        return;
    e->steps += r->touched;
    e->most = fmax(e->most, r->touched);
    ++e->events;
}

static void follow(const char *name, const pairs *made, size_t i, int power, uint64_t seed, effort *e) {
    const test_path_kind kinds[] = {TEST_PATH_LINE, TEST_PATH_CUBIC};
    for (size_t k = 0; k < COUNT_OF(kinds); ++k) {
        test_random random = test_random_from(seed);
        const bmr_polygon *a = made->a[i].polygon, *b = made->b[i].polygon;
        const test_path path =
            test_path_make(kinds[k], a, b, 2.0 * a->radius * pow(2.0, -power), false, &random);
        const test_drive how = {
            .path = &path, .audit_every = 100000, .margin = 1e-9, .on_event = weigh, .context = e};
        driven(name, &made->a[i], &made->b[i], &how);
    }
}

/// Steps an event, by size and separation.
typedef struct table {
    effort of[SIZES][POWERS];
} table;

static void fill(const char *const *names, size_t count, table *tables) {
    const size_t seeds = test_scaled(2);
    for (size_t seed = 1; seed <= seeds; ++seed) {
        pairs made = pairs_make(seed);
        for (size_t name = 0; name < count; ++name)
            for (size_t i = 0; i < SIZES; ++i)
                for (size_t k = 0; k < POWERS; ++k)
                    follow(names[name], &made, i, powers[k], seed, &tables[name].of[i][k]);
        pairs_destroy(&made);
    }
}

static double mean(const effort *e) {
    return e->steps / (double)e->events;
}

/// The exponent p of steps = factor * (log2 min{n, D/s})^p, by least squares of the logarithms, and the
/// factor.
static double fit(const table *t, double *factor) {
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (size_t i = 0; i < SIZES; ++i)
        for (size_t k = 0; k < POWERS; ++k) {
            const double u = log(fmin(log2((double)sizes[i]), powers[k])), v = log(mean(&t->of[i][k]));
            n += 1.0, x += u, y += v, xx += u * u, xy += u * v;
        }
    const double exponent = (n * xy - x * y) / (n * xx - x * x);
    *factor = exp((y - exponent * x) / n);
    return exponent;
}

/// How many times the steps grow from the fewest vertices to the most at equal separation, at most.
static double growth(const table *t) {
    double most = 0.0;
    for (size_t k = 0; k < POWERS_OUTSIDE; ++k)
        most = fmax(most, mean(&t->of[SIZES - 1][k]) / mean(&t->of[0][k]));
    return most;
}

static void print(const char *name, const table *t) {
    double most = 0.0, factor;
    for (size_t i = 0; i < SIZES; ++i)
        for (size_t k = 0; k < POWERS; ++k)
            most = fmax(most, t->of[i][k].most);
    const double exponent = fit(t, &factor);
    printf("%s: %.1f (log2 min{n, D/s})^%.2f steps an event, at most %.0f; x %.2f from n = 64 to 32768\n",
           name, factor, exponent, most, growth(t));
    for (size_t i = 0; i < SIZES; ++i)
        for (size_t k = 0; k < POWERS; ++k)
            printf("%s%5.1f%s", k ? ", " : "  ", mean(&t->of[i][k]), k + 1 < POWERS ? "" : "\n");
}

/// Theorem 5.2: translations: O(log min{n, D/s}) an event, O(log mu) or O(mu) events.
TEST(an_event_of_a_translation_costs_the_logarithm_of_n_or_the_separation) {
    const char *const names[] = {"lazy-compass", "lazy-dudley", "active-cell-compass", "active-cell-dudley",
                                 "inflated-translation"};
    table tables[COUNT_OF(names)] = {0};
    fill(names, COUNT_OF(names), tables);
    for (size_t i = 0; i < COUNT_OF(names); ++i) {
        const table t = tables[i];
        double factor;
        print(names[i], &t);
        assert_true(fit(&t, &factor) <= MOST_EXPONENT);
        assert_true(growth(&t) <= MOST_GROWTH);
        table squared = t; // control: what grows as the logarithm's square is noticed
        for (size_t k = 0; k < SIZES * POWERS; ++k)
            squared.of[k / POWERS][k % POWERS].steps *=
                pow(fmin(log2((double)sizes[k / POWERS]), powers[k % POWERS]), 2.0);
        assert_true(fit(&squared, &factor) > MOST_EXPONENT);
    }
}

/// Free directions and the windows look at the whole polygons: the logarithm of n.
TEST(an_event_of_a_free_direction_costs_the_logarithm_of_n) {
    const char *const names[] = {"free-fd2", "hybrid", "two-lines", "inflated-window"};
    table tables[COUNT_OF(names)] = {0};
    fill(names, COUNT_OF(names), tables);
    for (size_t i = 0; i < COUNT_OF(names); ++i) {
        const table t = tables[i];
        print(names[i], &t);
        assert_true(growth(&t) <= 4.0);
        if (i + 1 == COUNT_OF(names)) { // a window finds its level by the separation
            double factor;
            assert_true(fit(&t, &factor) <= MOST_EXPONENT);
        } else {
            assert_true(growth(&t) > MOST_GROWTH); // control: the test above could fail
        }
    }
}
