// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_QUERY_ORACLE_H
#define BMR_TEST_QUERY_ORACLE_H

#include "boomerang/distance.h"
#include "exact_distance.h"

/// @file
/// What an answer of boomerang/distance.h must be, without any of core: two points and a line that prove each
/// other, and a depth that is known.

namespace query {

/// Both in the world, and what lengths there may be off by.
struct Scene {
    const bmr_polygon *a, *b;
    bmr_pose pose_a, pose_b;
    exact::Posed at_a, at_b;
    double tolerance;
};

/// With (c, s) of unit length, as the header says that it is made first.
inline exact::Posed UnitPosed(const bmr_polygon *polygon, bmr_pose pose) {
    const long double length = std::hypot(static_cast<long double>(pose.c), static_cast<long double>(pose.s));
    pose.c = static_cast<double>(pose.c / length);
    pose.s = static_cast<double>(pose.s / length);
    return exact::PosedOf(polygon, pose);
}

inline Scene SceneOf(const bmr_polygon *a, const bmr_pose &pose_a, const bmr_polygon *b,
                     const bmr_pose &pose_b) {
    const auto size = [](bmr_vec2 v) { return std::fmax(std::fabs(v.x), std::fabs(v.y)); };
    const double scale = a->extent + b->extent + size(pose_a.position) + size(pose_b.position);
    return {a,
            b,
            pose_a,
            pose_b,
            UnitPosed(a, pose_a),
            UnitPosed(b, pose_b),
            BMR_DISTANCE_ROUNDING * scale + 1e-150};
}

/// Are these two points of the polygons, that far apart, with the polygons on either side of the gap? Such an
/// answer is right whatever it was computed by: no two points are nearer.
inline bool ProvesItself(const Scene &s, const bmr_closest_points &answer) {
    const bmr_vec2 way = bmr_sub(answer.point_b, answer.point_a);
    // Closest points lie on the border.
    const auto on_border = [&](const exact::Posed &polygon, bmr_vec2 p) {
        return std::fabs(exact::SignedDistance(polygon, exact::PosedOf(p))) <= s.tolerance;
    };
    // Two points that are off by the tolerance turn the normal by so much; the polygons are no longer than
    // twice their extents.
    const double turned = 2.0 * std::fmin(1.0, s.tolerance / answer.distance);
    return std::fabs(std::hypot(way.x, way.y) - answer.distance) <= s.tolerance &&
           std::fabs(std::hypot(answer.normal.x, answer.normal.y) - 1.0) <= 1e-14 &&
           exact::SeparationAlong(answer.normal, s.at_a, s.at_b) >=
               answer.distance - s.tolerance - turned * (s.a->extent + s.b->extent) &&
           on_border(s.at_a, answer.point_a) && on_border(s.at_b, answer.point_b);
}

/// Does the overlap agree with a depth that is known?
inline bool Agrees(const Scene &s, const bmr_overlap &answer, long double depth) {
    const bmr_vec2 way = bmr_sub(answer.point_a, answer.point_b);
    const bmr_vec2 meant = bmr_scale(answer.depth, answer.normal);
    const long double along = exact::SeparationAlong(answer.normal, s.at_a, s.at_b);
    return std::fabs(answer.depth - depth) <= s.tolerance && std::fabs(along + depth) <= s.tolerance &&
           std::hypot(way.x - meant.x, way.y - meant.y) <= s.tolerance;
}

} // namespace query

#endif
