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

/// How many roundings a condition's value may be off by, each of the lengths that it is computed from: two
/// products of rotations, one with a point, and the sums.
#define VALUE_ROUNDINGS 16.0

/// A condition that is zero up to rounding at this many looks is taken to stay zero.
#define FLAT_LOOKS 256

/// The most intervals that are looked at for bounds. A step needs two; thousands, where a rotation is near a
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
    size_t intervals;  ///< looked at for bounds so far
} search;

typedef struct look {
    double time, value, slope;
    double noise; ///< bound of the rounding error of `value`
} look;

/// What holds over an interval.
typedef struct bounds {
    double bend; ///< f'' >= -bend
    double dip;  ///< positive at both ends of a step h, f >= -dip h^2 / 8 between them
} bounds;

/// Velocity of a point of a body, given as an offset from its origin in the outer frame.
static bmr_vec2 velocity_of(const bmr_instant *body, bmr_vec2 offset) {
    return bmr_add(body->velocity, bmr_scale(body->spin, bmr_left(offset)));
}

static look look_at(const search *s, double time) {
    const bmr_condition *k = s->condition;
    const bmr_instant own = bmr_piece_instant(s->owner, time), other = bmr_piece_instant(s->other, time);
    const bmr_vec2 way = bmr_sub(other.pose.position, own.pose.position);
    const bmr_vec2 normal = bmr_rotate(&own.pose, k->normal), point = bmr_rotate(&other.pose, k->point);
    const double clock = fabs(time) + fabs(time - s->owner->origin) + fabs(time - s->other->origin);
    const double reach = s->reach, arm = s->arm;
    look at = {time, 0.0, 0.0, 0.0};
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
static double safe_step(const look *at, double bend) {
    const double root = sqrt(at->slope * at->slope + 2.0 * bend * at->value);
    if (at->slope < 0.0)
        return 2.0 * at->value / (root - at->slope);
    return bend > 0.0 ? (at->slope + root) / bend : INFINITY;
}

/// The step between whose ends, both positive, a dip is lost in the rounding.
static double blind_step(const look *at, const bounds *b) {
    const double step = sqrt(8.0 * at->noise / b->dip);
    return fmax(step, TIME_ROUNDINGS * DBL_EPSILON * fabs(at->time));
}

// ---- the last digits ----

static double value_at(double time, void *context) {
    return look_at(context, time).value;
}

/// From positive at `low` to not positive at `high`: a time, at most the tolerance before the root, at which
/// it is still positive.
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
        // Brent's bracket often has one long side: look half a width to both sides of the guess.
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
/// look, there or a little later, from which the walk can go on.
static bool fails_at_start(search *s, double to, bool fresh, look *at) {
    if (at->value > 0.0)
        return false;
    if (at->value < -BMR_START_NOISES * at->noise) {
        const double grace = bmr_start_grace(at->time, s->tolerance);
        if (!fresh || !(at->time + grace < to))
            return true;
        *at = look_at(s, at->time + grace);
        if (at->value < -BMR_START_NOISES * at->noise)
            return true;
    }
    for (int looks = 0; looks < FLAT_LOOKS; looks++) {
        if (at->value > BMR_START_NOISES * at->noise || !(at->time < to))
            return false;
        if (at->value < -BMR_START_NOISES * at->noise)
            return true;
        const double room = to - at->time;
        bounds b = bound_over(s, at->time, room);
        double step = fmin(blind_step(at, &b), room);
        b = bound_over(s, at->time, step);
        step = fmin(blind_step(at, &b), room);
        // Over this step the curvature changes the value by four noises at most, so that a larger slope
        // decides.
        const double growth = at->slope * step;
        if (growth < -2.0 * BMR_START_NOISES * at->noise)
            return true;
        *at = look_at(s, at->time + step);
        if (growth > 2.0 * BMR_START_NOISES * at->noise && at->value > 0.0)
            return false;
    }
    return true;
}

bmr_error bmr_safe_first_failure(const bmr_condition *condition, const bmr_motion_piece *owner,
                                 const bmr_motion_piece *other, double from, double to, bool fresh,
                                 double tolerance, double *time) {
    search s = {
        condition, owner, other, tolerance, bmr_length(condition->normal), bmr_length(condition->point), 0};
    look at = look_at(&s, from);
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
        const double room = to - at.time;
        window = fmin(window, room);
        const bounds b = bound_over(&s, at.time, window);
        const double blind = fmin(blind_step(&at, &b), room);
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
        step = fmin(fmax(step, blind), room);
        const look next = look_at(&s, step < room ? at.time + step : to);
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
