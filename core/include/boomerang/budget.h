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
/// Budgets of motion: how far two bodies may still move before a proof that they are apart has to be looked
/// at again. The separation sensitivity of the paper (section 2) for a world that is sampled step by step,
/// whatever engine steps it: a pair costs its events, not the steps between them.
///
/// The thought. A proof with slack g stays a proof until the two bodies together have carried any of their
/// points by g. Bodies are few, pairs are many. So each step sweeps the bodies once and adds up how far each
/// can have carried a point of its own (bmr_mover). Each pair keeps one number, its deadline in those sums.
/// While `bmr_budget_is_due` says no, nothing of the pair is read but the deadline and two sums.
///
/// In a step of an engine:
///
///     for each body:       bmr_mover_look(&mover, &pose, units);
///     for each pair:       if (!bmr_budget_is_due(deadline, a.moved, b.moved)) continue;   // still apart
///                          if (the pair has a line)                  // renewed without its geometry
///                              slack = bmr_budget_line_gap(&line, &a, &b, units) - threshold;
///                          if (slack <= 0)
///                              look at the two shapes as the engine always does; if they are apart, take the
///                              distance that this proves, and make the line from it (bmr_budget_line_make)
///                          deadline = bmr_budget_deadline(slack, a.moved, b.moved, units);
///
/// Lengths are counted in units of 1 / `units` of a length: `units` is positive, and the same in all calls
/// for one world. Every motion is rounded up, every slack down, so that a pair that is not due is apart by
/// more than its threshold at the poses as the numbers stand, without a further margin.
///
/// What no motion counts is that the place of a pivot is rounded, too (bmr_mover_place): by less than 1/32 of
/// a unit. It does not add up, since motions are counted from one rounded place to the next. A pair sees four
/// such places: its two bodies' when its deadline was made, and now. Less than 1/8 of a unit in all: a pair
/// that is not due has one whole unit left, and a line is made with one unit to spare.
///
/// Sums are modular: 32 bits that may wrap. What makes that sound is that no budget and no one motion is
/// larger than 2^27:
///
/// - a deadline is at most BMR_BUDGET_MOST ahead of the sums that it is made from;
/// - one look adds at most BMR_BUDGET_MARK to a body's sum, a mark (bmr_mover_mark) or a growth
///   (bmr_mover_grow) the same; one look adds at most BMR_BUDGET_TURN to the sum of its turning;
/// - whoever keeps a pair's deadline asks for it, or makes it anew, before its two sums together have gone on
///   by more than 2^31 since it was made; and a line, before the two sums of turning together have gone on by
///   more than 2^31 - 2^27 since it was made or last proved anything.
///
/// A caller that asks at every look, with at most one mark or growth between two, and does not leave due
/// pairs for more than two looks, keeps well within that. A pair that is not asked for (of two bodies that
/// sleep, say) is to be looked at when it is asked for again, whatever its deadline and its line say.
///
/// All functions are O(1), allocate nothing, keep no state of their own. Every number of a pose, a reach, a
/// slack or a direction may be any double: what is not finite, or too large, counts as a motion of
/// BMR_BUDGET_MARK or as no slack at all.

/// No budget is larger.
#define BMR_BUDGET_MOST ((1u << 27) - 1u)
/// More than every budget. Added to a body's sum, it makes all of the body's pairs due.
#define BMR_BUDGET_MARK (1u << 27)
/// The most that one look adds to the sum of a body's turning. After it no line of the body proves anything.
#define BMR_BUDGET_TURN (1u << 28)

/// How far one body can have carried its points since it was first looked at. 64 bytes, plain data.
typedef struct bmr_mover {
    bmr_vec2 pivot;  ///< in the body's frame: what it turns about. Any point does; near the middle is best.
    bmr_vec2 center; ///< where the pivot was at the last look
    double c, s;     ///< the pose's rotation at the last look
    double reach;    ///< in the body's frame no point of it is farther from the pivot; length units, >= 0
    uint32_t moved;  ///< sum of the motions, in units; modular
    uint32_t turned; ///< sum of the turning alone; modular
} bmr_mover;

