// SPDX-License-Identifier: MIT
#include <math.h>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>

#include "boomerang/analysis.h"
#include "kinetic/roots.h"

/// Of a two-sided 95 % interval.
#define QUANTILE 0.975
/// Points are collected on the stack: tables have some ten.
#define MOST_POINTS 256

typedef struct line {
    double offset, slope, slope_error;
} line;

static line fit(const double *x, const double *y, size_t count) {
    line l;
    double cov00, cov01, cov11, sum;
    gsl_fit_linear(x, 1, y, 1, count, &l.offset, &l.slope, &cov00, &cov01, &cov11, &sum);
    // GSL scales the covariance by the residuals' variance; two points have none.
    l.slope_error = count > 2 ? gsl_cdf_tdist_Pinv(QUANTILE, (double)(count - 2)) * sqrt(cov11) : INFINITY;
    return l;
}

static bool has_two_arguments(const double *x, size_t count) {
    for (size_t k = 1; k < count; k++)
        if (x[k] != x[0])
            return true;
    return false;
}

bmr_error bmr_fit_growth(const double *x, const double *y, size_t count, bmr_growth *growth) {
    if (!x || !y || !growth)
        return BMR_ERROR_NULL_ARGUMENT;
    double log_x[MOST_POINTS], positive_x[MOST_POINTS], log_y[MOST_POINTS];
    size_t positive = 0;
    if (count > MOST_POINTS)
        return BMR_ERROR_OUT_OF_RANGE;
    for (size_t k = 0; k < count; k++) {
        if (!isfinite(x[k]) || !isfinite(y[k]))
            return BMR_ERROR_NOT_FINITE;
        if (!(x[k] > 0.0) || y[k] < 0.0)
            return BMR_ERROR_OUT_OF_RANGE;
        log_x[k] = log2(x[k]);
        if (y[k] > 0.0) {
            positive_x[positive] = log_x[k];
            log_y[positive++] = log2(y[k]);
        }
    }
    if (!has_two_arguments(positive_x, positive))
        return BMR_ERROR_OUT_OF_RANGE;
    bmr_gsl_guard_enter();
    const line power = fit(positive_x, log_y, positive), steps = fit(log_x, y, count);
    bmr_gsl_guard_leave();
    double power_sum = 0.0, log_sum = 0.0;
    for (size_t k = 0; k < count; k++) {
        const double by_power = exp2(power.offset + power.slope * log_x[k]);
        const double by_log = steps.offset + steps.slope * log_x[k];
        const double power_off = (y[k] - by_power) / fmax(by_power, 1.0),
                     log_off = (y[k] - by_log) / fmax(by_log, 1.0);
        power_sum += power_off * power_off;
        log_sum += log_off * log_off;
    }
    growth->exponent = power.slope;
    growth->exponent_error = power.slope_error;
    growth->constant = exp2(power.offset);
    growth->slope = steps.slope;
    growth->slope_error = steps.slope_error;
    growth->offset = steps.offset;
    growth->power_residual = sqrt(power_sum / (double)count);
    growth->log_residual = sqrt(log_sum / (double)count);
    growth->logarithmic = growth->log_residual < growth->power_residual;
    growth->count = count;
    return BMR_OK;
}
