// SPDX-License-Identifier: MIT
#include <float.h>

#include "checks.h"
#include <gsl/gsl_errno.h>
#include <gsl/gsl_rng.h>
#include <pthread.h>

#include "boomerang/motion.h"
#include "kinetic/first_root.h"

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

TEST(the_first_of_known_roots_is_found) {
    const double roots[] = {0.75, -0.5, 0.25, 2.0};
    double c[5];
    expand(roots, 4, c);
    assert_true(fabs(first_root(c, 4, -1.0, 1.0) + 0.5) < ROOT_TOLERANCE);
    assert_true(fabs(first_root(c, 4, 0.0, 1.0) - 0.25) < ROOT_TOLERANCE);
    assert_true(fabs(first_root(c, 4, 0.5, 3.0) - 0.75) < ROOT_TOLERANCE);
    assert_true(fabs(first_root(c, 4, 1.0, 3.0) - 2.0) < ROOT_TOLERANCE);
    assert_true(isinf(first_root(c, 4, 1.0, 1.5)));
}

TEST(ends_of_the_interval_belong_to_it) {
    const double line[] = {-0.25, 1.0};
    assert_true(first_root(line, 1, 0.25, 9.0) == 0.25);
    assert_true(first_root(line, 1, -9.0, 0.25) == 0.25);
    assert_true(first_root(line, 1, 0.25, 0.25) == 0.25);
    // The control: a little beside it there is none.
    assert_true(isinf(first_root(line, 1, 0.2500001, 9.0)));
    assert_true(isinf(first_root(line, 1, -9.0, 0.2499999)));
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

TEST(no_real_root_is_no_root) {
    const double square_plus_one[] = {1.0, 0.0, 1.0};
    assert_true(isinf(first_root(square_plus_one, 2, -100.0, 100.0)));
    const double fourth[] = {1.0, 0.0, 0.0, 0.0, 1.0};
    assert_true(isinf(first_root(fourth, 4, -100.0, 100.0)));
}

TEST(constants_and_the_zero_polynomial_are_legal) {
    const double zeros[] = {0.0, 0.0, 0.0}, constant[] = {-2.0, 0.0, 0.0};
    assert_true(first_root(zeros, 2, 3.0, 4.0) == 3.0);
    assert_true(first_root(zeros, 0, 3.0, 4.0) == 3.0);
    assert_true(isinf(first_root(constant, 2, 3.0, 4.0)));
    assert_true(isinf(first_root(constant, 0, 3.0, 4.0)));
}

TEST(extreme_coefficients_neither_hang_nor_overflow) {
    // 1e-300 t^4 + t - 0.5: the leading term means nothing here.
    const double tiny_leader[] = {-0.5, 1.0, 0.0, 0.0, 1e-300};
    assert_true(fabs(first_root(tiny_leader, 4, 0.0, 1.0) - 0.5) < ROOT_TOLERANCE);
    const double huge[] = {-0.5e308, 0.0, 0.0, 1e308};
    assert_true(fabs(first_root(huge, 3, 0.0, 1.0) - cbrt(0.5)) < ROOT_TOLERANCE);
    const double small[] = {-0.5e-300, 0.0, 0.0, 1e-300};
    assert_true(fabs(first_root(small, 3, 0.0, 1.0) - cbrt(0.5)) < ROOT_TOLERANCE);
    // t^3 - 1e300 on a wide interval, and around zero alone.
    const double wide[] = {-1e300, 0.0, 0.0, 1.0};
    assert_true(fabs(first_root(wide, 3, 0.0, 1e150) / 1e100 - 1.0) < ROOT_TOLERANCE);
    assert_true(isinf(first_root(wide, 3, -1.0, 1.0)));
    const double at_zero[] = {0.0, 1.0, 1.0, 1.0};
    assert_true(first_root(at_zero, 3, 0.0, 0.0) == 0.0);
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
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(rng, 20240229);
    const size_t trials = test_scaled(4000), cells = 512;
    size_t with_root = 0, without = 0, later = 0;
    for (size_t trial = 0; trial < trials; ++trial) {
        const size_t degree = 1 + gsl_rng_uniform_int(rng, 10);
        double c[11];
        for (size_t k = 0; k <= degree; ++k)
            c[k] = 2.0 * gsl_rng_uniform(rng) - 1.0;
        const double from = -2.0 * gsl_rng_uniform(rng), to = 2.0 * gsl_rng_uniform(rng);
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
    gsl_rng_free(rng);
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
