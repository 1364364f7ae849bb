// SPDX-License-Identifier: MIT
#include "shapes/small_polygon.h"

#include <cmath>

namespace bmr {

namespace {

/// Has it a side of which Box2D makes no unit vector? Clipping against such a side keeps points however far
/// off they are, so a hull proves nothing. (b2PolygonShape::Set makes no such side, but a game may.) A NaN
/// counts as one.
bool HasSideWithoutDirection(const b2PolygonShape &polygon) {
    constexpr float kShortest = 2.0f * b2_epsilon; // b2Vec2::Normalize's limit, far from its rounding
    for (int32 i = 0; i < polygon.m_count; ++i) {
        const b2Vec2 &end = polygon.m_vertices[i + 1 < polygon.m_count ? i + 1 : 0];
        if (!((end - polygon.m_vertices[i]).LengthSquared() >= kShortest * kShortest))
            return true;
    }
    return false;
}

/// Are its normals those of its sides? b2CollidePolygons goes by normals, a hull by vertices: of normals that
/// are others the face that Box2D clips against may be any, and keeps points however far off they are.
/// b2PolygonShape::Set tilts them by 2.2 units, and the product here is off by 3 more. Vertices that were
/// turned and moved after their normals are off by the rounding of their place. glue/proofs/README.md has
/// what that costs.
bool HasNormalsOfItsSides(const b2PolygonShape &polygon) {
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

} // namespace

bool VerticesTellAll(const b2PolygonShape &polygon) {
    return !HasSideWithoutDirection(polygon) && HasNormalsOfItsSides(polygon);
}

bool TurnsOnce(const b2PolygonShape &polygon) {
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
