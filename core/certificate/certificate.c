// SPDX-License-Identifier: MIT
#include "boomerang/certificate.h"

#include <math.h>

#include "boomerang/condition.h"
#include "geometry/length.h"

/// No two points whose coordinates are at most 1 are farther apart than this: 2 sqrt 2, rounded up.
#define DIAMETER_OF_EXTENT 2.8284271247461907
/// No point whose coordinates are at most 1 is farther from the origin than this: sqrt 2, rounded up.
#define RADIUS_OF_EXTENT 1.4142135623730954

/// How far (radians) the direction can really be outside the bracket when the check lets it pass. The check
/// compares a sine, of vectors whose length is off by some 1e-7: BMR_ROLL_TOLERANCE * (1 + 1e-6). Rounding
/// `low` or `high` to float turns it by at most sqrt(2) * 2^-25. Together less than 2^-20 + 2^-23.
#define BRACKET_ERROR (BMR_ROLL_TOLERANCE + 1.1920928955078125e-7)

/// What a check may be off by, in parts of the extents, beside what it allows for itself: a few dozen
/// roundings of 2^-53, of values of at most 4 extents, and a pose that is off unit length by 2^-50. Where the
/// position is larger than that, the bodies are apart by more than any error.
#define EVALUATION_ERROR 1.4210854715202004e-14 /* 2^-46 */

static double largest(bmr_vec2 v) {
    const double x = fabs(v.x), y = fabs(v.y);
    return x > y ? x : y;
}

/// A normal that rounding to float made longer than 1 is shortened by this before it is rounded again: more
/// than the rounding can lengthen it.
#define SHORTER (1.0 - 0x1p-23)

/// The normal as floats, of length at most 1: a gap along a shorter vector than a unit vector is less than
/// the distance, which is the safe side.
static void round_normal(bmr_vec2 normal, float rounded[2]) {
    const double square = bmr_dot(normal, normal);
    if (square > 1.0 + 0x1p-40) // no unit vector
        normal = bmr_scale(1.0 / sqrt(square), normal);
    rounded[0] = (float)normal.x;
    rounded[1] = (float)normal.y;
    const double x = (double)rounded[0], y = (double)rounded[1];
    if (x * x + y * y > 1.0) {
        rounded[0] = (float)(normal.x * SHORTER);
        rounded[1] = (float)(normal.y * SHORTER);
    }
}

/// A float not less than x: rounding takes at most 2^-24 of it away (or the least float, near zero).
static float round_up(double x) {
    return (float)(x + (fabs(x) * 0x1p-23 + 0x1p-149));
}

/// A bound of the distance that rounding moved a vector.
static double moved(bmr_vec2 exact, const float rounded[2]) {
    return fabs(exact.x - (double)rounded[0]) + fabs(exact.y - (double)rounded[1]);
}

static double larger(double a, double b) {
    return a > b ? a : b; // fmax is a call of the library
}

void bmr_certificate_fill(bmr_certificate *certificate, bmr_vec2 normal, double offset,
                          const bmr_vec2 *window, int window_count, bmr_vec2 low, bmr_vec2 high,
                          double owner_extent, double other_extent) {
    bmr_certificate *k = certificate;
    round_normal(normal, k->normal);
    // For the line: <rounded, x> <= <normal, x> + |difference| |x|.
    double loss = moved(normal, k->normal) * RADIUS_OF_EXTENT * owner_extent;
    double reach = other_extent, window_loss = 0.0;
    for (int i = 0; i < 2; ++i) {
        const bmr_vec2 w = window[i < window_count ? i : 0];
        k->window[i][0] = (float)w.x;
        k->window[i][1] = (float)w.y;
        window_loss = larger(window_loss, moved(w, k->window[i]));
        reach = larger(reach, largest(w));
    }
    loss += window_loss;
    k->low[0] = (float)low.x;
    k->low[1] = (float)low.y;
    k->high[0] = (float)high.x;
    k->high[1] = (float)high.y;
    // Outside the bracket by an angle, the support moves away from the window by at most that angle times its
    // distance from it.
    if (low.x != 0.0 || low.y != 0.0)
        loss += BRACKET_ERROR * DIAMETER_OF_EXTENT * reach;
    loss += EVALUATION_ERROR * (owner_extent + reach);
    k->offset = round_up(offset + loss);
}

/// What the audit grants the window beside its own rounding to float: the bracket's ends are rounded too. The
/// offset has more than this added to it.
#define WINDOW_AUDIT_TOLERANCE 4.76837158203125e-7 /* 2^-21 */

/// Does the window bound every vertex of `other` in `direction`?
static bool bounds(const bmr_certificate *k, const bmr_polygon *other, bmr_vec2 direction) {
    double reach = other->extent, support = -INFINITY;
    for (int i = 0; i < 2; ++i) {
        const bmr_vec2 w = bmr_vec2_make((double)k->window[i][0], (double)k->window[i][1]);
        support = fmax(support, bmr_dot(w, direction));
        reach = fmax(reach, largest(w));
    }
    support += WINDOW_AUDIT_TOLERANCE * reach;
    for (uint32_t i = 0; i < other->count; ++i)
        if (!(bmr_dot(other->vertices[i], direction) <= support))
            return false;
    return true;
}

