// SPDX-License-Identifier: MIT
#include "kinetic/failure.h"

#include <float.h>
#include <math.h>
#include <stdalign.h>
#include <stddef.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include "geometry/length.h"
#include "kinetic/roots.h"

// ---- safe steps, for any two pieces ----

/// How many roundings a condition's value may be off by, each of the lengths that it is computed from: two
/// products of rotations, one with a point, and the sums.
#define VALUE_ROUNDINGS 16.0

/// A condition that is zero up to rounding at this many samples is taken to stay zero.
#define FLAT_SAMPLES 256

/// The most intervals that are bounded. A step needs two; thousands, where a rotation is near a
/// pole all the way.
#define MOST_INTERVALS (4 * BMR_FAILURE_MAX_STEPS)

/// Time is resolved to this many of its own roundings.
#define TIME_ROUNDINGS 4.0

/// The most steps of GSL's solver. Bisection alone would end in 64, from any bracket that a step leaves.
#define SOLVER_STEPS 200

/// Room for the state of gsl_root_fsolver_brent (eleven doubles in GSL 2): on the stack nothing can fail.
#define SOLVER_BYTES 256

typedef struct search {
    const bmr_condition *condition;
    const bmr_motion_piece *owner, *other;
    double tolerance;
    double reach, arm; ///< lengths of the condition's normal and point
    size_t intervals;  ///< bounded so far
} search;

typedef struct sample {
    double time, value, slope;
    double noise; ///< bound of the rounding error of `value`
} sample;

/// What holds over an interval.
typedef struct bounds {
    double bend; ///< f'' >= -bend
    double dip;  ///< positive at both ends of a step h, f >= -dip h^2 / 8 between them
} bounds;

/// Velocity of a point of a body, given as an offset from its origin in the outer frame.
static bmr_vec2 velocity_of(const bmr_instant *body, bmr_vec2 offset) {
    return bmr_add(body->velocity, bmr_scale(body->spin, bmr_left(offset)));
}

static sample sample_at(const search *s, double time) {
    const bmr_condition *k = s->condition;
    const bmr_instant own = bmr_piece_instant(s->owner, time), other = bmr_piece_instant(s->other, time);
    const bmr_vec2 way = bmr_sub(other.pose.position, own.pose.position);
    const bmr_vec2 normal = bmr_rotate(&own.pose, k->normal), point = bmr_rotate(&other.pose, k->point);
    const double clock = fabs(time) + fabs(time - s->owner->origin) + fabs(time - s->other->origin);
    const double reach = s->reach, arm = s->arm;
    sample at = {time, 0.0, 0.0, 0.0};
    double size, rate; // lengths involved, and how fast a rounding of the time moves them
    if (k->kind == BMR_CONDITION_TURN) {
        at.value = bmr_cross(normal, point);
        at.slope = (other.spin - own.spin) * bmr_dot(normal, point);
        size = reach * arm;
        rate = size * (fabs(own.spin) + fabs(other.spin));
    } else {
        const bmr_vec2 to = bmr_add(point, way); // from the owner's origin
        const bmr_vec2 motion = bmr_sub(velocity_of(&other, point), own.velocity);
        const double places = bmr_length(own.pose.position) + bmr_length(other.pose.position) + arm;
        const double speed = bmr_length(own.velocity) + bmr_length(other.velocity) + fabs(other.spin) * arm;
        if (k->kind == BMR_CONDITION_BEYOND) {
            at.value = bmr_dot(normal, to) - k->offset;
            at.slope = own.spin * bmr_dot(bmr_left(normal), to) + bmr_dot(normal, motion);
            size = reach * places + fabs(k->offset);
            rate = reach * (speed + fabs(own.spin) * bmr_length(to));
        } else {
            const bmr_vec2 apart = bmr_sub(to, normal);
            const bmr_vec2 change = bmr_sub(motion, bmr_scale(own.spin, bmr_left(normal)));
            const double distance = bmr_length(apart);
            at.value = distance - k->offset;
            at.slope = distance > 0.0 ? bmr_dot(apart, change) / distance : 0.0;
            size = reach + places + fabs(k->offset);
            rate = speed + fabs(own.spin) * reach;
        }
    }
    at.noise = (DBL_EPSILON / 2.0) * (VALUE_ROUNDINGS * size + clock * rate);
    return at;
}

