// SPDX-License-Identifier: MIT
// First failure times of conditions under fuzzed motions, against dense samples in long double: never late,
// never early by more than the tolerance. Where numbers are wild, the contract alone: an error or a time in
// range.
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "boomerang/failure.h"
#include "harness.h"
#include "paths.h"

// --- the oracle: dense samples, minima between them sought out. Nothing of core's is used but the motions'
// own description ---

/// A motion as it was asked for.
#define ORACLE_PIECES 8
typedef struct oracle_plan {
    size_t count;
    double from[ORACLE_PIECES];
    bmr_motion_piece pieces[ORACLE_PIECES];
} oracle_plan;

/// Two motions and what is waited for.
typedef struct oracle_trial {
    oracle_plan a, b;
    bmr_condition condition;
} oracle_trial;

/// The plan of a motion of at most ORACLE_PIECES pieces.
static void oracle_read_plan(const bmr_motion *motion, oracle_plan *plan) {
    plan->count = 0;
    double t = -INFINITY;
    do {
        double end;
        plan->from[plan->count] = t;
        plan->pieces[plan->count++] = *bmr_motion_piece_at(motion, t, &end);
        t = end;
    } while (!isinf(t) && plan->count < ORACLE_PIECES);
}

/// What a value may be below zero, in parts of the lengths that go into it: the header's 1e-14, times the
/// growth over one interval and the number of terms of the algebraic ones.
#define ORACLE_SLACK 2e-12L

typedef struct oracle_verdict {
    bool late, early;
    long double worst; ///< the least value before the time, over the lengths involved
} oracle_verdict;

static long double horner(const double *c, size_t degree, long double u) {
    long double value = c[degree];
    for (size_t k = degree; k-- > 0;)
        value = value * u + (long double)c[k];
    return value;
}

/// The sum of the terms' magnitudes, and what u's roundings add to it where times are as large as `far`.
static long double terms(const double *c, size_t degree, long double u, long double far) {
    long double value = fabsl((long double)c[degree]), rate = 0.0L;
    for (size_t k = degree; k-- > 0;) {
        rate = rate * u + value;
        value = value * u + fabsl((long double)c[k]);
    }
    return value + far * rate;
}

typedef struct place {
    long double x, y, c, s;
    long double way;  ///< size of x and y: their terms, and what a rounding of the time makes of them
    long double turn; ///< what a rounding may be multiplied by in c and s
} place;

typedef enum side { BEFORE, AFTER } side; // of a time at which the motion changes

static place place_at(const oracle_plan *p, long double t, side which) {
    size_t i = 0;
    while (i + 1 < p->count &&
           (which == BEFORE ? (long double)p->from[i + 1] < t : (long double)p->from[i + 1] <= t))
        i++;
    const bmr_motion_piece *piece = &p->pieces[i];
    const long double u = t - (long double)piece->origin;
    const long double far = fabsl(t) + fabsl((long double)piece->origin);
    place at;
    long double c, s, c0, s0;
    if (piece->kind == BMR_PIECE_SCREW) {
        const bmr_screw_motion *w = &piece->as.screw;
        const long double vx = w->velocity.x, vy = w->velocity.y, spin = w->spin;
        at.x = (long double)w->start.position.x + u * vx;
        at.y = (long double)w->start.position.y + u * vy;
        at.way =
            hypotl((long double)w->start.position.x, (long double)w->start.position.y) + far * hypotl(vx, vy);
        at.turn = 1.0L + fabsl(spin) * far;
        c = cosl(spin * u);
        s = sinl(spin * u);
        c0 = w->start.c;
        s0 = w->start.s;
    } else {
        const bmr_algebraic_piece *w = &piece->as.algebraic;
        at.x = horner(w->x, w->degree, u);
        at.y = horner(w->y, w->degree, u);
        const long double a = horner(w->a, w->rotation_degree, u), b = horner(w->b, w->rotation_degree, u);
        c = (a * a - b * b) / (a * a + b * b);
        s = 2.0L * a * b / (a * a + b * b);
        at.way = hypotl(terms(w->x, w->degree, fabsl(u), far), terms(w->y, w->degree, fabsl(u), far));
        const long double all_a = terms(w->a, w->rotation_degree, fabsl(u), far),
                          all_b = terms(w->b, w->rotation_degree, fabsl(u), far);
        at.turn = (all_a * all_a + all_b * all_b) / (a * a + b * b);
        c0 = w->start_c;
        s0 = w->start_s;
    }
    const long double unit = hypotl(c0, s0);
    at.c = (c * c0 - s * s0) / unit;
    at.s = (s * c0 + c * s0) / unit;
    return at;
}

