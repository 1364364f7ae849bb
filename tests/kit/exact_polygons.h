// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_EXACT_POLYGONS_H
#define BOOMERANG_TEST_EXACT_POLYGONS_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>

#include "boomerang/polygon.h"
#include "boomerang/pose.h"

/// @file
/// Convex polygons in rational arithmetic: where a pose's matrix puts them as it stands, unit length or not,
/// and how far apart they are. No filter, no floating point at all.

namespace exact {

using Number = CGAL::Gmpq;
using Kernel = CGAL::Simple_cartesian<Number>;
using Point = Kernel::Point_2;
using Vector = Kernel::Vector_2;
using Segment = Kernel::Segment_2;
using Points = std::vector<Point>;

inline Number Square(double x) {
    return Number(x) * Number(x);
}

/// A point of a pose (x, y), (c, s).
inline Point Placed(double px, double py, double c, double s, double x, double y) {
    return {Number(c) * Number(px) - Number(s) * Number(py) + Number(x),
            Number(s) * Number(px) + Number(c) * Number(py) + Number(y)};
}

inline Points PointsOf(const bmr_polygon *polygon) {
    Points points;
    for (std::uint32_t i = 0; i < polygon->count; ++i)
        points.emplace_back(Number(polygon->vertices[i].x), Number(polygon->vertices[i].y));
    return points;
}

inline Points PointsAt(const bmr_polygon *polygon, const bmr_pose &q) {
    Points points;
    for (std::uint32_t i = 0; i < polygon->count; ++i)
        points.push_back(
            Placed(polygon->vertices[i].x, polygon->vertices[i].y, q.c, q.s, q.position.x, q.position.y));
    return points;
}

/// min over b - max over a of the product with a direction.
inline Number GapAlong(const Points &a, const Points &b, const Vector &direction) {
    const auto along = [&](const Point &p) { return direction * (p - CGAL::ORIGIN); };
    Number high = along(a.front()), low = along(b.front());
    for (const Point &p : a)
        high = std::max(high, along(p));
    for (const Point &p : b)
        low = std::min(low, along(p));
    return low - high;
}

/// Do the normals of some edge separate the two, closed as they are? (For points and segments, only where
/// they are not in line.)
inline bool SomeEdgeSeparates(const Points &a, const Points &b) {
    for (int turn = 0; turn < 2; ++turn) {
        const Points &own = turn ? b : a;
        for (std::size_t i = 0; i < own.size(); ++i) {
            const Vector e = own[(i + 1) % own.size()] - own[i];
            const Vector normal = turn ? Vector(-e.y(), e.x()) : Vector(e.y(), -e.x());
            if (GapAlong(a, b, normal) > 0)
                return true;
        }
    }
    return false;
}

/// The squared distance of two convex polygons in order, or of points and segments; 0 where they touch or
/// overlap.
inline Number SquaredDistance(const Points &a, const Points &b) {
    const bool separated = SomeEdgeSeparates(a, b);
    if ((a.size() > 2 || b.size() > 2) && !separated)
        return 0;
    Number best(-1);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) {
            const Segment e(a[i], a[(i + 1) % a.size()]), f(b[j], b[(j + 1) % b.size()]);
            for (const Number &d : {CGAL::squared_distance(a[i], f), CGAL::squared_distance(b[j], e)})
                if (best < 0 || d < best)
                    best = d;
            if (!separated && !e.is_degenerate() && !f.is_degenerate() && CGAL::do_intersect(e, f))
                return 0;
        }
    return best;
}

} // namespace exact

#endif
