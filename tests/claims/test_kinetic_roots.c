// SPDX-License-Identifier: MIT
// First roots of polynomials, by GSL and by subdivision; and the queue of events against brute force.
#include <float.h>

#include "checks.h"
#include <gsl/gsl_errno.h>
#include <pthread.h>

#include "boomerang/motion.h"
#include "kinetic/event_queue.h"
#include "kinetic/roots.h"
#include "polygons.h"

#define ROOT_TOLERANCE 1e-9

/// The coefficients of the product of (t - roots[i]).
static void expand(const double *roots, size_t count, double *coefficients) {
    coefficients[0] = 1.0;
    for (size_t n = 0; n < count; ++n) {
        coefficients[n + 1] = coefficients[n];
        for (size_t k = n; k > 0; --k)
            coefficients[k] = coefficients[k - 1] - roots[n] * coefficients[k];
        coefficients[0] *= -roots[n];
    }
}

static double value_at(const double *coefficients, size_t degree, double t) {
    double value = coefficients[degree];
    for (size_t k = degree; k-- > 0;)
        value = value * t + coefficients[k];
    return value;
}

static double first_root(const double *coefficients, size_t degree, double from, double to) {
    double root = -12345.0;
    assert_int_equal(bmr_polynomial_first_root(coefficients, degree, from, to, &root), BMR_OK);
    assert_true(root != -12345.0);
    return root;
}

TEST(the_first_of_known_roots_is_found_and_the_ends_belong_to_the_interval) {
    const double none = (double)INFINITY, third = cbrt(0.5);
    const struct {
        size_t degree;
        double c[5], from, to, root;
    } cases[] = {{4,
                  {0.1875, -0.71875, -0.6875, 2.5, -1.0},
                  -1.0,
                  1.0,
                  -0.5}, // -(t - 3/4) (t + 1/2) (t - 1/4) (t - 2)
                 {4, {0.1875, -0.71875, -0.6875, 2.5, -1.0}, 0.0, 1.0, 0.25},
                 {4, {0.1875, -0.71875, -0.6875, 2.5, -1.0}, 0.5, 3.0, 0.75},
                 {4, {0.1875, -0.71875, -0.6875, 2.5, -1.0}, 1.0, 3.0, 2.0},
                 {4, {0.1875, -0.71875, -0.6875, 2.5, -1.0}, 1.0, 1.5, none},
                 {1, {-0.25, 1.0}, 0.25, 9.0, 0.25},
                 {1, {-0.25, 1.0}, -9.0, 0.25, 0.25},
                 {1, {-0.25, 1.0}, 0.25, 0.25, 0.25},
                 {1, {-0.25, 1.0}, 0.2500001, 9.0, none},
                 {1, {-0.25, 1.0}, -9.0, 0.2499999, none},
                 {2, {1.0, 0.0, 1.0}, -100.0, 100.0, none},
                 {4, {1.0, 0.0, 0.0, 0.0, 1.0}, -100.0, 100.0, none},
                 {2, {0.0}, 3.0, 4.0, 3.0}, // zero everywhere
                 {0, {0.0}, 3.0, 4.0, 3.0},
                 {2, {-2.0}, 3.0, 4.0, none},
                 {0, {-2.0}, 3.0, 4.0, none},
                 {4, {-0.5, 1.0, 0.0, 0.0, 1e-300}, 0.0, 1.0, 0.5}, // the leading term means nothing here
                 {3, {-0.5e308, 0.0, 0.0, 1e308}, 0.0, 1.0, third},
                 {3, {-0.5e-300, 0.0, 0.0, 1e-300}, 0.0, 1.0, third},
                 {3, {-1e300, 0.0, 0.0, 1.0}, 0.0, 1e150, 1e100},
                 {3, {-1e300, 0.0, 0.0, 1.0}, -1.0, 1.0, none},
                 {3, {0.0, 1.0, 1.0, 1.0}, 0.0, 0.0, 0.0}};
    for (size_t i = 0; i < COUNT_OF(cases); ++i) {
        const double found = first_root(cases[i].c, cases[i].degree, cases[i].from, cases[i].to),
                     root = cases[i].root;
        if (!(found == root || fabs(found - root) <= ROOT_TOLERANCE * fmax(1.0, fabs(root))))
            fail_msg("case %zu: %.17g is not %.17g", i, found, root);
    }
}

TEST(a_polynomial_that_only_touches_zero_counts) {
    for (size_t multiplicity = 2; multiplicity <= 4; multiplicity += 2) {
        double roots[6] = {0.3, 0.3, 0.3, 0.3}, c[7], lifted;
        roots[multiplicity] = -2.0;
        roots[multiplicity + 1] = -3.0;
        expand(roots, multiplicity + 2, c);
        assert_true(fabs(first_root(c, multiplicity + 2, 0.0, 1.0) - 0.3) < 1e-3);
        // The control: lifted by far more than rounding, it touches no longer.
        lifted = c[0];
        c[0] = lifted + 1e-6;
        assert_true(isinf(first_root(c, multiplicity + 2, 0.0, 1.0)));
    }
}

/// The reference: the first change of sign over a fine grid, by no other means than evaluating. INFINITY if
/// none.
static double first_sign_change(const double *c, size_t degree, double from, double to, size_t cells) {
    double last = value_at(c, degree, from);
    for (size_t i = 1; i <= cells; ++i) {
        const double t = from + (to - from) * ((double)i / (double)cells);
        const double value = value_at(c, degree, t);
        if ((value > 0.0) != (last > 0.0))
            return t;
        last = value;
    }
    return (double)INFINITY;
}