/// 2^-48, what this header's arithmetic is rounded by at most. (C++ before 17 has no hexadecimal floats.)
#define BMR_BUDGET_ROUNDING (1.0 / 281474976710656.0)

/// A length (>= 0) in units, rounded up: more than the length, also where the caller's own arithmetic had it
/// too small by 2^-50 of itself. BMR_BUDGET_MARK where it is larger or no number.
static inline uint32_t bmr_budget_motion(double length, double units) {
    // The two products here are off by 2^-52 together. One more unit is more than what the conversion cuts
    // off.
    const double motion = length * units * (1.0 + BMR_BUDGET_ROUNDING) + 1.0;
    return motion >= 1.0 && motion < (double)BMR_BUDGET_MARK ? (uint32_t)motion : BMR_BUDGET_MARK;
}

/// Coordinates are known to a fraction of a unit as long as all that goes into them is less than 2^46 units.
/// Beyond that the place of a body is not known at all (NaN), and neither is its motion.
#define BMR_BUDGET_FARTHEST 70368744177664.0

/// Where a pivot is at a pose. Three roundings, each at most 2^-53 of less than 2^46 units: off by less than
/// 1/32 of a unit. NaN where it is too far.
static inline bmr_vec2 bmr_mover_place(const bmr_pose *pose, bmr_vec2 pivot, double units) {
    const double size = fabs(pose->position.x) + fabs(pose->position.y) +
                        (fabs(pose->c) + fabs(pose->s)) * (fabs(pivot.x) + fabs(pivot.y));
    return size * units < BMR_BUDGET_FARTHEST ? bmr_transform(pose, pivot)
                                              : bmr_vec2_make((double)NAN, (double)NAN);
}

/// A body that nobody has looked at yet: its sums begin at 0. Deadlines and lines that were made with another
/// body in its place (or with another pivot) mean nothing for it.
static inline void bmr_mover_start(bmr_mover *mover, const bmr_pose *pose, bmr_vec2 pivot, double reach,
                                   double units) {
    mover->pivot = pivot;
    mover->center = bmr_mover_place(pose, pivot, units);
    mover->c = pose->c;
    mover->s = pose->s;
    mover->reach = reach;
    mover->moved = mover->turned = 0;
}

/// All pairs of the body are due at once. (Lines know nothing of a mark: where a shape changed, the caller
/// forgets the lines of its pairs, too.)
static inline void bmr_mover_mark(bmr_mover *mover) {
    mover->moved += BMR_BUDGET_MARK;
}

/// Adds how far the body can have carried any of its points from the pose of the last look to this one:
/// |way of the pivot| + reach * |change of the rotation|, whose second part is also the turning. It is the
/// net motion that counts: what a body does between two looks and takes back costs nothing. A body that did
/// not move at all adds nothing. The rotation need not be of unit length: points are where its matrix puts
/// them. Returns the units that it added to `moved`.
uint32_t bmr_mover_look_moved(bmr_mover *mover, const bmr_pose *pose, bmr_vec2 center, double units);
static inline uint32_t bmr_mover_look(bmr_mover *mover, const bmr_pose *pose, double units) {
    const bmr_vec2 center = bmr_mover_place(pose, mover->pivot, units);
    if (center.x == mover->center.x && center.y == mover->center.y && pose->c == mover->c &&
        pose->s == mover->s)
        return 0;
    return bmr_mover_look_moved(mover, pose, center, units);
}

/// The body has got points that are farther from its pivot (a fixture more). The sums go on: what was counted
/// was right for the points that it had. Pairs of the new points begin now, and so do lines that are to hold
/// for them. A reach that is no number stays so: every motion of the body is then a mark.
static inline void bmr_mover_extend(bmr_mover *mover, double reach) {
    if (mover->reach < reach || reach != reach)
        mover->reach = reach;
}

