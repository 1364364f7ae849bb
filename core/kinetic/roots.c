// SPDX-License-Identifier: MIT
#include "kinetic/roots.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <pthread.h>
#include <string.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_poly.h>

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

/// From a bracket with one root: positive at `low`, not at `high`.
static double narrow(const double *c, size_t n, double low, double high, double tolerance) {
    double x = low + 0.5 * (high - low);
    for (int step = 0; step < NEWTON_STEPS; step++) {
        double value = c[n], slope = 0.0;
        for (size_t k = n; k-- > 0;) {
            slope = slope * x + value;
            value = value * x + c[k];
        }
        if (value > 0.0)
            low = x;
        else
            high = x;
        const double width = resolution(high, tolerance);
        if (high - low <= width)
            break;
        double next = x - value / slope;
        // Close to the root the steps stay on one side of it; half a width further brackets it.
        if (fabs(next - x) <= 0.5 * width)
            next += value > 0.0 ? 0.5 * width : -0.5 * width;
        x = next > low && next < high ? next : low + 0.5 * (high - low);
    }
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

// ---- all complex roots, by GSL ----

// A leading term this much smaller than the largest coefficient is dropped: on [-1, 1], where the solver
// works, it is below the rounding error of any evaluation, and dropping it keeps the solver's quotients far
// from overflow.
#define NEGLIGIBLE 1.2325951644078309e-32 /* 2^-106: the square of a rounding error */

// How many Newton steps polish a root of the solver. From its accuracy (half the digits at worst, at a double
// root) two would do; a step that does not improve ends it anyway.
#define POLISH_STEPS 8

// Halvings that take an interval of [-1, 1] to neighbouring doubles, except next to zero, where 2^-1074 is
// near enough.
#define BISECTION_STEPS 1100

/// The polynomial in u = t / 2^exponent, which is in [-1, 1] for all t asked for; largest coefficient in [1,
/// 2).
typedef struct scaled_polynomial {
    double c[BMR_POLYNOMIAL_MAX_DEGREE + 1];
    size_t degree;
    int exponent;
} scaled_polynomial;

typedef struct polynomial_value {
    double value, slope, curvature; ///< p, p', p''/2
    double error;                   ///< bound of the rounding error of `value`
} polynomial_value;

static polynomial_value evaluate(const scaled_polynomial *p, double u) {
    polynomial_value v = {p->c[p->degree], 0.0, 0.0, fabs(p->c[p->degree])};
    for (size_t k = p->degree; k-- > 0;) {
        v.curvature = v.curvature * u + v.slope;
        v.slope = v.slope * u + v.value;
        v.value = v.value * u + p->c[k];
        v.error = v.error * fabs(u) + fabs(p->c[k]);
    }
    // Horner's rule errs by at most gamma_(2 degree) times the sum of magnitudes; u itself, a rounded root,
    // by `degree` more roundings; one more degree for the sum's own error.
    v.error *= (4.0 * (double)p->degree + 4.0) * (DBL_EPSILON / 2.0);
    return v;
}

static bool is_zero(polynomial_value v) {
    return fabs(v.value) <= v.error;
}

/// False when every coefficient is zero.
static bool scale_polynomial(const double *coefficients, size_t degree, double reach, scaled_polynomial *p) {
    // ilogb is exact, so u = t / 2^exponent is too.
    p->exponent = reach > 0.0 ? ilogb(reach) + 1 : 0;
    int largest = INT_MIN;
    for (size_t k = 0; k <= degree; ++k) {
        if (coefficients[k] != 0.0) {
            const int e = ilogb(coefficients[k]) + (int)k * p->exponent;
            if (e > largest)
                largest = e;
        }
    }
    if (largest == INT_MIN)
        return false;
    for (size_t k = 0; k <= degree; ++k)
        p->c[k] = ldexp(coefficients[k], (int)k * p->exponent - largest);
    p->degree = degree;
    while (p->degree > 0 && fabs(p->c[p->degree]) <= NEGLIGIBLE)
        --p->degree;
    return true;
}

/// Newton's method towards a zero of p (`order` 0) or of p' (`order` 1) as long as it helps.
static double polish(const scaled_polynomial *p, double u, int order) {
    double best = INFINITY, kept = u;
    for (int step = 0; step < POLISH_STEPS; ++step) {
        const polynomial_value v = evaluate(p, u);
        const double value = order == 0 ? v.value : v.slope;
        const double slope = order == 0 ? v.slope : 2.0 * v.curvature;
        if (!(fabs(value) < best))
            break;
        best = fabs(value);
        kept = u;
        u -= value / slope;
    }
    return kept;
}

/// The least zero in [low, high] of the candidates that a root of the solver suggests; `first` if none is
/// less.
static double consider(const scaled_polynomial *p, double real, double low, double high, double first) {
    // A double root comes out as two roots half the digits away, real or complex: the extremum between them
    // is it.
    const double candidates[] = {real, polish(p, real, 0), polish(p, real, 1)};
    for (size_t i = 0; i < sizeof candidates / sizeof candidates[0]; ++i) {
        const double u = candidates[i];
        if (u >= low && u <= high && u < first && is_zero(evaluate(p, u)))
            first = u;
    }
    return first;
}

/// A zero between two arguments at which p has different signs.
static double bisect(const scaled_polynomial *p, double low, double high) {
    const bool positive = evaluate(p, low).value > 0.0;
    for (int step = 0; step < BISECTION_STEPS; ++step) {
        const double middle = low + (high - low) / 2.0;
        if (middle <= low || middle >= high)
            break;
        if ((evaluate(p, middle).value > 0.0) == positive)
            low = middle;
        else
            high = middle;
    }
    return high;
}

/// All complex roots; `roots` takes 2 * degree numbers, real and imaginary parts. False if they were not
/// found.
static bool solve(const scaled_polynomial *p, double *roots, size_t *count) {
    if (p->degree <= 2) {
        gsl_complex pair[2];
        const double a = p->degree == 2 ? p->c[2] : 0.0, b = p->degree >= 1 ? p->c[1] : 0.0;
        const int found = gsl_poly_complex_solve_quadratic(a, b, p->c[0], &pair[0], &pair[1]);
        *count = found > 0 ? (size_t)found : 0;
        for (size_t i = 0; i < *count; ++i) {
            roots[2 * i] = GSL_REAL(pair[i]);
            roots[2 * i + 1] = GSL_IMAG(pair[i]);
        }
        return true;
    }
    // A workspace is no more than a square matrix; on the stack it needs no allocation that could fail.
    double matrix[BMR_POLYNOMIAL_MAX_DEGREE * BMR_POLYNOMIAL_MAX_DEGREE];
    gsl_poly_complex_workspace workspace = {p->degree, matrix};
    bmr_gsl_guard_enter();
    const int status = gsl_poly_complex_solve(p->c, p->degree + 1, &workspace, roots);
    bmr_gsl_guard_leave();
    *count = p->degree;
    return status == GSL_SUCCESS;
}

bmr_error bmr_polynomial_first_root(const double *coefficients, size_t degree, double from, double to,
                                    double *root) {
    if (!coefficients || !root)
        return BMR_ERROR_NULL_ARGUMENT;
    if (degree > BMR_POLYNOMIAL_MAX_DEGREE)
        return BMR_ERROR_OUT_OF_RANGE;
    for (size_t k = 0; k <= degree; ++k) {
        if (!isfinite(coefficients[k]))
            return BMR_ERROR_NOT_FINITE;
    }
    if (!isfinite(from) || !isfinite(to))
        return BMR_ERROR_NOT_FINITE;
    if (from > to)
        return BMR_ERROR_OUT_OF_RANGE;

    scaled_polynomial p;
    if (!scale_polynomial(coefficients, degree, fmax(fabs(from), fabs(to)), &p)) {
        *root = from;
        return BMR_OK;
    }
    const double low = ldexp(from, -p.exponent), high = ldexp(to, -p.exponent);
    const polynomial_value at_low = evaluate(&p, low), at_high = evaluate(&p, high);
    if (is_zero(at_low)) {
        *root = from;
        return BMR_OK;
    }

    double roots[2 * BMR_POLYNOMIAL_MAX_DEGREE];
    size_t count = 0;
    if (!solve(&p, roots, &count))
        return BMR_ERROR_OUT_OF_RANGE;
    double first = is_zero(at_high) ? high : INFINITY;
    for (size_t i = 0; i < count; ++i)
        first = consider(&p, roots[2 * i], low, high, first);
    // Different signs at the ends prove a root, also where the solver reports none.
    if (first > high && (at_low.value > 0.0) != (at_high.value > 0.0))
        first = bisect(&p, low, high);
    *root = first > high ? INFINITY : ldexp(first, p.exponent);
    return BMR_OK;
}