TEST(no_change_of_sign_is_passed_over) {
    test_random random = {20240229};
    const size_t trials = test_scaled(4000), cells = 512;
    size_t with_root = 0, without = 0, later = 0;
    for (size_t trial = 0; trial < trials; ++trial) {
        const size_t degree = 1 + test_random_below(&random, 10);
        double c[11];
        for (size_t k = 0; k <= degree; ++k)
            c[k] = test_random_uniform(&random, -1.0, 1.0);
        const double from = test_random_uniform(&random, -2.0, 0.0),
                     to = test_random_uniform(&random, 0.0, 2.0);
        const double found = first_root(c, degree, from, to);
        const double change = first_sign_change(c, degree, from, to, cells);
        // The first root lies at or before the first change that a grid sees.
        assert_true(found <= change);
        if (isinf(found)) {
            ++without;
            continue;
        }
        ++with_root;
        assert_true(found >= from && found <= to);
        assert_true(fabs(value_at(c, degree, found)) < 1e-11);
        // The control: the SECOND root would fail the comparison above, where there is one.
        if (found < to) {
            const double second = first_root(c, degree, fmin(found + 1e-6, to), to);
            later += second > change && !isinf(change);
        }
    }
    assert_true(with_root > trials / 10 && without > trials / 10 && later > trials / 100);
}

static int handler_calls = 0;
static void counting_handler(const char *reason, const char *file, int line, int gsl_errno) {
    (void)reason, (void)file, (void)line, (void)gsl_errno;
    ++handler_calls;
}

#define THREADS 4

static void *solve_many(void *argument) {
    const size_t rounds = test_scaled(2000);
    const double target = *(const double *)argument;
    double c[6], root = 0.0;
    const double roots[] = {target, 2.0, 3.0, -1.0, -2.0};
    expand(roots, 5, c);
    for (size_t i = 0; i < rounds; ++i) {
        if (bmr_polynomial_first_root(c, 5, 0.0, 1.0, &root) != BMR_OK ||
            !(fabs(root - target) < ROOT_TOLERANCE))
            return argument;
    }
    return NULL;
}

TEST(calls_on_many_threads_keep_the_handler) {
    gsl_error_handler_t *const before = gsl_set_error_handler(counting_handler);
    pthread_t threads[THREADS];
    double targets[THREADS];
    for (int i = 0; i < THREADS; ++i) {
        targets[i] = 0.125 * (i + 1);
        assert_int_equal(pthread_create(&threads[i], NULL, solve_many, &targets[i]), 0);
    }
    for (int i = 0; i < THREADS; ++i) {
        void *failed = NULL;
        assert_int_equal(pthread_join(threads[i], &failed), 0);
        assert_null(failed);
    }
    assert_true(gsl_set_error_handler(before) == counting_handler);
    assert_int_equal(handler_calls, 0);
}

// ---- parts of other searches ----

TEST(roots_nearer_than_the_tolerance_are_one) {
    // -(u - r) (u - r - e) (u - r + e), three roots closer than a part can be told: found, not counted.
    const double r = 0.3, e = 1e-7, c[] = {r * r * r - r * e * e, e * e - 3.0 * r * r, 3.0 * r, -1.0};
    double low = -1.0;
    assert_true(bmr_bernstein_first_root(c, 3, 0.0, 1e-4, &low));
    assert_true(low <= r && low + 1e-4 >= r - e);
    // It touches zero and never is below: with no noise asked for, the parts at the touch are too short in
    // the end.
    const double touch[] = {0.09, -0.6, 1.0};
    assert_false(bmr_bernstein_first_root(touch, 2, 0.0, 1e-4, &low));
    // The control: lowered a little, it has a root.
    const double lowered[] = {0.09 - 1e-4, -0.6, 1.0};
    assert_true(bmr_bernstein_first_root(lowered, 2, 0.0, 1e-4, &low));
    assert_true(fabs(low - 0.29) < 1e-3);
}

#define ITEMS 13

static bool comes_first(const bmr_event_item *a, const bmr_event_item *b) {
    return a < b;
}

TEST(the_queue_has_the_earliest_on_top_however_times_change) {
    double times[ITEMS];
    bmr_event_item items[ITEMS];
    bmr_event_entry heap[ITEMS];
    bmr_event_queue queue = {.heap = heap, .capacity = ITEMS, .before = comes_first};
    for (size_t i = 0; i < ITEMS; i++) {
        items[i].place = BMR_NOT_QUEUED;
        times[i] = INFINITY;
    }
    assert_true(bmr_event_queue_time(&queue) == INFINITY);
    test_random random = {5};
    for (int round = 0; round < 2000; round++) {
        const size_t item = (size_t)test_random_below(&random, ITEMS);
        const size_t time = (size_t)test_random_below(&random, 40); // ties, too
        times[item] = time < 36 ? (double)time : INFINITY;
        bmr_event_queue_set(&queue, &items[item], times[item]);
        size_t first = 0, queued = times[0] < INFINITY;
        for (size_t i = 1; i < ITEMS; i++) {
            queued += times[i] < INFINITY;
            if (times[i] < times[first])
                first = i;
        }
        assert_int_equal(queue.count, queued);
        assert_true(bmr_event_queue_time(&queue) == times[first]);
        assert_true(queued == 0 || queue.heap[0].item == &items[first]);
    }
}