/// The body's skin has grown by so much (a sensor that reaches farther, a growing radius): counts as motion
/// of all its points. Shrinking costs nothing and need not be told. Lines know nothing of skins: these belong
/// to the threshold that the caller takes off bmr_budget_line_gap.
static inline void bmr_mover_grow(bmr_mover *mover, double by, double units) {
    if (!(by <= 0.0))
        mover->moved += bmr_budget_motion(by, units);
}

/// How far the body can carry any of its points from the pose of the last look, anywhere in a sweep: its
/// pivot goes straight from `from` to `to`, and its rotation is that of the last look, turned by an angle of
/// at most |turn| (radians). In units, at most BMR_BUDGET_MARK. Adds nothing: for impacts, where a step asks
/// what may happen before it ends. A pair for which `bmr_budget_is_due(deadline, a.moved + sweep of a,
/// b.moved + sweep of b)` says no stays apart all the way. What an engine's own rounding does on the way (to
/// the sine and cosine of its angle, say) is the caller's to add to `turn`.
uint32_t bmr_mover_sweep(const bmr_mover *mover, bmr_vec2 from, bmr_vec2 to, double turn, double units);

/// The deadline of a pair that is apart by `slack` more than it has to be, at the poses of the last looks. No
/// slack, or none that is a number: due at once. At most BMR_BUDGET_MOST units count.
static inline uint32_t bmr_budget_deadline(double slack, uint32_t moved_a, uint32_t moved_b, double units) {
    const double budget = slack * units * (1.0 - BMR_BUDGET_ROUNDING);
    const uint32_t most = BMR_BUDGET_MOST;
    const uint32_t whole = budget >= (double)most ? most : budget >= 1.0 ? (uint32_t)budget : 0u;
    return moved_a + moved_b + whole;
}

/// True as soon as the slack may be used up: then the pair is to be looked at.
static inline bool bmr_budget_is_due(uint32_t deadline, uint32_t moved_a, uint32_t moved_b) {
    const uint32_t left = deadline - moved_a - moved_b;
    return left - 1u >= 0x7fffffffu; // 0, or negative as a signed number
}

/// What is left of the budget, in units; 0 where it is due.
static inline uint32_t bmr_budget_left(uint32_t deadline, uint32_t moved_a, uint32_t moved_b) {
    return bmr_budget_is_due(deadline, moved_a, moved_b) ? 0u : deadline - moved_a - moved_b;
}

/// A certificate's line, which renews a pair's deadline without its geometry. The direction is fixed in the
/// world: a pair that slides along it, or parts, is renewed for ever; turning uses it up. 12 bytes.
typedef struct bmr_budget_line {
    float normal[2]; ///< from a to b; no longer than 1. Zero: no line
    uint32_t base;   ///< in units; modular
} bmr_budget_line;

/// From a direction d, in the world, of which it is known that <d, b - a> >= gap for all points a of A and b
/// of B at the poses of the last looks. d may have any length from 2^-500 to 2^500; gap is measured with it
/// as it is. No line (zero) of any other d, where a number is not finite, or where the bodies or their pivots
/// are farther apart along d than 2^27 units.
bmr_budget_line bmr_budget_line_make(bmr_vec2 d, double gap, const bmr_mover *a, const bmr_mover *b,
                                     double units);

/// A lower bound of the distance of the two bodies at the poses of the last looks, length units; 0 or less
/// where the line proves nothing. How often a line is to be asked: above; one that proves nothing is not to
/// be asked again. A pair that was apart by this slack gets its next deadline from it.
double bmr_budget_line_gap(const bmr_budget_line *line, const bmr_mover *a, const bmr_mover *b, double units);

#ifdef __cplusplus
}
#endif
#endif
