// SPDX-License-Identifier: MIT
// First roots of polynomials; GSL's error handler; and the queue of events against brute force.
#include <float.h>

#include "checks.h"
#include <gsl/gsl_errno.h>
#include <pthread.h>

#include "boomerang/failure.h"
#include "kinetic/event_queue.h"
#include "kinetic/roots.h"
#include "motions.h"
#include "polygons.h"

#define ROOT_TOLERANCE 1e-9

static double value_at(const double *coefficients, size_t degree, double t) {
    double value = coefficients[degree];
    for (size_t k = degree; k-- > 0;)
        value = value * t + coefficients[k];
    return value;
}

/// The reference: the first change of sign in [0, 1] over a fine grid, by no other means than evaluating.
/// INFINITY if none.
static double first_sign_change(const double *c, size_t degree, size_t cells) {
    for (size_t i = 1; i <= cells; ++i) {
        const double t = (double)i / (double)cells;
        if (!(value_at(c, degree, t) > 0.0))
            return t;
    }
    return (double)INFINITY;
}

TEST(no_change_of_sign_is_passed_over) {
    test_random random = test_random_from(20240229);
    const size_t trials = test_scaled(4000), cells = 512;
    size_t with_root = 0, without = 0;
    for (size_t trial = 0; trial < trials; ++trial) {
        const size_t degree = 1 + test_random_below(&random, 10);
        double c[11], found = (double)INFINITY;
        c[0] = test_random_uniform(&random, 0.01, 1.0);
        for (size_t k = 1; k <= degree; ++k)
            c[k] = test_random_uniform(&random, -1.0, 1.0);
        const bool is_found = bmr_bernstein_first_root(c, degree, 0.0, ROOT_TOLERANCE, &found);
        const double change = first_sign_change(c, degree, cells);
        assert_true(is_found == isfinite(found));
        // The first root lies before the first change that a grid sees: positive until there, and not after.
        assert_true(found < change || (!is_found && isinf(change)));
        with_root += is_found;
        without += !is_found;
        if (is_found)
            assert_true(value_at(c, degree, found) > 0.0 &&
                        value_at(c, degree, found) <= 100.0 * ROOT_TOLERANCE);
    }
    assert_true(with_root > trials / 10 && without > trials / 10);
}

static int handler_calls = 0;
static void counting_handler(const char *reason, const char *file, int line, int gsl_errno) {
    (void)reason, (void)file, (void)line, (void)gsl_errno;
    ++handler_calls;
}

#define THREADS 4

/// A spin past a line, whose failure GSL's solver finds.
static void *solve_many(void *argument) {
    const size_t rounds = test_scaled(2000);
    const double target = *(const double *)argument;
    own_motion *still = made_motion(bmr_piece_rest(bmr_pose_identity())),
               *spins = made_motion(
                   bmr_piece_screw(0.0, bmr_pose_identity(), bmr_vec2_make(0.0, 0.0), 1.0 / target));
    const bmr_condition k =
        bmr_condition_beyond(0, bmr_vec2_make(1.0, 0.0), cos(1.0), bmr_vec2_make(1.0, 0.0), 0);
    const bmr_failure_options options = bmr_default_failure_options();
    for (size_t i = 0; i < rounds; ++i) {
        double time = 0.0;
        if (bmr_failure_time(&k, still, spins, 0.0, 1.0, &options, &time) != BMR_OK ||
            !(fabs(time - target) < ROOT_TOLERANCE))
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
    test_random random = test_random_from(5);
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
