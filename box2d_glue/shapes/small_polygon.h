// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_SMALL_POLYGON_H
#define BOOMERANG_GLUE_SMALL_POLYGON_H

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <box2d/b2_polygon_shape.h>

#include "shapes/big_polygons.h"

/// @file
/// A polygon of Box2D's own size: is it another than before, and can it be believed? A game may write to its
/// vertices and normals.

namespace bmr {

/// All that contacts of a polygon read of it, in one number: skin, vertices and normals, or which big one it
/// is. Two different ones have the same with a probability of 2^-64. Two sums, so that neither waits for the
/// other.
inline uint64_t DigestOf(const b2PolygonShape &polygon) {
    constexpr uint64_t kFirst = 0x9e3779b97f4a7c15u, kSecond = 0xc2b2ae3d27d4eb4fu;
    const auto wordOf = [](const b2Vec2 &v) {
        uint64_t word;
        std::memcpy(&word, &v, sizeof word);
        return word;
    };
    const uint64_t start = wordOf(b2Vec2(polygon.m_radius, static_cast<float>(polygon.m_count)));
    uint64_t first = start, second = AnyBigPolygon() ? NumberOfBigPolygon(polygon) : 0;
    const int32 count = std::clamp<int32>(polygon.m_count, 0, b2_maxPolygonVertices);
    for (int32 i = 0; i < count; ++i) {
        first = (first ^ wordOf(polygon.m_vertices[i])) * kFirst;
        first ^= first >> 32;
        second = (second ^ wordOf(polygon.m_normals[i])) * kSecond;
        second ^= second >> 32;
    }
    return first * kSecond ^ second;
}

namespace internal {

/// Has it a side that is too short for Box2D to normalise? Clipping against such a side keeps points however
/// far off they are, so a hull proves nothing. (b2PolygonShape::Set makes no such side, but a game may.) A
/// NaN counts as one.
inline bool HasSideWithoutDirection(const b2PolygonShape &polygon) {
    constexpr float kShortest = 2.0f * b2_epsilon; // b2Vec2::Normalize's limit, far from its rounding
    for (int32 i = 0; i < polygon.m_count; ++i) {
        const b2Vec2 &end = polygon.m_vertices[i + 1 < polygon.m_count ? i + 1 : 0];
        if (!((end - polygon.m_vertices[i]).LengthSquared() >= kShortest * kShortest))
            return true;
    }
    return false;
}

/// Are its normals those of its sides? b2CollidePolygons uses the normals, a hull the vertices. With other
/// normals Box2D may clip against any face, and then keeps points however far off they are.
/// b2PolygonShape::Set tilts normals by 2.2 units, and the product here is off by 3 more. If a game turned
/// and moved vertices after it made the normals, they are off by the rounding of the vertices.
/// glue/proofs/thresholds.md has the cost of that.
inline bool HasNormalsOfItsSides(const b2PolygonShape &polygon) {
    constexpr float kUnit = 0.5f * b2_epsilon;
    constexpr float kTilt = 8.0f * kUnit, kLength = 16.0f * kUnit, kRounding = 8.0f * kUnit;
    for (int32 i = 0; i < polygon.m_count; ++i) {
        const b2Vec2 &n = polygon.m_normals[i], &v = polygon.m_vertices[i],
                     &w = polygon.m_vertices[i + 1 < polygon.m_count ? i + 1 : 0];
        const b2Vec2 side = w - v;
        const float place = b2Max(v.Length(), w.Length());
        if (!(std::fabs(n.LengthSquared() - 1.0f) <= kLength) || !(b2Cross(n, side) > 0.0f) ||
            !(std::fabs(b2Dot(n, side)) <= kTilt * side.Length() + kRounding * place))
            return false;
    }
    return true;
}

} // namespace internal

/// Does b2CollidePolygons see nothing of this small polygon but its vertices' hull? Ask each time before the
/// vertices are relied on: when a hull is built of them, and when an existing hull is checked against them.
inline bool VerticesTellAll(const b2PolygonShape &polygon) {
    return !internal::HasSideWithoutDirection(polygon) && internal::HasNormalsOfItsSides(polygon);
}

/// Do its normals turn to the left, once around? If they do not, Box2D may report contacts with shapes that
/// are far away. Ask only where VerticesTellAll is true.
inline bool TurnsOnce(const b2PolygonShape &polygon) {
    constexpr float kBack = 1e-5f; // what vertices that were turned and moved may be off by
    int32 turns = 0;
    for (int32 i = 0; i < polygon.m_count; ++i) {
        const b2Vec2 &n = polygon.m_normals[i], &m = polygon.m_normals[i + 1 < polygon.m_count ? i + 1 : 0];
        if (!(b2Cross(n, m) >= -kBack))
            return false;
        turns += n.y < 0.0f && m.y >= 0.0f;
    }
    return turns == 1;
}

} // namespace bmr

#endif
