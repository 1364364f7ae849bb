// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_BUDGET_H
#define BOOMERANG_BUDGET_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#include "boomerang/pose.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// Budgets of motion: how far two bodies may still move before the proof that they are apart must be checked
/// again. It is the separation sensitivity of the paper (section 2) for a world that any engine steps: the
/// cost of a pair depends on its events, not on the number of steps.
///
/// The idea. A proof with slack g holds until the two bodies together have carried any of their points by g.
/// Bodies are few, pairs are many. So each step visits the bodies once and adds up how far each can have
/// carried a point of its own (bmr_mover). Each pair keeps one number, its deadline in those sums. While
/// bmr_budget_is_due is false, the pair is apart, and only the deadline and two sums are read.
///
/// In a step of an engine:
///
///     for each body:       bmr_mover_update(&mover, &pose, units);
///     for each pair:       if (!bmr_budget_is_due(deadline, a.moved, b.moved)) continue;   // still apart
///                          if (the pair has a line)                  // renewed without its geometry
///                              slack = bmr_budget_line_gap(&line, &a, &b, units) - threshold;
///                          if (slack <= 0)
///                              test the two shapes as the engine always does; if they are apart, take the
///                              distance that this proves, and make the line from it (bmr_budget_line_make)
///                          deadline = bmr_budget_deadline(slack, a.moved, b.moved, units);
///
/// Lengths are counted in units of 1 / `units` of a length. `units` is positive and the same in all calls for
/// one world. Every motion is rounded up and every slack down. So a pair that is not due is apart by more
/// than its threshold, at the poses as the numbers stand, without a further margin.
///
/// The place of a pivot is rounded, too (bmr_mover_place), by less than 1/32 of a unit. This error does not
/// add up, because motions are counted from one rounded place to the next. Four such places matter to a pair:
/// those of its two bodies when its deadline was made, and at present. Together they are off by less than 1/8
/// of a unit. A pair that is not due has a whole unit left, and a line is made with one to spare.
///
/// Sums have 32 bits and may wrap. That is sound because no budget and no motion is larger than 2^27, and
/// because the caller asks often enough:
///
/// - a deadline is at most BMR_BUDGET_MOST ahead of the sums that it is made from;
/// - one update adds at most BMR_BUDGET_MARK to a body's sum, and so does a mark (bmr_mover_mark) or a growth
/// (bmr_mover_grow); one update adds at most BMR_BUDGET_TURN to the sum of its turning;
/// - the caller asks for a pair's deadline, or makes it anew, before its two sums together have grown by more
/// than 2^31 since it was made;
/// - the caller asks a line before the two sums of turning together have grown by more than 2^31 - 2^27 since
/// the line was made or last proved anything.
///
/// A caller that asks at every update, with at most one mark or growth between two updates, and does not
/// leave due pairs for more than two updates, keeps these rules. If a pair was not asked for a while (its two
/// bodies slept, say), test it the next time without asking its deadline and its line.
///
/// All functions are O(1), allocate nothing and keep no state of their own. Every number of a pose, a reach,
/// a slack or a direction may be any double. A number that is not finite, or too large, counts as a motion of
/// BMR_BUDGET_MARK or as no slack.

/// The largest budget, in units.
#define BMR_BUDGET_MOST ((1u << 27) - 1u)
/// More than every budget. Added to a body's sum, it makes all pairs of the body due.
#define BMR_BUDGET_MARK (1u << 27)
/// The most that one update adds to the sum of a body's turning. So large a turn ends all lines of the body.
#define BMR_BUDGET_TURN (1u << 28)

/// How far one body can have carried its points since it was started. 64 bytes, plain data.
typedef struct bmr_mover {
    bmr_vec2 pivot;  ///< body's frame: the point that it turns about. Any point does; near the middle is best
    bmr_vec2 center; ///< where the pivot was at the last update
    double c, s;     ///< the pose's rotation at the last update
    double reach;    ///< largest distance of a point of the body from the pivot; length units, >= 0
    uint32_t moved;  ///< sum of the motions, in units; modular
    uint32_t turned; ///< sum of the turning alone; modular
} bmr_mover;

/// 2^-48: the arithmetic of this header is off by at most this part. (C++ before 17 has no hexadecimal
/// floats.)
#define BMR_BUDGET_ROUNDING (1.0 / 281474976710656.0)

/// A length (>= 0) in units, rounded up: more than the true length, if the caller has computed it to 2^-50 of
/// itself. BMR_BUDGET_MARK if it is larger than that, or a NaN.
static inline uint32_t bmr_budget_motion(double length, double units) {
    // The two products here are off by 2^-52 together. One more unit is more than what the conversion cuts
    // off.
    const double motion = length * units * (1.0 + BMR_BUDGET_ROUNDING) + 1.0;
    return motion >= 1.0 && motion < (double)BMR_BUDGET_MARK ? (uint32_t)motion : BMR_BUDGET_MARK;
}

/// A body's place is known to a fraction of a unit while all numbers that go into it are below 2^46 units.
/// Beyond that its place is NaN, and each update counts as BMR_BUDGET_MARK.
#define BMR_BUDGET_FARTHEST 70368744177664.0

/// The place of a pivot at a pose. Three roundings, each at most 2^-53 of less than 2^46 units: off by less
/// than 1/32 of a unit. NaN if it is too far away.
static inline bmr_vec2 bmr_mover_place(const bmr_pose *pose, bmr_vec2 pivot, double units) {
    const double size = fabs(pose->position.x) + fabs(pose->position.y) +
                        (fabs(pose->c) + fabs(pose->s)) * (fabs(pivot.x) + fabs(pivot.y));
    return size * units < BMR_BUDGET_FARTHEST ? bmr_transform(pose, pivot)
                                              : bmr_vec2_make((double)NAN, (double)NAN);
}

