// SPDX-License-Identifier: MIT
// First failure times of conditions under fuzzed motions, against dense looks in long double: never late,
// never early by more than the tolerance. Where numbers are wild, the contract alone: an error or a time in
// range.
#include <stdlib.h>

#include "boomerang/failure.h"
#include "failure_oracle.h"
#include "harness.h"
#include "paths.h"

#define LOOKS 150
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
    const oracle_verdict v = oracle_judge(trial, after, until, time, isinf(time) ? 0.0 : width, LOOKS);
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
    trial.by_terms = true;
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
