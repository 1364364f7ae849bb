// SPDX-License-Identifier: MIT
#include "kinetic/failure.h"

#include <float.h>
#include <math.h>

/// Doubles near 1 are 2e-16 apart, so that this leaves more than three digits of room.
#define DEFAULT_TOLERANCE 1e-12

/// A condition that stays at zero for this long, times max(1, |time|), has failed: it is called flat.
#define LONG_TIME 1024.0

/// A leading term is dropped when over the whole interval it adds less than this part of the rounding error.
#define NEGLIGIBLE_PART 0x1p-10

/// A condition that is still positive where it was to fail is followed for so many doublings of the
/// tolerance: 2^10 tolerances is more than the rounding of any value lasts.
#define NUDGES 10

bmr_failure_options bmr_default_failure_options(void) {
    const bmr_failure_options options = {BMR_ROOT_BERNSTEIN, DEFAULT_TOLERANCE};
    return options;
}

static double horner(const bmr_condition_polynomial *p, double u) {
    double value = p->c[p->degree];
    for (size_t k = p->degree; k-- > 0;)
        value = value * u + p->c[k];
    return value;
}

typedef enum beginning { POSITIVE, GROWING, FAILING, BELOW, FLAT } beginning;

/// What the polynomial does right after 0. GROWING: its first `*zeros` coefficients are zero up to rounding,
/// and the next is positive. BELOW: definitely negative. FLAT: all are zero up to rounding, and the first is
/// not positive.
static beginning begin(const bmr_condition_polynomial *p, size_t *zeros) {
    const double zero = BMR_START_NOISES * p->noise;
    *zeros = 0;
    if (p->c[0] > zero)
        return POSITIVE;
    if (p->c[0] < -zero)
        return BELOW;
    for (size_t k = 1; k <= p->degree; k++) {
        if (fabs(p->c[k]) > zero) {
            *zeros = k;
            return p->c[k] > 0.0 ? GROWING : FAILING;
        }
    }
    return p->c[0] > 0.0 ? POSITIVE : FLAT;
}

/// For a condition that is flat over an interval: is it flat, or does it fall, over a much longer one, too?
/// (An interval may have been cut short for the sake of other terms.)
static bool stays_flat(const bmr_condition *condition, const bmr_motion_piece *owner,
                       const bmr_motion_piece *other, double from) {
    bmr_condition_polynomial p;
    bmr_condition_expand(condition, owner, other, from, LONG_TIME * fmax(1.0, fabs(from)), &p);
    size_t zeros;
    const beginning start = begin(&p, &zeros);
    return start == FLAT || start == FAILING;
}

/// The first root of the coefficients from `zeros` on: dividing by u^zeros leaves the sign, and takes away
/// the root at the beginning.
static bmr_error first_root(const bmr_condition_polynomial *p, size_t zeros,
                            const bmr_failure_options *options, double tolerance, double *u) {
    const double *c = p->c + zeros, part = tolerance / p->width;
    size_t degree = p->degree - zeros;
    while (degree > 0 && fabs(c[degree]) <= NEGLIGIBLE_PART * p->noise)
        degree--;
    *u = INFINITY;
    if (options->method == BMR_ROOT_BERNSTEIN) {
        if (!bmr_bernstein_first_root(c, degree, p->noise, part, u))
            *u = INFINITY;
        return BMR_OK;
    }
    const bmr_error error = bmr_polynomial_first_root(c, degree, 0.0, 1.0, u);
    // GSL's root is on either side of the true one.
    *u = fmax(0.0, *u - 0.5 * part);
    return error;
}

/// from + u width, rounded towards `from`.
static double at_part(double from, double u, double width) {
    const double time = from + u * width;
    return time - from > u * width ? fmax(from, nextafter(time, -INFINITY)) : time;
}