/// The second derivative over [time, time + width]. In the owner's frame BEYOND is
/// <n, R v> + <n, R_owner^T way>, where R turns by the difference of the angles.
static bounds bound_over(search *s, double time, double width) {
    const bmr_condition *k = s->condition;
    const bmr_piece_rates own = bmr_piece_bounds(s->owner, time, time + width, &s->intervals);
    const bmr_piece_rates other = bmr_piece_bounds(s->other, time, time + width, &s->intervals);
    const double turn = fmax(other.spin_high - own.spin_low, own.spin_high - other.spin_low);
    const double spin = bmr_rates_spin(&own), other_spin = bmr_rates_spin(&other);
    const double turn_change = own.spin_change + other.spin_change;
    const double reach = s->reach, arm = s->arm;
    bounds b;
    if (k->kind == BMR_CONDITION_TURN) {
        b.bend = b.dip = reach * arm * (turn * turn + turn_change);
        return b;
    }
    const bmr_instant o = bmr_piece_instant(s->owner, time), x = bmr_piece_instant(s->other, time);
    const double speed = own.speed + other.speed, push = own.acceleration + other.acceleration;
    if (k->kind == BMR_CONDITION_BEYOND) {
        const double way = bmr_length(bmr_sub(x.pose.position, o.pose.position)) + speed * width;
        double bend = push;
        if (arm > 0.0)
            bend += arm * (turn * turn + turn_change);
        if (spin > 0.0)
            bend += (own.spin_change + spin * spin) * way + 2.0 * spin * speed;
        b.bend = b.dip = reach * bend;
        return b;
    }
    // The distance of two points bends down by no more than they accelerate. Between two places outside a
    // circle a path dips into it like a chord, and bends.
    double motion = speed, bend = push;
    if (reach > 0.0) {
        motion += spin * reach;
        bend += (own.spin_change + spin * spin) * reach;
    }
    if (arm > 0.0) {
        motion += other_spin * arm;
        bend += (other.spin_change + other_spin * other_spin) * arm;
    }
    b.bend = bend;
    b.dip = bend + 2.0 * motion * motion / k->offset;
    return b;
}

/// How long f stays positive for certain: the root of value + slope t - bend t^2 / 2.
static double safe_step(const sample *at, double bend) {
    const double root = sqrt(at->slope * at->slope + 2.0 * bend * at->value);
    if (at->slope < 0.0)
        return 2.0 * at->value / (root - at->slope);
    return bend > 0.0 ? (at->slope + root) / bend : INFINITY;
}

/// The step between whose ends, both positive, a dip is lost in the rounding.
static double blind_step(const sample *at, const bounds *b) {
    const double step = sqrt(8.0 * at->noise / b->dip);
    return fmax(step, TIME_ROUNDINGS * DBL_EPSILON * fabs(at->time));
}

// ---- the last digits ----

static double value_at(double time, void *context) {
    return sample_at(context, time).value;
}

/// From positive at `low` to not positive at `high`: a time, at most the tolerance before the root, at which
/// it is not negative.
static double narrow(const search *s, double low, double high) {
    search copy = *s;
    gsl_function function = {value_at, &copy};
    alignas(max_align_t) unsigned char state[SOLVER_BYTES];
    gsl_root_fsolver solver = {gsl_root_fsolver_brent, NULL, 0.0, 0.0, 0.0, state};
    const double width = fmax(s->tolerance, TIME_ROUNDINGS * DBL_EPSILON * fabs(high));
    bmr_gsl_guard_enter();
    bool works = gsl_root_fsolver_brent->size <= sizeof state &&
                 gsl_root_fsolver_set(&solver, &function, low, high) == GSL_SUCCESS;
    for (int step = 0; step < SOLVER_STEPS && high - low > width; step++) {
        works = works && gsl_root_fsolver_iterate(&solver) == GSL_SUCCESS;
        double guess = works ? solver.root : low + 0.5 * (high - low);
        // Brent's bracket often has one long side: try half a width to both sides of the guess.
        const double before = guess - 0.5 * width, after = guess + 0.5 * width;
        if (before > low && before < high && value_at(before, &copy) > 0.0)
            low = before;
        if (after > low && after < high && !(value_at(after, &copy) > 0.0))
            high = after;
        if (works && solver.x_lower > low && solver.x_lower < solver.x_upper)
            low = solver.x_lower;
        if (works && solver.x_upper < high && solver.x_upper > low)
            high = solver.x_upper;
        works = works && solver.x_upper > solver.x_lower;
    }
    bmr_gsl_guard_leave();
    return low;
}

