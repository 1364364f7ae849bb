// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_THRESHOLDS_H
#define BOOMERANG_GLUE_THRESHOLDS_H

#include <cfloat>

#include <box2d/b2_common.h>

namespace bmr {

/// What is added to every threshold for the rounding of Box2D's own arithmetic.
constexpr double kRoundingMargin = 0.2 * b2_linearSlop;

/// b2CollidePolygons clips in world coordinates x. A transformed point is off by 3 u |x| (u = FLT_EPSILON /
/// 2), its dot product with a normal by 7.3 u |x|, a clipped point's separation by less than 16 u |x|; a
/// clipped corner (side and separation both off) by sqrt(2) times that. So up to this distance from the
/// origin, extents included, all of it stays within kRoundingMargin; beyond, pairs go to Box2D.
constexpr double kReach = kRoundingMargin / (16.0 * FLT_EPSILON);

/// b2CollidePolygons gives no points when the polygons are farther apart than this: it keeps points whose
/// separation is at most the sum of the radii and whose side offset is at most the same, so nothing beyond
/// the diagonal.
inline double ContactMargin(double radiusSum) {
    constexpr double kDiagonal = 1.4142135623730951;
    return kDiagonal * (radiusSum > 0.0 ? radiusSum : 0.0) + kRoundingMargin;
}

/// b2TimeOfImpact says "touching" where its distance of the core polygons, or the separation of two of their
/// points along its axis, is at most this somewhere on the way.
inline float ImpactDistance(float radiusSum) {
    const float target = radiusSum - 3.0f * b2_linearSlop;
    return (b2_linearSlop > target ? b2_linearSlop : target) + 0.25f * b2_linearSlop; // a NaN stays one
}

/// Half a unit in the last place of 1: what one float operation may be off by, relatively.
constexpr float kUnit = 0.5f * FLT_EPSILON;

/// How far Box2D's arithmetic may be off for one of two moving shapes, in terms of the largest coordinate X
/// of its points in the world, their largest distance R from the body's origin, and the body's angle; in
/// kUnit. The sum of both shapes' is what a proof must leave beside ImpactDistance (or beside the sum of the
/// radii, for a sensor).
///
/// - X: interpolating the centre 3 X per coordinate, the transform 2 X; 7.1 X in length. The closest point, a
///   mean of two such points, 4.3 X more; the points of an axis 2.8 X. Our own difference of the centres and
///   its product with a direction 6 X. Together 20.2.
/// - R: transforming a point 16 R, a support's choice 11 R, an axis' product 12 R, our own 8 R, sine and
///   cosine and the interpolated angle (at most a turn and a half once it is normalised) 64 R. Together 111.
/// - angle: b2Sweep::Normalize takes off a multiple of a 2 pi that is off by 0.5 units, and rounds: 1.5 units
///   of the angle; that from which we start and its difference 1 each. Together 3.5.
constexpr float kErrorPerCoordinate = 32.0f, kErrorPerReach = 128.0f, kErrorPerAngle = 4.0f;

/// b2TimeOfImpact's axis may be the normal of a side, found by comparing points as they were rounded: these
/// units of X and R over the side's length is how far it may be tilted from the direction that the distance
/// was found along. The far points of the other shape come closer along it by that times its width. (A
/// difference of two rounded points 2.8 X + 5.7 R; a support may be the wrong one of two that differ by 11
/// R.)
constexpr float kTiltPerCoordinate = 3.0f, kTiltPerReach = 17.0f;

/// Sides shorter than this have no direction worth an axis (and b2Distance stops searching below
/// FLT_EPSILON).
constexpr float kShortestSide = 0.01f * b2_linearSlop;

/// Beyond these, times of impact and overlaps are Box2D's: its own answers are off by a tenth of a slop
/// there.
constexpr float kSweepReach = 500.0f * b2_lengthUnitsPerMeter, kSweepAngle = 500.0f;

/// A pair in contact is taken as apart again only when this much more is proved: a resting pair that trembles
/// about the threshold would otherwise repair its structure every step.
constexpr double kHysteresis = b2_linearSlop;

} // namespace bmr

#endif
