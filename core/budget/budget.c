// SPDX-License-Identifier: MIT
#include "boomerang/budget.h"

/// Squares that underflow make it too short by less than 2^-536, which is nothing: what is measured with it
/// is in units, or is multiplied with a reach of less than 2^46 units.
static double length_of(double x, double y) {
    return sqrt(x * x + y * y);
}

/// From one place to another, in units.
static double way_between(bmr_vec2 from, bmr_vec2 to, double units) {
    return length_of((to.x - from.x) * units, (to.y - from.y) * units);
}

/// A body's reach in units; NaN where it is too large or negative.
static double known_reach(const bmr_mover *mover, double units) {
    const double reach = mover->reach * units;
    return reach >= 0.0 && reach < BMR_BUDGET_FARTHEST ? reach : (double)NAN;
}

/// A body's reach in the world: a rotation that is not of unit length scales the body.
static double posed_reach(const bmr_mover *mover, double units) {
    const double reach = known_reach(mover, units) * length_of(mover->c, mover->s);
    return reach < BMR_BUDGET_FARTHEST ? reach : (double)NAN;
}

/// As bmr_budget_motion, up to BMR_BUDGET_TURN.
static uint32_t counted_turning(double turning) {
    const double counted = turning * (1.0 + 0x1p-48) + 1.0;
    return counted < (double)BMR_BUDGET_TURN ? (uint32_t)counted : BMR_BUDGET_TURN;
}

uint32_t bmr_mover_update_moved(bmr_mover *mover, const bmr_pose *pose, bmr_vec2 center, double units) {
    // A point v of the body's frame goes from R v + p to R' v + p'. With v = pivot + w that is the way of the
    // pivot plus (R' - R) w, and R' - R is the matrix of (dc, ds): it scales every w by the length of that.
    const double way = way_between(mover->center, center, units);
    const double turning = known_reach(mover, units) * length_of(pose->c - mover->c, pose->s - mover->s);
    const uint32_t moved = bmr_budget_motion(way + turning, 1.0);
    if (pose->c != mover->c || pose->s != mover->s)
        mover->turned += counted_turning(turning);
    mover->center = center;
    mover->c = pose->c;
    mover->s = pose->s;
    mover->moved += moved;
    return moved;
}

uint32_t bmr_mover_sweep(const bmr_mover *mover, bmr_vec2 from, bmr_vec2 to, double turn, double units) {
    // On a straight way the distance from a fixed point is largest at an end. (Written so that a NaN stays.)
    const double first = way_between(mover->center, from, units);
    const double last = way_between(mover->center, to, units);
    const double way = first >= last ? first : last >= first ? last : (double)NAN;
    // A chord is no longer than its arc, nor than the diameter.
    const double arc = fabs(turn);
    return bmr_budget_motion(way + posed_reach(mover, units) * (arc > 2.0 ? 2.0 : arc), 1.0);
}

/// Whether the way from a's pivot to b's, along a direction, is within what a line holds; it is in units.
static bool find_way(bmr_vec2 along, const bmr_mover *a, const bmr_mover *b, double units, double *way) {
    *way = along.x * ((b->center.x - a->center.x) * units) + along.y * ((b->center.y - a->center.y) * units);
    return fabs(*way) < (double)BMR_BUDGET_MARK;
}

// Why a line is sound. With P the way from a's pivot to b's and w what lies about them, all in units,
// <n, b - a> = <n, P> + <n, wb - wa>. `base` is a lower bound of the last term when the line is made, and
// turning lowers it by no more than it is counted with. P, which is less than 2^47, is known at any time up
// to rounding: to 2 * 3/128 (places), and its product with n to 4 * 2^-53 * 2^47 = 1/16, each when the line
// is made and when it is asked. The other terms of `base`, which are no larger than P and the two reaches
// together where the claim is true, are known to 1/4. All that is less than the one unit that `base` is
// lowered by.
//
// Why 2^27 and 2^28. As long as the line proves something, base less turning is more than -2^27, since the
// way is less than 2^27: turning may go on by 2^31 - 2^27 before the difference wraps. A turn of 2^28 or
// more, which is not counted in full, takes it to -2^27 or below, where no way makes it a proof.

bmr_budget_line bmr_budget_line_make(bmr_vec2 d, double gap, const bmr_mover *a, const bmr_mover *b,
                                     double units) {
    static const bmr_budget_line none = {{0.0f, 0.0f}, 0};
    const double length = length_of(d.x, d.y);
    if (!(length >= 0x1p-500 && length <= 0x1p500))
        return none;
    // Shorter than 1 by more than what rounding to float may make it longer: then <normal, x> is at most |x|.
    const double scale = (1.0 - 0x1p-22) / length;
    const bmr_vec2 n = bmr_scale(scale, d);
    bmr_budget_line line = {{(float)n.x, (float)n.y}, 0};
    double way;
    if (!find_way(n, a, b, units, &way))
        return none;
    // <n, wb - wa> is at least scale * gap - <n, P>; the rounded normal takes no more off than what it is
    // off by, times the reaches.
    const double off = length_of((double)line.normal[0] - n.x, (double)line.normal[1] - n.y);
    const double bound = scale * gap * units - way - off * (posed_reach(a, units) + posed_reach(b, units));
    const double base = floor(bound) - 1.0;
    if (!(fabs(base) < (double)BMR_BUDGET_MARK))
        return none;
    line.base = (uint32_t)(int32_t)base + a->turned + b->turned;
    return line;
}

double bmr_budget_line_gap(const bmr_budget_line *line, const bmr_mover *a, const bmr_mover *b,
                           double units) {
    const bmr_vec2 n = bmr_vec2_make((double)line->normal[0], (double)line->normal[1]);
    double way;
    if ((n.x == 0.0 && n.y == 0.0) || !find_way(n, a, b, units, &way))
        return 0.0;
    const uint32_t left = line->base - a->turned - b->turned;
    const double about = (double)left - (left > INT32_MAX ? 0x1p32 : 0.0); // as a signed number
    return (about + way) / units;
}