// ---- the walk ----

/// Judges a condition that is not positive at the beginning. True: it fails there and then. False: *at is a
/// sample, there or a little later, from which the walk can go on.
static bool fails_at_start(search *s, double to, bool fresh, sample *at) {
    if (at->value > 0.0)
        return false;
    if (at->value < -BMR_START_NOISES * at->noise) {
        const double grace = bmr_start_grace(at->time, s->tolerance);
        if (!fresh || !(at->time + grace < to))
            return true;
        *at = sample_at(s, at->time + grace);
        if (at->value < -BMR_START_NOISES * at->noise)
            return true;
    }
    for (int samples = 0; samples < FLAT_SAMPLES; samples++) {
        if (at->value > BMR_START_NOISES * at->noise || !(at->time < to))
            return false;
        if (at->value < -BMR_START_NOISES * at->noise)
            return true;
        const double rest = to - at->time;
        bounds b = bound_over(s, at->time, rest);
        double step = fmin(blind_step(at, &b), rest);
        b = bound_over(s, at->time, step);
        step = fmin(blind_step(at, &b), rest);
        // Over this step the curvature changes the value by four noises at most, so that a larger slope
        // decides.
        const double growth = at->slope * step;
        if (growth < -2.0 * BMR_START_NOISES * at->noise)
            return true;
        *at = sample_at(s, at->time + step);
        if (growth > 2.0 * BMR_START_NOISES * at->noise && at->value > 0.0)
            return false;
    }
    return true;
}

/// The first failure in [from, to], by steps over which a bound of the second derivative keeps the condition
/// positive, and GSL's Brent solver once two neighbouring samples have different signs. For any two pieces;
/// needed where a spinning screw takes part. `fresh`: `from` is where the caller begins, and a condition a
/// little below zero that is above it after a few tolerances is growing; else it follows on another piece.
/// INFINITY if there is none. A condition costs two sines and cosines a sample; a root takes about ten
/// samples, and a whole turn some five more. Errors: NOT_FINITE (the motion overflows), OUT_OF_RANGE (more
/// than BMR_FAILURE_MAX_STEPS steps); then *time is untouched.
static bmr_error safe_failure(const bmr_condition *condition, const bmr_motion_piece *owner,
                              const bmr_motion_piece *other, double from, double to, bool fresh,
                              double tolerance, double *time) {
    search s = {
        condition, owner, other, tolerance, bmr_length(condition->normal), bmr_length(condition->point), 0};
    sample at = sample_at(&s, from);
    if (!isfinite(at.value))
        return BMR_ERROR_NOT_FINITE;
    if (fails_at_start(&s, to, fresh, &at)) {
        *time = from;
        return BMR_OK;
    }
    double window = to - at.time;
    for (size_t steps = 0; at.time < to; steps++) {
        if (steps == BMR_FAILURE_MAX_STEPS || s.intervals > MOST_INTERVALS)
            return BMR_ERROR_OUT_OF_RANGE;
        const double rest = to - at.time;
        window = fmin(window, rest);
        const bounds b = bound_over(&s, at.time, window);
        const double blind = fmin(blind_step(&at, &b), rest);
        double step = safe_step(&at, b.bend);
        if (!(step >= 0.0))
            step = 0.0; // an infinite bound, or a value that rounding took below zero
        if (step < 0.25 * window && window > 2.0 * blind) {
            window = fmax(0.25 * window, 2.0 * step); // the bounds may be better nearby
            if (step < blind)
                continue;
        }
        if (step > window) {
            step = window;
            window *= 4.0;
        }
        step = fmin(fmax(step, blind), rest);
        const sample next = sample_at(&s, step < rest ? at.time + step : to);
        if (!isfinite(next.value))
            return BMR_ERROR_NOT_FINITE;
        if (!(next.value > 0.0)) {
            *time = narrow(&s, at.time, next.time);
            return BMR_OK;
        }
        at = next;
    }
    *time = INFINITY;
    return BMR_OK;
}

