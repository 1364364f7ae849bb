// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_CERTIFICATE_H
#define BOOMERANG_CERTIFICATE_H

#include "boomerang/polygon.h"

#ifdef __cplusplus
extern "C" {
#endif

/// What proves two convex bodies apart, as plain data: a line that holds all of the owner on one side, and a
/// window of the other body that is known to be the nearest to that line while the direction stays within a
/// bracket.
///
/// It is in floats, so that it fits a cache line with room for its pair; every rounding made on the way into
/// it is already in `offset`, so that the gap computed from it in double is a lower bound of the true one.
typedef struct bmr_certificate {
    float normal[2]; ///< owner's frame, unit length up to float rounding
    float offset;    ///< <normal, x> <= offset for all x of the owner, with the window's and bracket's errors
                     ///< added
    float window[2][2]; ///< other body's frame: in every direction of the bracket the body's support is at
                        ///< most the window's
    float low[2];  ///< other body's frame: the bracket [low, high], counter-clockwise, at most 180 degrees,
    float high[2]; ///< of directions -normal for which the window holds. low = high = 0: every direction.
} bmr_certificate;

/// How far (radians) a direction may leave the bracket unnoticed: flat on flat, the direction sits ON the
/// bracket's end and float rounding must not make it roll for ever. Its price, BMR_ROLL_TOLERANCE times the
/// other body's diameter, is in `offset`.
#define BMR_ROLL_TOLERANCE 9.5367431640625e-7 /* 2^-20 */

/// What a look at a certificate says.
typedef enum bmr_check {
    BMR_CHECK_HOLDS,   ///< the line separates by more than the margin
    BMR_CHECK_CROSSED, ///< the window may have come nearer than the margin: push or stab
    BMR_CHECK_ROLLED   ///< the direction left the bracket: roll
} bmr_check;

/// Looks at a certificate of the owner's frame against the pose of the other body in it. `*gap` gets a lower
/// bound of the distance between the two bodies, valid when the result is HOLDS or CROSSED. O(1), touches the
/// certificate alone. A NaN anywhere never gives HOLDS.
static inline bmr_check bmr_certificate_check(const bmr_certificate *k, const bmr_pose *other_in_owner,
                                              double margin, double *gap) {
    const double nx = (double)k->normal[0], ny = (double)k->normal[1];
    const double c = other_in_owner->c, s = other_in_owner->s;
    // u = the normal as the other body sees it; its supports lie in direction -u.
    const double ux = c * nx + s * ny, uy = c * ny - s * nx;
    const double px = other_in_owner->position.x, py = other_in_owner->position.y;
    const double w0 = ux * (double)k->window[0][0] + uy * (double)k->window[0][1];
    const double w1 = ux * (double)k->window[1][0] + uy * (double)k->window[1][1];
    const double a = nx * px, b = ny * py;
    // 2^-50 of the summands covers the rounding of this very expression.
    const double rest =
        (a + b) - (double)k->offset - 8.8817841970012523e-16 * ((a < 0 ? -a : a) + (b < 0 ? -b : b));
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

/// Fills a certificate: the line <normal, x> <= offset of the owner, and a window of one or two points of the
/// other body valid in the bracket [low, high] (both zero: everywhere). The three directions have unit
/// length; `other_extent` bounds the magnitude of the other body's coordinates, `owner_extent` the owner's.
/// O(1).
///
/// Roundings go into the offset, so that the gap at a pose is lower than the true gap <normal, window> + .. -
/// offset there by at most BMR_CERTIFICATE_LOSS * (owner_extent + W) and 2^-22 of itself, W the larger of
/// other_extent and the window's largest coordinate. It stays a lower bound for poses whose (c, s) is of unit
/// length up to 2^-50.
#define BMR_CERTIFICATE_LOSS 3.5e-6
void bmr_certificate_fill(bmr_certificate *certificate, bmr_vec2 normal, double offset,
                          const bmr_vec2 *window, int window_count, bmr_vec2 low, bmr_vec2 high,
                          double owner_extent, double other_extent);

/// Re-proves a certificate from nothing but the two polygons: the line holds the whole owner (every vertex),
/// the window is an outer bound of every vertex of the other throughout the bracket, the direction at this
/// pose lies in the bracket, and the gap that bmr_certificate_check reports there is not larger than that of
/// any vertex of the other. O(n). OK, or BMR_ERROR_FALSE_CERTIFICATE.
bmr_error bmr_certificate_audit(const bmr_certificate *certificate, const bmr_polygon *owner,
                                const bmr_polygon *other, const bmr_pose *other_in_owner);

#ifdef __cplusplus
}
#endif
#endif