static long double value_at(const oracle_trial *r, long double t, side which, long double *size) {
    const bmr_condition *k = &r->condition;
    const place o = place_at(k->owner == 0 ? &r->a : &r->b, t, which),
                x = place_at(k->owner == 0 ? &r->b : &r->a, t, which);
    const long double nx = o.c * (long double)k->normal.x - o.s * (long double)k->normal.y,
                      ny = o.s * (long double)k->normal.x + o.c * (long double)k->normal.y;
    const long double px = x.c * (long double)k->point.x - x.s * (long double)k->point.y,
                      py = x.s * (long double)k->point.x + x.c * (long double)k->point.y;
    const long double n = hypotl(nx, ny) * o.turn, p = hypotl(px, py) * x.turn;
    const long double ways = o.way + x.way;
    if (size)
        *size = k->kind == BMR_CONDITION_TURN    ? n * p
                : k->kind == BMR_CONDITION_DISKS ? n + p + ways + fabsl((long double)k->offset)
                                                 : n * (p + ways) + fabsl((long double)k->offset);
    if (k->kind == BMR_CONDITION_TURN)
        return nx * py - ny * px;
    if (k->kind == BMR_CONDITION_DISKS)
        return hypotl(px + x.x - o.x - nx, py + x.y - o.y - ny) - (long double)k->offset;
    return nx * (px + x.x - o.x) + ny * (py + x.y - o.y) - (long double)k->offset;
}

/// The condition's value; *size (or NULL): the lengths that go into it.
static long double oracle_value(const oracle_trial *r, long double t, long double *size) {
    return value_at(r, t, AFTER, size);
}

/// The least value in [low, high], by golden section.
static long double oracle_least(const oracle_trial *r, long double low, long double high) {
    const long double ratio = 0.6180339887498949L;
    long double p = high - ratio * (high - low), q = low + ratio * (high - low);
    long double fp = oracle_value(r, p, NULL), fq = oracle_value(r, q, NULL);
    for (int i = 0; i < 60; i++) {
        if (fp < fq) {
            high = q;
            q = p;
            fq = fp;
            p = high - ratio * (high - low);
            fp = oracle_value(r, p, NULL);
        } else {
            low = p;
            p = q;
            fp = fq;
            q = low + ratio * (high - low);
            fq = oracle_value(r, q, NULL);
        }
    }
    return fminl(fp, fq);
}

/// The next time after `t` at which one of the two changes its plan; INFINITY: none.
static long double next_change(const oracle_trial *r, long double t) {
    long double next = INFINITY;
    for (int body = 0; body < 2; body++) {
        const oracle_plan *p = body == 0 ? &r->a : &r->b;
        for (size_t i = 1; i < p->count; i++)
            if ((long double)p->from[i] > t)
                next = fminl(next, (long double)p->from[i]);
    }
    return next;
}

/// The value in parts of the lengths that go into it.
static long double part_at(const oracle_trial *r, long double t, side which) {
    long double size;
    const long double value = value_at(r, t, which, &size);
    return value / size;
}

/// The least of such parts on both sides of all changes of plan in (low, high): there, values jump or bend,
/// and a touch lasts for no time at all.
static long double least_at_changes(const oracle_trial *r, long double low, long double high) {
    long double worst = INFINITY;
    for (long double t = next_change(r, low); t < high; t = next_change(r, t))
        worst = fminl(worst, fminl(part_at(r, t, BEFORE), part_at(r, t, AFTER)));
    return worst;
}

/// Is the value about zero or below at some time in [low, high]? Least values between samples are sought out.
static bool comes_to_zero(const oracle_trial *r, long double low, long double high, int samples) {
    const long double step = (high - low) / samples;
    if (part_at(r, high, BEFORE) <= ORACLE_SLACK || least_at_changes(r, low, high) <= ORACLE_SLACK)
        return true;
    long double after = INFINITY, here = INFINITY;
    for (int i = 0; i <= samples + 1; i++) { // from the end, where it is below zero mostly
        const long double before = i <= samples ? part_at(r, high - step * i, AFTER) : INFINITY;
        if (before <= ORACLE_SLACK)
            return true;
        if (i > 0 && here <= after && here <= before) {
            const long double t = high - step * (i - 1);
            long double size;
            oracle_value(r, t, &size);
            if (oracle_least(r, fmaxl(low, t - step), fminl(high, t + step)) <= ORACLE_SLACK * size)
                return true;
        }
        after = here;
        here = before;
    }
    return false;
}

