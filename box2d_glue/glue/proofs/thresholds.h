// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_THRESHOLDS_H
#define BOOMERANG_GLUE_THRESHOLDS_H

#include <cfloat>
#include <cmath>

#include <box2d/b2_common.h>
#include <box2d/b2_math.h>

namespace bmr {

/// Added to every threshold for the rounding of Box2D's own arithmetic.
constexpr double kRoundingMargin = 0.2 * b2_linearSlop;

/// b2CollidePolygons clips in world coordinates, each as large as X. A moved point is off by 1.4 units of X,
/// its product with a normal by 3, a clipped corner in all by 16.5 (units are halves of FLT_EPSILON;
/// thresholds.md beside this has the derivation, test_glue_threshold_bounds computes it). So up to this
/// distance from the origin all of it stays within kRoundingMargin; beyond, pairs go to Box2D.
constexpr double kReach = kRoundingMargin / (16.0 * FLT_EPSILON);

/// Turning a point rounds more than moving it: a body's extent counts so much more than its place.
constexpr double kReachOfExtent = 1.5;

/// How far out a polygon is, for a pair's budget of motion: band k reaches 2^k times as far as band 0, and
/// its roundings are as much larger. A polygon's extent is held to that of band 0 in all of them
/// (kReachOfExtent times sqrt(2), for what counts there is the largest coordinate), for what is off by parts
/// of the extent alone, as the separation of a face, is not to grow. Beyond the last band a pair has no
/// budget.
constexpr float kBandReach = 480.0f * b2_lengthUnitsPerMeter;
constexpr int kBands = 5;
constexpr float kBandReachOfExtent = 2.1214f;

/// kRoundingMargin for polygons of this band. Farther bands leave twice as much as their reach asks for: what
/// b2TestOverlap may be off by is then less than this alone.
constexpr double BandMargin(int band) {
    return band == 0 ? kRoundingMargin : static_cast<double>(2 << band) * kRoundingMargin;
}

/// Is a body, whose vertices are no farther from its origin than `reach`, where ContactMargin holds all of
/// the rounding? No for what is not a number.
inline bool WithinReach(const b2Transform &xf, double reach) {
    const double limit = kReach - kReachOfExtent * reach;
    return std::fabs(static_cast<double>(xf.p.x)) <= limit && std::fabs(static_cast<double>(xf.p.y)) <= limit;
}

/// b2CollidePolygons gives no points when the polygons are farther apart than this: it keeps points whose
/// separation is at most the sum of the radii and whose side offset is at most the same, so nothing beyond
/// the diagonal, which is rounded up for what the radii's own rounding adds. Where the face is not the best
/// one (by Box2D's tolerance, and by the rounding of both separations) points may also lie behind it by less
/// than a slop: smaller radii count as that.
inline double ContactMargin(double radiusSum, double roundingMargin = kRoundingMargin) {
    constexpr double kDiagonal = 1.41422, kDeepest = b2_linearSlop;
    return kDiagonal * (radiusSum > kDeepest ? radiusSum : kDeepest) + roundingMargin;
}

/// b2TimeOfImpact says "touching" where its distance of the core polygons, or the separation of two of their
/// points along its axis, is at most this somewhere on the way.
inline float ImpactDistance(float radiusSum) {
    const float target = radiusSum - 3.0f * b2_linearSlop;
    return (b2_linearSlop > target ? b2_linearSlop : target) + 0.25f * b2_linearSlop; // a NaN stays one
}

/// Half a unit in the last place of 1: what one float operation may be off by, relatively.
constexpr float kUnit = 0.5f * FLT_EPSILON;

/// How far Box2D's arithmetic and ours may be off for one of two moving shapes, in terms of the largest
/// coordinate X of its points in the world, their largest distance R from the body's origin, and the body's
/// angle; in kUnit. The sum of both shapes' is what a proof must leave beside ImpactDistance (or beside the
/// sum of the radii, for a sensor). thresholds.md beside this has the derivation, test_glue_threshold_bounds
/// computes it.
///
/// - X: interpolating the centre and the transform 7.4 in length. The closest point, a mean of two such
///   points, 2.8 more. Our own difference of the centres, of their ways, and their products with a direction
///   21. Together 31.3.
/// - R: sine and cosine and the interpolated angle (at most a turn once it is normalised) 50; transforming a
///   point, a support's choice, an axis' product, our own 60, of which X has 32.
/// - angle: b2Sweep::Normalize takes off a multiple of a 2 pi that is off by half a unit, and rounds it: 1.5.
constexpr float kErrorPerCoordinate = 32.0f, kErrorPerReach = 128.0f, kErrorPerAngle = 4.0f;

/// The same for what grows with the distance that is asked for: lengths, directions that are not quite of
/// unit length, the sum of all of this. (Only discs of many metres have a distance to speak of.)
constexpr float kErrorPerDistance = 24.0f;

/// b2TimeOfImpact's axis may be the normal of a side, found by comparing points as they were rounded: these
/// units of X and R over the side's length is how far it may be tilted from the direction that the distance
/// was found along. The far points of the other shape come closer along it by that times its width. (A
/// difference of two rounded points 2.8 X + 11.6 R; a support may be the wrong one of two that differ by 11.6
/// R.)
constexpr float kTiltPerCoordinate = 3.0f, kTiltPerReach = 24.0f;
/// And by these units of the distance, and an epsilon: b2Distance stops searching below it.
constexpr float kTiltPerDistance = 4.0f, kTiltAlways = FLT_EPSILON;

/// Sides shorter than this have no direction worth an axis (and b2Vec2::Normalize leaves vectors shorter than
/// FLT_EPSILON as they are).
constexpr float kShortestSide = 0.01f * b2_linearSlop;

/// Beyond these, times of impact and overlaps are Box2D's: what the margins above leave is a good part of
/// what lies between ImpactDistance and a resting pair.
constexpr float kSweepReach = 500.0f * b2_lengthUnitsPerMeter, kSweepAngle = 500.0f;

/// A pair in contact is taken as apart again only when this much more is proved: a resting pair that trembles
/// about the threshold would otherwise repair its structure every step.
constexpr double kHysteresis = b2_linearSlop;

} // namespace bmr

#endif
