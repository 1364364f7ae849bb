// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_EXACT_DISTANCE_H
#define BOOMERANG_TEST_EXACT_DISTANCE_H

#include <vector>

#include "boomerang/polygon.h"
#include "exact.h"
#include "exact_motion.h"

/// @file
/// How far apart two convex polygons are, in rational arithmetic, and with nothing of core's but its types.
/// This is the one oracle of distance. From C it is test_distance (motions.h).
///
/// B - A, all differences of a point of B and one of A, is convex. Its edges are those of B and of -A, sorted
/// by their directions. The distance of the origin from its border is the distance of the two, or, where the
/// origin is inside, the depth of their overlap. Long double with a bound of its error finds the few edges
/// that may be the nearest; fractions decide.

namespace exact {

/// A polygon that is convex to the last bit and in order, a segment or a point, where a pose's matrix puts it
/// as it stands.
struct Posed {
    std::vector<bmr_vec2> points;
    bmr_pose pose;
};

inline Posed PosedOf(const bmr_polygon *polygon, const bmr_pose &pose = bmr_pose_identity()) {
    return {{polygon->vertices, polygon->vertices + polygon->count}, pose};
}
/// The hull of any points, of a polygon too that is convex but for rounding.
inline Posed PosedOf(const std::vector<bmr_vec2> &points, const bmr_pose &pose) {
    return {HullOf(points), pose};
}
inline Posed PosedOf(bmr_vec2 point) {
    return {{point}, bmr_pose_identity()};
}
inline Places PlacesOf(const Posed &posed) {
    return At(posed.pose, posed.points);
}

struct Gap {
    Place way;    ///< from A to B by the distance; where they overlap, the least that moves A away from B
    bool overlap; ///< more than that they touch
    bool corners; ///< the way is from a corner to a corner
};
/// O(n + m).
Gap GapOf(const Posed &a, const Posed &b);

/// 0 where they touch or overlap.
inline mpq_class SquaredDistance(const Posed &a, const Posed &b) {
    const Gap gap = GapOf(a, b);
    return gap.overlap ? mpq_class(0) : Square(gap.way);
}

/// The same, not squared. Rounded once.
double Distance(const Posed &a, const Posed &b);

/// The distance; where they overlap, minus the least depth. Rounded to long double.
long double SignedDistance(const Posed &a, const Posed &b);

/// How far a point is from the border of any ring. Rounded to long double. O(n).
long double DistanceToRing(bmr_vec2 p, const std::vector<bmr_vec2> &ring);

/// The least <d, q - p> of a point p of a and q of b, over the length of d. Rounded to long double. O(n + m).
long double SeparationAlong(bmr_vec2 d, const Posed &a, const Posed &b);

/// The distance in long double alone: to search for a place by, not to check by.
long double NearDistance(const Posed &a, const Posed &b);

} // namespace exact

#endif
