// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_POLYGON_DISTANCE_H
#define BMR_TEST_POLYGON_DISTANCE_H

#include <algorithm>
#include <cmath>
#include <vector>

#include "boomerang/polygon.h"

/// @file
/// How far apart two posed polygons are: a separating-axis test over all edges and vertices in long double.
/// It shares nothing with core.

namespace distance {

struct Point {
    long double x, y;
};
using Points = std::vector<Point>;

inline Points Transformed(const bmr_polygon *polygon, const bmr_pose &pose) {
    // The rotation is made exactly orthonormal in long double: a double's is off by a rounding.
    const long double length = std::hypot(static_cast<long double>(pose.c), static_cast<long double>(pose.s));
    const long double c = pose.c / length, s = pose.s / length;
    Points points;
    for (uint32_t i = 0; i < polygon->count; ++i) {
        const long double x = polygon->vertices[i].x, y = polygon->vertices[i].y;
        points.push_back({c * x - s * y + pose.position.x, s * x + c * y + pose.position.y});
    }
    return points;
}

/// min over b - max over a along (nx, ny): where it is positive, a proof.
inline long double SeparationAlong(const Points &a, const Points &b, long double nx, long double ny) {
    const long double length = std::hypot(nx, ny);
    if (length == 0.0L)
        return -INFINITY;
    long double most = -INFINITY, least = INFINITY;
    for (const Point &p : a)
        most = std::max(most, nx * p.x + ny * p.y);
    for (const Point &p : b)
        least = std::min(least, nx * p.x + ny * p.y);
    return (least - most) / length;
}

/// The largest separation that an edge's normal of `a` gives.
inline long double EdgeSeparation(const Points &a, const Points &b) {
    long double best = -INFINITY;
    for (size_t i = 0; i < a.size(); ++i) {
        const Point p = a[i], q = a[(i + 1) % a.size()];
        best = std::max(best, SeparationAlong(a, b, q.y - p.y, p.x - q.x));
    }
    return best;
}

/// From r to the nearest point of a segment.
inline Point ToSegment(const Point &r, const Point &p, const Point &q) {
    const long double dx = q.x - p.x, dy = q.y - p.y, square = dx * dx + dy * dy;
    long double t = square > 0.0L ? ((r.x - p.x) * dx + (r.y - p.y) * dy) / square : 0.0L;
    t = std::min(1.0L, std::max(0.0L, t));
    return {p.x + t * dx - r.x, p.y + t * dy - r.y};
}

/// From p to the nearest point of a ring.
template <typename Ring> Point ToRing(const Point &p, const Ring &ring) {
    Point nearest = {INFINITY, 0.0L};
    for (size_t i = 0; i < ring.size(); ++i) {
        const auto &from = ring[i], &to = ring[(i + 1) % ring.size()];
        const Point way = ToSegment(p, {from.x, from.y}, {to.x, to.y});
        if (way.x * way.x + way.y * way.y < nearest.x * nearest.x + nearest.y * nearest.y)
            nearest = way;
    }
    return nearest;
}

/// The distance; where the polygons overlap, minus the least depth over edge normals. At least one has an
/// inside.
inline long double SignedDistance(const Points &a, const Points &b) {
    Point way = {0.0L, 0.0L};     // from a to b
    long double least = INFINITY; // squared
    for (size_t i = 0; i < a.size(); ++i)
        for (size_t j = 0; j < b.size(); ++j) {
            const Point toA = ToSegment(b[j], a[i], a[(i + 1) % a.size()]);
            const Point toB = ToSegment(a[i], b[j], b[(j + 1) % b.size()]);
            const long double fromB = toA.x * toA.x + toA.y * toA.y, fromA = toB.x * toB.x + toB.y * toB.y;
            if (std::min(fromA, fromB) < least)
                way = fromA < fromB ? toB : Point{-toA.x, -toA.y};
            least = std::min(least, std::min(fromA, fromB));
        }
    // Normals of tiny edges are rough; the way between the nearest points is not.
    const long double separation =
        std::max(std::max(EdgeSeparation(a, b), EdgeSeparation(b, a)), SeparationAlong(a, b, way.x, way.y));
    return separation <= 0.0L ? separation : std::sqrt(least);
}

} // namespace distance

#endif
