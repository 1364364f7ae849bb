// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_FAILURE_ORACLE_H
#define BMR_TEST_FAILURE_ORACLE_H

#include <math.h>
#include <stdbool.h>

#include "boomerang/failure.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// First failure times judged in long double: dense looks, minima between them sought out. Nothing of core's
/// is used but the motions' own description.

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
    /// What rounding is measured by: the terms that the lengths are sums of, and what a rounding of the time
    /// makes, where true; the lengths themselves, where false (right where terms are about as large).
    bool by_terms;
} oracle_trial;

/// The plan of a motion of at most ORACLE_PIECES pieces.
static inline void oracle_read_plan(const bmr_motion *motion, oracle_plan *plan) {
    plan->count = 0;
    double t = -INFINITY;
    do {
        double end;
        plan->from[plan->count] = t;
        plan->pieces[plan->count++] = *bmr_motion_piece_at(motion, t, &end);
        t = end;
    } while (!isinf(t) && plan->count < ORACLE_PIECES);
}

/// The condition's value; *size (or NULL): the lengths that go into it.
long double oracle_value(const oracle_trial *trial, long double time, long double *size);

/// What a value may be below zero, in parts of the lengths that go into it: the header's 1e-14, times the
/// growth over one interval and the number of terms of the algebraic ones.
#define ORACLE_SLACK 2e-12L

/// The least value in [low, high], by golden section.
long double oracle_least(const oracle_trial *trial, long double low, long double high);

typedef struct oracle_verdict {
    bool late, early;
    long double worst; ///< the least value before the time, over the lengths involved
} oracle_verdict;

/// Enough for motions of some turns.
#define ORACLE_LOOKS 600
/// Judges a failure time (INFINITY: none until `until`) by so many looks at the time before it. Late: the
/// value was below zero before. Early: it is above until `tolerance` after.
oracle_verdict oracle_judge(const oracle_trial *trial, double after, double until, double time,
                            double tolerance, int looks);

#ifdef __cplusplus
}
#endif
#endif
