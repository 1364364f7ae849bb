// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_CERTIFICATE_H
#define BOOMERANG_CERTIFICATE_H

#include "boomerang/polygon.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A proof that two convex bodies are apart, as plain data. A line has all of the owner on one side. A window
/// of one or two points represents the other body: while the line's direction stays within a bracket, no
/// point of that body is nearer to the line than the window is.
///
/// It is in floats, so that it fits a cache line together with its pair. Every rounding made on the way into
/// it is in `offset`. So the gap computed from it in double is a lower bound of the true gap.
typedef struct bmr_certificate {
    float normal[2]; ///< owner's frame, unit length up to float rounding
    float offset;    ///< <normal, x> <= offset for all x of the owner, plus the errors of window and bracket
    float window[2][2]; ///< other body's frame: in every direction of the bracket the body's support is at
                        ///< most the window's
    float low[2];  ///< other body's frame: the bracket [low, high], counter-clockwise, at most 180 degrees,
    float high[2]; ///< of directions -normal for which the window holds. low = high = 0: every direction.
} bmr_certificate;

/// A direction outside of the bracket by no more than this (radians) counts as inside. If a flat side slides
/// on a flat side, the direction is exactly the bracket's end, and without this the rounding of floats would
/// make the pair roll at every step. `offset` includes what it costs: BMR_ROLL_TOLERANCE times the other
/// body's diameter.
#define BMR_ROLL_TOLERANCE 9.5367431640625e-7 /* 2^-20 */

/// The result of a check.
typedef enum bmr_check {
    BMR_CHECK_HOLDS,   ///< the line separates by more than the margin
    BMR_CHECK_CROSSED, ///< the window may have come nearer than the margin: push or stab
    BMR_CHECK_ROLLED   ///< the direction left the bracket: roll
} bmr_check;

/// Covers what the check's own arithmetic loses on the position: less than 4 units in the last place of it.
#define BMR_CHECK_ROUNDING 1.7763568394002505e-15 /* 2^-49 */

/// Checks a certificate at a pose of B in A's frame. `owner` says whose the line is (0: A's, 1: B's). `*gap`
/// gets a lower bound of the distance of the two bodies, valid if the result is HOLDS or CROSSED. O(1), reads
/// the certificate alone. A NaN anywhere never gives HOLDS.
///
/// The gap is min <u, window> + <q, position> - offset. Here u is the normal turned into the other body's
/// frame. q is the same direction in A's frame, in which the position is given: the normal itself if A owns
/// the line, -u if B does. So no pose is ever inverted. 2^-49 of the position is subtracted from the gap,
/// which covers the rounding of this expression.
static inline bmr_check bmr_certificate_check_pair(const bmr_certificate *k, const bmr_pose *b_in_a,
                                                   int owner, double margin, double *gap) {
    const double nx = (double)k->normal[0], ny = (double)k->normal[1];
    const double c = b_in_a->c, s = owner ? -b_in_a->s : b_in_a->s;
    const double ux = c * nx + s * ny, uy = c * ny - s * nx;
    const double px = b_in_a->position.x, py = b_in_a->position.y;
    const double w0 = ux * (double)k->window[0][0] + uy * (double)k->window[0][1];
    const double w1 = ux * (double)k->window[1][0] + uy * (double)k->window[1][1];
    const double a = (owner ? -ux : nx) * px - BMR_CHECK_ROUNDING * (px < 0 ? -px : px);
    const double b = (owner ? -uy : ny) * py - BMR_CHECK_ROUNDING * (py < 0 ? -py : py);
    const double rest = (a + b) - (double)k->offset;
    const double f0 = w0 + rest, f1 = w1 + rest;
    const double lx = (double)k->low[0], ly = (double)k->low[1];
    const double hx = (double)k->high[0], hy = (double)k->high[1];
    const double past_low = ly * ux - lx * uy;  // cross(low, -u)
    const double past_high = hx * uy - hy * ux; // cross(-u, high)
    // A bracket no wider than the tolerance would let the opposite direction pass as well: it must be ahead.
    const double behind = (lx + hx) * ux + (ly + hy) * uy; // dot(low + high, u)
    *gap = f0 < f1 ? f0 : f1;
    if (!(past_low >= -BMR_ROLL_TOLERANCE && past_high >= -BMR_ROLL_TOLERANCE &&
          behind <= BMR_ROLL_TOLERANCE))
        return BMR_CHECK_ROLLED;
    return f0 > margin && f1 > margin ? BMR_CHECK_HOLDS : BMR_CHECK_CROSSED; // both: one may be NaN
}

/// The same for an owner A.
static inline bmr_check bmr_certificate_check(const bmr_certificate *k, const bmr_pose *other_in_owner,
                                              double margin, double *gap) {
    return bmr_certificate_check_pair(k, other_in_owner, 0, margin, gap);
}

/// Fills a certificate: the line <normal, x> <= offset of the owner, and a window of one or two points of the
/// other body that is valid in the bracket [low, high] (both zero: everywhere). The three directions have
/// unit length. `other_extent` bounds the magnitude of the other body's coordinates, `owner_extent` that of
/// the owner's. O(1).
///
/// Roundings go into the offset. So the gap at a pose is lower than the true gap <normal, window> + .. -
/// offset there, by at most BMR_CERTIFICATE_LOSS * (owner_extent + W) and 2^-22 of itself; W is the larger of
/// other_extent and the window's largest coordinate. It stays a lower bound for poses whose (c, s) is of unit
/// length up to 2^-50.
#define BMR_CERTIFICATE_LOSS 3.5e-6
void bmr_certificate_fill(bmr_certificate *certificate, bmr_vec2 normal, double offset,
                          const bmr_vec2 *window, int window_count, bmr_vec2 low, bmr_vec2 high,
                          double owner_extent, double other_extent);

/// Proves a certificate again from the two polygons alone: the line has every vertex of the owner behind it;
/// the window bounds every vertex of the other throughout the bracket; the direction at this pose lies in the
/// bracket; the gap that bmr_certificate_check reports there is not larger than that of any vertex of the
/// other. O(n). OK, or BMR_ERROR_FALSE_CERTIFICATE.
bmr_error bmr_certificate_audit(const bmr_certificate *certificate, const bmr_polygon *owner,
                                const bmr_polygon *other, const bmr_pose *other_in_owner);

#ifdef __cplusplus
}
#endif
#endif
