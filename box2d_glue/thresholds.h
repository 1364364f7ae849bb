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

/// A pair in contact is taken as apart again only when this much more is proved: a resting pair that trembles
/// about the threshold would otherwise repair its structure every step.
constexpr double kHysteresis = b2_linearSlop;

} // namespace bmr

#endif