/// Judges a failure time (INFINITY: none until `until`) by so many samples at the time before it. Late: the
/// value was below zero before. Early: it is above until `tolerance` after.
static oracle_verdict oracle_judge(const oracle_trial *r, double after, double until, double time,
                                   double tolerance, int samples) {
    oracle_verdict v = {false, false, 0.0L};
    const long double last = fminl((long double)time, (long double)until);
    const long double step = (last - (long double)after) / samples;
    long double size, before = INFINITY, here = oracle_value(r, after, &size), worst = 0.0L;
    for (int i = 1; i <= samples && step > 0.0L; i++) {
        const long double t = (long double)after + step * i - (i == samples ? 1e-17L : 0.0L);
        const long double next = value_at(r, t, BEFORE, &size);
        if (i < samples)
            worst = fminl(worst, next / size);
        if (here <= before && here <= next && i > 1 && here < 0.05L * size)
            worst = fminl(worst, oracle_least(r, t - 2.0L * step, t) / size);
        before = here;
        here = next;
    }
    // Nearer and nearer to the end, and there.
    for (int i = 0; i < 60 && step > 0.0L; i++) {
        const long double value = value_at(r, last - ldexpl(step, -i), BEFORE, &size);
        worst = fminl(worst, value / size);
    }
    if (!isinf(time) && step > 0.0L)
        worst = fminl(worst, value_at(r, last, BEFORE, &size) / size);
    worst = fminl(worst, least_at_changes(r, after, last));
    v.worst = worst;
    v.late = worst < -ORACLE_SLACK;
    if (!isinf(time))
        v.early = !comes_to_zero(r, time, (long double)time + (long double)tolerance, samples);
    return v;
}

// --- the fuzzer ---

#define SAMPLES 150
#define BEGIN 0.0
#define END 4.0

static bmr_condition read_condition(fuzz_bytes *bytes, bool wild) {
    const uint8_t kind = fuzz_u8(bytes);
    const int owner = kind >= 128;
    const double angle = fuzz_in(bytes, -3.2, 3.2), other = fuzz_in(bytes, -3.2, 3.2);
    bmr_vec2 normal = {cos(angle), sin(angle)};
    const double x = wild ? fuzz_number(bytes) : fuzz_in(bytes, -2.0, 2.0);
    const bmr_vec2 point = {x, wild ? fuzz_number(bytes) : fuzz_in(bytes, -2.0, 2.0)};
    const double offset = wild ? fuzz_number(bytes) : fuzz_in(bytes, -3.0, 3.0);
    if (kind % 3 == BMR_CONDITION_TURN)
        return bmr_condition_turn(owner, normal, bmr_vec2_make(cos(other), sin(other)), 0);
    if (kind % 3 == BMR_CONDITION_DISKS)
        return bmr_condition_disks(bmr_vec2_make(other, angle), point, fabs(offset), 0);
    bmr_condition condition = bmr_condition_beyond(owner, normal, offset, point, 0);
    if (wild && kind % 16 == 7)
        condition.kind = kind;
    return condition;
}

static double time_of(const oracle_trial *trial, bmr_motion *const motions[2], double after, double until,
                      double tolerance, bool wild) {
    bmr_failure_options options = bmr_default_failure_options();
    options.tolerance = tolerance;
    double time = -77.0;
    const bmr_error error =
        bmr_failure_time(&trial->condition, motions[0], motions[1], after, until, &options, &time);
    if (error != BMR_OK) {
        FUZZ_CHECK(time == -77.0, "error %d wrote a time", error);
        FUZZ_CHECK(error == BMR_ERROR_NOT_FINITE || error == BMR_ERROR_OUT_OF_RANGE, "error %d", error);
        FUZZ_CHECK(wild, "error %d where all is moderate", error);
        return NAN;
    }
    FUZZ_CHECK(time >= after && (time <= until || isinf(time)), "time %.17g is not in [%.17g, %.17g]", time,
               after, until);
    if (fuzz_control("late") && isfinite(time))
        time += 0.1;
    if (fuzz_control("missed"))
        time = INFINITY;
    if (fuzz_control("early") && isinf(time))
        time = after;
    return time;
}

