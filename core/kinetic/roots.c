// SPDX-License-Identifier: MIT
#include "kinetic/roots.h"

#include <float.h>
#include <math.h>
#include <pthread.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

// ---- GSL's error handler ----

// The library's only mutable globals, because GSL's handler is one: without the count, two calls at once
// could end with the handler off for ever, or on while one of them still runs.
static pthread_mutex_t guard_lock = PTHREAD_MUTEX_INITIALIZER;
static unsigned guard_inside = 0;
static gsl_error_handler_t *guard_outer = NULL;

void bmr_gsl_guard_enter(void) {
    pthread_mutex_lock(&guard_lock);
    if (guard_inside++ == 0)
        guard_outer = gsl_set_error_handler_off();
    pthread_mutex_unlock(&guard_lock);
}

void bmr_gsl_guard_leave(void) {
    pthread_mutex_lock(&guard_lock);
    if (--guard_inside == 0)
        gsl_set_error_handler(guard_outer);
    pthread_mutex_unlock(&guard_lock);
}

// ---- subdivision in the Bernstein basis ----

/// The most halvings of [0, 1]: after so many, both ends of a part near 1 are neighbouring doubles.
#define MAX_DEPTH 53

/// The most steps towards one root. Newton's method, with bisection where it would leave the bracket, ends
/// long before.
#define NEWTON_STEPS 200

/// Room for the state of gsl_root_fdfsolver_newton (two doubles in GSL 2): on the stack nothing can fail.
#define NEWTON_DOUBLES 16

typedef struct part {
    double low, width;
    double b[BMR_POLYNOMIAL_MAX_DEGREE + 1];
} part;

/// Two arguments near u that differ by less than this count as one.
static double resolution(double u, double tolerance) {
    return fmax(tolerance, 4.0 * DBL_EPSILON * u);
}

/// b_j = sum over k <= j of C(j, k) / C(n, k) c_k, by a triangle of additions.
static void to_bernstein(const double *c, size_t n, double *b) {
    double binomial = 1.0;
    for (size_t k = 0; k <= n; k++) {
        b[k] = c[k] / binomial;
        binomial = binomial * (double)(n - k) / (double)(k + 1);
    }
    for (size_t i = 0; i < n; i++)
        for (size_t j = n; j > i; j--)
            b[j] += b[j - 1];
}

/// De Casteljau at the middle: `left` becomes its own left half, and `right` the right one.
static void halve(part *left, size_t n, part *right) {
    left->width *= 0.5;
    right->width = left->width;
    right->low = left->low + left->width;
    right->b[n] = left->b[n];
    for (size_t i = 1; i <= n; i++) {
        for (size_t j = n; j >= i; j--)
            left->b[j] = 0.5 * (left->b[j - 1] + left->b[j]);
        right->b[n - i] = left->b[n];
    }
}

typedef struct polynomial {
    const double *c;
    size_t degree;
} polynomial;

static void value_and_slope(double x, void *context, double *value, double *slope) {
    const polynomial *p = context;
    *value = p->c[p->degree];
    *slope = 0.0;
    for (size_t k = p->degree; k-- > 0;) {
        *slope = *slope * x + *value;
        *value = *value * x + p->c[k];
    }
}

static double value_at(double x, void *context) {
    const polynomial *p = context;
    return bmr_polynomial_value(p->c, p->degree, x);
}

static double slope_at(double x, void *context) {
    double value, slope;
    value_and_slope(x, context, &value, &slope);
    return slope;
}

/// Where Newton's method goes from x; not a number where the slope is zero.
static double newton_step(gsl_function_fdf *function, double x) {
    double state[NEWTON_DOUBLES];
    gsl_root_fdfsolver solver = {gsl_root_fdfsolver_newton, NULL, 0.0, state};
    return gsl_root_fdfsolver_newton->size <= sizeof state &&
                   gsl_root_fdfsolver_set(&solver, function, x) == GSL_SUCCESS &&
                   gsl_root_fdfsolver_iterate(&solver) == GSL_SUCCESS
               ? solver.root
               : NAN;
}

/// From a bracket with one root: positive at `low`, not at `high`. Newton's method, from GSL.
static double narrow(const double *c, size_t n, double low, double high, double tolerance) {
    polynomial p = {c, n};
    gsl_function_fdf function = {value_at, slope_at, value_and_slope, &p};
    double x = low + 0.5 * (high - low);
    bmr_gsl_guard_enter();
    for (int step = 0; step < NEWTON_STEPS; step++) {
        const double value = value_at(x, &p);
        if (value > 0.0)
            low = x;
        else
            high = x;
        const double width = resolution(high, tolerance);
        if (high - low <= width)
            break;
        double next = newton_step(&function, x);
        // Close to the root the steps stay on one side of it; half a width further brackets it.
        if (fabs(next - x) <= 0.5 * width)
            next += value > 0.0 ? 0.5 * width : -0.5 * width;
        x = next > low && next < high ? next : low + 0.5 * (high - low);
    }
    bmr_gsl_guard_leave();
    return low;
}

/// Changes from positive to not positive and back.
static int sign_changes(const double *b, size_t n) {
    int changes = 0;
    for (size_t j = 1; j <= n; j++)
        changes += (b[j] > 0.0) != (b[j - 1] > 0.0);
    return changes;
}

static double least(const double *b, size_t n) {
    double low = b[0];
    for (size_t j = 1; j <= n; j++)
        low = fmin(low, b[j]);
    return low;
}

bool bmr_bernstein_first_root(const double *c, size_t n, double noise, double tolerance, double *low) {
    part stack[MAX_DEPTH + 1]; // the parts still to be looked at, the leftmost on top
    size_t height = 1;
    stack[0].low = 0.0;
    stack[0].width = 1.0;
    to_bernstein(c, n, stack[0].b);
    while (height > 0) {
        part *top = &stack[height - 1];
        const bool ends_positive = top->b[n] > 0.0;
        const double lowest = least(top->b, n);
        if (lowest > 0.0 || (ends_positive && top->b[0] > 0.0 && lowest >= -noise)) {
            height--;
            continue;
        }
        if (!ends_positive && top->b[0] > 0.0 && sign_changes(top->b, n) == 1) {
            *low = narrow(c, n, top->low, top->low + top->width, tolerance);
            return true;
        }
        if (height > MAX_DEPTH || top->width <= resolution(top->low, tolerance)) {
            if (!ends_positive || !(top->b[0] > 0.0)) {
                *low = top->low;
                return true;
            }
            height--;
            continue;
        }
        part right;
        halve(top, n, &right);
        if (top->b[n] > 0.0) { // else the left half has a root, and the right one is of no interest
            stack[height] = *top;
            stack[height - 1] = right;
            height++;
        }
    }
    return false;
}