/// The first failure in [from, to] on two algebraic pieces, from interval to interval.
static bmr_error algebraic_failure(const bmr_condition *condition, const bmr_motion_piece *owner,
                                   const bmr_motion_piece *other, double from, double to, bool fresh,
                                   const bmr_failure_options *options, double tolerance, double *time) {
    *time = INFINITY;
    for (size_t steps = 0; from < to; steps++) {
        if (steps == BMR_FAILURE_MAX_INTERVALS)
            return BMR_ERROR_OUT_OF_RANGE;
        bmr_condition_polynomial p;
        bmr_condition_expand(condition, owner, other, from, to - from, &p);
        if (!isfinite(p.noise))
            return BMR_ERROR_NOT_FINITE;
        size_t zeros;
        const beginning start = begin(&p, &zeros);
        if (start == BELOW && fresh) {
            const double grace = bmr_start_grace(from, tolerance);
            if (from + grace < to && horner(&p, fmin(1.0, grace / p.width)) > -BMR_START_NOISES * p.noise) {
                const bmr_error error = algebraic_failure(condition, owner, other, from + grace, to, false,
                                                          options, tolerance, time);
                // Still failing where it was to be positive: it never grew.
                if (error == BMR_OK && *time <= from + grace)
                    *time = from;
                return error;
            }
        }
        if (start == BELOW || start == FAILING ||
            (start == FLAT && stays_flat(condition, owner, other, from))) {
            *time = from;
            return BMR_OK;
        }
        double u = INFINITY;
        const bmr_error error = start == FLAT ? BMR_OK : first_root(&p, zeros, options, tolerance, &u);
        if (error != BMR_OK)
            return error;
        if (u <= 1.0) {
            *time = fmin(at_part(from, u, p.width), to); // the width is rounded too
            return BMR_OK;
        }
        const double next = p.width < to - from ? from + p.width : to;
        from = next > from ? next : nextafter(from, INFINITY);
        fresh = false;
    }
    return BMR_OK;
}

static bool condition_finite(const bmr_condition *k) {
    return isfinite(k->normal.x) && isfinite(k->normal.y) && isfinite(k->offset) && isfinite(k->point.x) &&
           isfinite(k->point.y);
}

/// Section 2, failure times: when a certificate fails is a root of a polynomial.
bmr_error bmr_failure_time(const bmr_condition *condition, const bmr_motion *a, const bmr_motion *b,
                           double after, double until, const bmr_failure_options *options, double *time) {
    if (!condition || !a || !b || !options || !time)
        return BMR_ERROR_NULL_ARGUMENT;
    if (!condition_finite(condition) || !isfinite(after) || !isfinite(until) || !isfinite(options->tolerance))
        return BMR_ERROR_NOT_FINITE;
    if (condition->kind >= BMR_CONDITION_KIND_COUNT || condition->owner > 1 || after > until ||
        !(options->tolerance > 0.0) || (unsigned)options->method > BMR_ROOT_GSL)
        return BMR_ERROR_OUT_OF_RANGE;
    double first = INFINITY;
    // No distance is below zero.
    const bool never = condition->kind == BMR_CONDITION_DISKS && !(condition->offset > 0.0);
    const bmr_motion *const owner = condition->owner == 0 ? a : b, *const other =
                                                                       condition->owner == 0 ? b : a;
    for (double from = after; from < until && !never && first > until;) {
        double own_end, other_end;
        const bmr_motion_piece *p = bmr_motion_piece_at(owner, from, &own_end);
        const bmr_motion_piece *q = bmr_motion_piece_at(other, from, &other_end);
        const double to = fmin(until, fmin(own_end, other_end));
        const double tolerance = options->tolerance * fmax(1.0, fabs(from));
        const bool fresh = from == after;
        const bmr_error error =
            bmr_piece_is_algebraic(p) && bmr_piece_is_algebraic(q)
                ? algebraic_failure(condition, p, q, from, to, fresh, options, tolerance, &first)
                : bmr_safe_first_failure(condition, p, q, from, to, fresh, tolerance, &first);
        if (error != BMR_OK)
            return error;
        from = to;
    }
    *time = first;
    return BMR_OK;
}

bmr_error bmr_first_failure(const bmr_condition *conditions, size_t count, const bmr_motion *a,
                            const bmr_motion *b, double from, double to, const bmr_failure_options *options,
                            double *time, size_t *failing) {
    double first = INFINITY;
    for (size_t i = 0; i < count && first > from; i++) {
        double failure;
        const bmr_error error =
            bmr_failure_time(&conditions[i], a, b, from, fmin(to, first), options, &failure);
        if (error != BMR_OK)
            return error;
        if (failure < first) {
            first = failure;
            *failing = i;
        }
    }
    *time = first;
    return BMR_OK;
}

double bmr_repair_time(const bmr_pair_motion *motion, const bmr_condition *condition, double time,
                       double tolerance, double longest) {
    double later = time, step = fmax(tolerance, DBL_EPSILON * fabs(time));
    for (int i = 0; i <= NUDGES; i++, step *= 2.0) {
        const bmr_pose pose = bmr_pair_instant(motion, later).pose;
        if (!(bmr_condition_value(condition, &pose) > 0.0))
            return later;
        if (i > 0 && step > longest)
            break;
        later = time + step;
    }
    return later;
}