/// Starts a body: its sums begin at 0. Deadlines and lines that were made with another body in its place, or
/// with another pivot, are invalid.
static inline void bmr_mover_start(bmr_mover *mover, const bmr_pose *pose, bmr_vec2 pivot, double reach,
                                   double units) {
    mover->pivot = pivot;
    mover->center = bmr_mover_place(pose, pivot, units);
    mover->c = pose->c;
    mover->s = pose->s;
    mover->reach = reach;
    mover->moved = mover->turned = 0;
}

/// Makes all pairs of the body due. Lines do not notice a mark: if a shape changed, the caller also forgets
/// the lines of its pairs.
static inline void bmr_mover_mark(bmr_mover *mover) {
    mover->moved += BMR_BUDGET_MARK;
}

/// Adds how far the body can have carried any of its points from the pose of the last update to this one:
/// |way of the pivot| + reach * |change of the rotation|. The second part is also added to the turning. Only
/// the net motion between two updates counts. A body that did not move adds nothing. The rotation need not be
/// of unit length: points are where its matrix puts them. Returns the units that it added to `moved`.
uint32_t bmr_mover_update_moved(bmr_mover *mover, const bmr_pose *pose, bmr_vec2 center, double units);
static inline uint32_t bmr_mover_update(bmr_mover *mover, const bmr_pose *pose, double units) {
    const bmr_vec2 center = bmr_mover_place(pose, mover->pivot, units);
    if (center.x == mover->center.x && center.y == mover->center.y && pose->c == mover->c &&
        pose->s == mover->s)
        return 0;
    return bmr_mover_update_moved(mover, pose, center, units);
}

/// Call this when the body gets points farther from its pivot (another fixture). The sums go on: they were
/// right for the points that the body had. Pairs of the new points begin at this call, and so do lines that
/// are to hold for them. With a reach that is NaN every motion of the body is a mark.
static inline void bmr_mover_extend(bmr_mover *mover, double reach) {
    if (mover->reach < reach || reach != reach)
        mover->reach = reach;
}

/// Call this when the body's skin grows by `by` (a sensor that reaches farther, a growing radius): it counts
/// as motion of all its points. Shrinking needs no call. Lines do not include skins; the threshold that the
/// caller subtracts from bmr_budget_line_gap does.
static inline void bmr_mover_grow(bmr_mover *mover, double by, double units) {
    if (!(by <= 0.0))
        mover->moved += bmr_budget_motion(by, units);
}

/// How far the body can carry any of its points from the pose of the last update, anywhere in a sweep: its
/// pivot goes straight from `from` to `to`, and its rotation is that of the last update, turned by at most
/// |turn| radians. In units, at most BMR_BUDGET_MARK. Adds nothing to the sums. It is for impacts, where a
/// step asks what may happen before the step ends: if bmr_budget_is_due(deadline, a.moved + sweep of a,
/// b.moved + sweep of b) is false, the pair stays apart all the way. The caller adds to `turn` what the
/// engine's own rounding does on the way (to sine and cosine, say).
uint32_t bmr_mover_sweep(const bmr_mover *mover, bmr_vec2 from, bmr_vec2 to, double turn, double units);

/// The deadline of a pair whose distance was `slack` more than its threshold at the last updates. If the
/// slack is not positive, or NaN, the pair is due at once. At most BMR_BUDGET_MOST units count.
static inline uint32_t bmr_budget_deadline(double slack, uint32_t moved_a, uint32_t moved_b, double units) {
    const double budget = slack * units * (1.0 - BMR_BUDGET_ROUNDING);
    const uint32_t most = BMR_BUDGET_MOST;
    const uint32_t whole = budget >= (double)most ? most : budget >= 1.0 ? (uint32_t)budget : 0u;
    return moved_a + moved_b + whole;
}

/// True if the slack may be used up: then test the pair.
static inline bool bmr_budget_is_due(uint32_t deadline, uint32_t moved_a, uint32_t moved_b) {
    const uint32_t left = deadline - moved_a - moved_b;
    return left - 1u >= 0x7fffffffu; // 0, or negative as a signed number
}

/// A certificate's line. It gives a pair its next deadline without the geometry. The direction is fixed in
/// the world: a pair that slides along it, or parts, is renewed for ever, and only turning uses the line up.
/// 12 bytes.
typedef struct bmr_budget_line {
    float normal[2]; ///< from a to b; no longer than 1. Zero: no line
    uint32_t base;   ///< in units; modular
} bmr_budget_line;

/// Makes a line from a direction d in the world. The caller knows that <d, b - a> >= gap for all points a of
/// A and b of B at the poses of the last updates. d may have any length from 2^-500 to 2^500; gap is measured
/// with d as it is. The result is no line (zero) for any other d, if a number is not finite, or if the bodies
/// or their pivots are farther apart along d than 2^27 units.
bmr_budget_line bmr_budget_line_make(bmr_vec2 d, double gap, const bmr_mover *a, const bmr_mover *b,
                                     double units);

/// A lower bound of the distance of the two bodies at the poses of the last updates, in length units. 0 or
/// less if the line proves nothing; do not ask that line again. The rules at the top say how often a line
/// must be asked. Make the pair's next deadline from this slack, less the threshold.
double bmr_budget_line_gap(const bmr_budget_line *line, const bmr_mover *a, const bmr_mover *b, double units);

#ifdef __cplusplus
}
#endif
#endif