/// Is the window an outer bound throughout the bracket? For a vertex y, <y, d> - max <window, d> is linear in
/// d on either side of the direction in which the window's two points tie: the ends of these two cones
/// decide.
static bool window_holds(const bmr_certificate *k, const bmr_polygon *other) {
    const bmr_vec2 low = bmr_vec2_make((double)k->low[0], (double)k->low[1]);
    const bmr_vec2 high = bmr_vec2_make((double)k->high[0], (double)k->high[1]);
    const bmr_vec2 chord = bmr_vec2_make((double)k->window[0][0] - (double)k->window[1][0],
                                         (double)k->window[0][1] - (double)k->window[1][1]);
    if (low.x == 0.0 && low.y == 0.0 && high.x == 0.0 && high.y == 0.0) {
        // Every direction: two half planes of directions, one for each point of the window. Their common ends
        // and their middles decide. (Only a point or a segment has such a window.)
        const bmr_vec2 axis = chord.x != 0.0 || chord.y != 0.0 ? chord : bmr_vec2_make(1.0, 0.0);
        const bmr_vec2 along = bmr_scale(1.0 / sqrt(bmr_dot(axis, axis)), axis), across = bmr_left(along);
        return bounds(k, other, along) && bounds(k, other, bmr_neg(along)) && bounds(k, other, across) &&
               bounds(k, other, bmr_neg(across));
    }
    if (!(bmr_cross(low, high) >= -BRACKET_ERROR)) // wider than 180 degrees
        return false;
    if (!bounds(k, other, low) || !bounds(k, other, high))
        return false;
    const double length = sqrt(bmr_dot(chord, chord));
    if (!(length > 0.0))
        return true;
    bmr_vec2 tie = bmr_scale(1.0 / length, bmr_left(chord));
    if (bmr_dot(tie, bmr_add(low, high)) < 0.0)
        tie = bmr_neg(tie);
    const bool inside = bmr_cross(low, tie) > 0.0 && bmr_cross(tie, high) > 0.0;
    return !inside || bounds(k, other, tie);
}

bmr_error bmr_certificate_audit(const bmr_certificate *certificate, const bmr_polygon *owner,
                                const bmr_polygon *other, const bmr_pose *other_in_owner) {
    const bmr_certificate *k = certificate;
    const bmr_vec2 n = bmr_vec2_make((double)k->normal[0], (double)k->normal[1]);
    double support = -INFINITY;
    for (uint32_t i = 0; i < owner->count; ++i)
        support = fmax(support, bmr_dot(n, owner->vertices[i]));
    double gap;
    const bmr_check check = bmr_certificate_check(k, other_in_owner, 0.0, &gap);
    if (!(bmr_dot(n, n) <= 1.0) || !(support <= (double)k->offset) || check == BMR_CHECK_ROLLED ||
        !window_holds(k, other))
        return BMR_ERROR_FALSE_CERTIFICATE;
    for (uint32_t i = 0; i < other->count; ++i) {
        const bmr_vec2 y = bmr_transform(other_in_owner, other->vertices[i]);
        if (!(gap <= bmr_dot(n, y) - support))
            return BMR_ERROR_FALSE_CERTIFICATE;
    }
    return BMR_OK;
}

// ---- conditions ----

bmr_condition bmr_condition_beyond(int owner, bmr_vec2 normal, double offset, bmr_vec2 point, int label) {
    bmr_condition k = {normal, offset, point, BMR_CONDITION_BEYOND, (uint8_t)owner, (uint8_t)label, {0}};
    return k;
}

bmr_condition bmr_condition_turn(int owner, bmr_vec2 normal, bmr_vec2 direction, int label) {
    bmr_condition k = {normal, 0.0, direction, BMR_CONDITION_TURN, (uint8_t)owner, (uint8_t)label, {0}};
    return k;
}

bmr_condition bmr_condition_disks(bmr_vec2 center_a, bmr_vec2 center_b, double reach, int label) {
    bmr_condition k = {center_a, reach, center_b, BMR_CONDITION_DISKS, 0, (uint8_t)label, {0}};
    return k;
}

double bmr_condition_value(const bmr_condition *condition, const bmr_pose *b_in_a) {
    const bmr_pose other_in_owner = condition->owner == 0 ? *b_in_a : bmr_pose_inverse(b_in_a);
    switch (condition->kind) {
    case BMR_CONDITION_BEYOND:
        return bmr_dot(condition->normal, bmr_transform(&other_in_owner, condition->point)) -
               condition->offset;
    case BMR_CONDITION_TURN:
        return bmr_cross(condition->normal, bmr_rotate(&other_in_owner, condition->point));
    default: {
        const bmr_vec2 d = bmr_sub(bmr_transform(&other_in_owner, condition->point), condition->normal);
        return bmr_length(d) - condition->offset;
    }
    }
}