/// What the header says of a condition that is not positive at the beginning: below zero there and after four
/// tolerances, it fails there.
static void check_start(const oracle_trial *trial, double after, double until, double time,
                        double tolerance) {
    const double width = tolerance * fmax(1.0, fabs(after));
    bool below = true;
    for (int i = 0; i <= 12 && below; ++i) {
        long double size;
        const long double value = oracle_value(trial, after + 0.5 * i * width, &size);
        below = value < -ORACLE_SLACK * size;
    }
    if (below && after < until)
        FUZZ_CHECK(time == after, "below zero at %.17g, but fails at %.17g", after, time);
}

static void check_time(const oracle_trial *trial, double after, double until, double time, double tolerance) {
    long double size;
    const long double value = oracle_value(trial, after, &size);
    if (!(value > 1e-6L * size)) {
        check_start(trial, after, until, time, tolerance);
        return;
    }
    const double width = 1.01 * tolerance * fmax(1.0, fabs(time));
    const oracle_verdict v = oracle_judge(trial, after, until, time, isinf(time) ? 0.0 : width, SAMPLES);
    FUZZ_CHECK(!v.late, "condition %d: late, time %.17g, worst %Lg", trial->condition.kind, time, v.worst);
    FUZZ_CHECK(!v.early, "condition %d: early by more than %g, time %.17g", trial->condition.kind, width,
               time);
}

/// From the failure on the opposite condition holds, for as long as it is said to.
static void check_chain(oracle_trial *trial, bmr_motion *const motions[2], double time, double until,
                        double tolerance) {
    for (int links = 0; links < 3 && isfinite(time); ++links) {
        trial->condition.normal = bmr_neg(trial->condition.normal);
        trial->condition.offset = -trial->condition.offset;
        const double next = time_of(trial, motions, time, until, tolerance, false);
        const double grown = time + 6.0 * tolerance * fmax(1.0, fabs(time));
        if (isnan(next))
            return;
        if (next > grown && grown < until)
            check_time(trial, grown, until, next, tolerance);
        time = next == time ? INFINITY : next;
    }
}

/// Where a search would take most of its steps (which is a cost, not an answer), a shorter one.
static double nearer(bmr_motion *const motions[2], double after, double until) {
    const double most = 2000.0; // radians
    for (int i = 0; i < 2; ++i) {
        double end;
        for (double t = -INFINITY; !isinf(t) || t < 0.0; t = end) {
            const bmr_motion_piece *piece = bmr_motion_piece_at(motions[i], t, &end);
            const double spin = piece->kind == BMR_PIECE_SCREW ? fabs(piece->as.screw.spin) : 0.0;
            if (spin * (until - after) > most)
                until = after + most / spin;
        }
    }
    return until;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fuzz_bytes bytes = fuzz_bytes_make(data, size);
    const uint8_t how = fuzz_u8(&bytes);
    const bool wild = how % 32 == 31;
    const double tolerance =
        wild && how >= 128 ? fuzz_number(&bytes) : pow(10.0, -13.0 + fuzz_below(&bytes, 11));
    const double after = wild ? fuzz_number(&bytes) : fuzz_in(&bytes, BEGIN, END);
    double until = wild ? fuzz_number(&bytes) : END;
    oracle_trial trial;
    memset(&trial, 0, sizeof trial);
    trial.condition = read_condition(&bytes, wild);
    const fuzz_motion_range range = {3.0, 2.0, 6.0, BEGIN, END, wild, fuzz_control("common-root")};
    bmr_motion *motions[2];
    motions[0] = fuzz_motion(&bytes, &range);
    motions[1] = fuzz_motion(&bytes, &range);
    if (motions[0] && motions[1]) {
        if (wild && how < 248)
            until = nearer(motions, after, until);
        const double time = time_of(&trial, motions, after, until, tolerance, wild);
        if (!wild && !isnan(time)) {
            oracle_read_plan(motions[0], &trial.a);
            oracle_read_plan(motions[1], &trial.b);
            check_time(&trial, after, until, time, tolerance);
            if (how % 4 == 1 && trial.condition.kind != BMR_CONDITION_DISKS)
                check_chain(&trial, motions, time, until, tolerance);
        }
    }
    bmr_motion_destroy(motions[0]);
    bmr_motion_destroy(motions[1]);
    return 0;
}
