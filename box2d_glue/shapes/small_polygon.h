// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_SMALL_POLYGON_H
#define BOOMERANG_GLUE_SMALL_POLYGON_H

#include <algorithm>
#include <cstdint>
#include <cstring>

#include <box2d/b2_polygon_shape.h>

#include "shapes/convex_geometry.h"

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

/// Does b2CollidePolygons see nothing of this small polygon but its vertices' hull? Ask each time before the
/// vertices are relied on: when a hull is built of them, and when an existing hull is checked against them.
bool VerticesTellAll(const b2PolygonShape &polygon);

/// Do its normals turn to the left, once around? If they do not, Box2D may report contacts with shapes that
/// are far away. Ask only where VerticesTellAll is true.
bool TurnsOnce(const b2PolygonShape &polygon);

} // namespace bmr

#endif