/// Doubles near 1 are 2e-16 apart, so that this leaves more than three digits.
#define DEFAULT_TOLERANCE 1e-12

/// A condition that stays at zero for this long, times max(1, |time|), has failed: it is called flat.
#define LONG_TIME 1024.0

/// A leading term is dropped when over the whole interval it adds less than this part of the rounding error.
#define NEGLIGIBLE_PART 0x1p-10

/// A condition that is still positive where it was to fail is followed for so many doublings of the
/// tolerance: 2^10 tolerances is more than the rounding of any value lasts.
#define NUDGES 10

bmr_failure_options bmr_default_failure_options(void) {
    const bmr_failure_options options = {DEFAULT_TOLERANCE};
    return options;
}

typedef enum beginning { POSITIVE, GROWING, FAILING, BELOW, FLAT } beginning;

/// What the polynomial does right after 0. GROWING: its first `*zeros` coefficients are zero up to rounding,
/// and the next is positive. BELOW: definitely negative. FLAT: all are zero up to rounding, and the first is
/// not positive.
static beginning beginning_of(const bmr_condition_polynomial *p, size_t *zeros) {
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
    const beginning start = beginning_of(&p, &zeros);
    return start == FLAT || start == FAILING;
}

/// The first root of the coefficients from `zeros` on: dividing by u^zeros leaves the sign, and takes away
/// the root at the beginning. INFINITY: there is none.
static double first_root(const bmr_condition_polynomial *p, size_t zeros, double tolerance) {
    const double *c = p->c + zeros;
    size_t degree = p->degree - zeros;
    while (degree > 0 && fabs(c[degree]) <= NEGLIGIBLE_PART * p->noise)
        degree--;
    double u;
    return bmr_bernstein_first_root(c, degree, p->noise, tolerance / p->width, &u) ? u : INFINITY;
}

/// from + u width, rounded towards `from`.
static double at_part(double from, double u, double width) {
    const double time = from + u * width;
    return time - from > u * width ? fmax(from, nextafter(time, -INFINITY)) : time;
}

/// The first failure in [from, to] on two algebraic pieces, from interval to interval.
static bmr_error algebraic_failure(const bmr_condition *condition, const bmr_motion_piece *owner,
                                   const bmr_motion_piece *other, double from, double to, bool fresh,
                                   double tolerance, double *time) {
    *time = INFINITY;
    for (size_t steps = 0; from < to; steps++) {
        if (steps == BMR_FAILURE_MAX_INTERVALS)
            return BMR_ERROR_OUT_OF_RANGE;
        bmr_condition_polynomial p;
        bmr_condition_expand(condition, owner, other, from, to - from, &p);
        if (!isfinite(p.noise))
            return BMR_ERROR_NOT_FINITE;
        size_t zeros;
        const beginning start = beginning_of(&p, &zeros);
        if (start == BELOW && fresh) {
            const double grace = bmr_start_grace(from, tolerance);
            if (from + grace < to && bmr_polynomial_value(p.c, p.degree, fmin(1.0, grace / p.width)) >
                                         -BMR_START_NOISES * p.noise) {
                const bmr_error error =
                    algebraic_failure(condition, owner, other, from + grace, to, false, tolerance, time);
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
        const double u = start == FLAT ? INFINITY : first_root(&p, zeros, tolerance);
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
        !(options->tolerance > 0.0))
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
        const bmr_error error = bmr_piece_is_algebraic(p) && bmr_piece_is_algebraic(q)
                                    ? algebraic_failure(condition, p, q, from, to, fresh, tolerance, &first)
                                    : safe_failure(condition, p, q, from, to, fresh, tolerance, &first);
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
