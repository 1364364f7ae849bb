// SPDX-License-Identifier: MIT
#include "start/rounding_probe.h"

#include <cfloat>
#include <cmath>

#include <box2d/b2_collision.h>
#include <box2d/b2_polygon_shape.h>

#include "shapes/shapes32.h"

namespace bmr {

namespace {

/// Did b2CollidePolygons leave at its first separation test (before it writes anything but the count)?
bool LeavesEarly(const b2PolygonShape &a, const b2Transform &xfA, const b2PolygonShape &b,
                 const b2Transform &xfB) {
    constexpr float kSentinel = -77.0f;
    b2Manifold manifold;
    manifold.localNormal.Set(kSentinel, kSentinel);
    b2CollidePolygons(&manifold, &a, xfA, &b, xfB);
    return manifold.localNormal.x == kSentinel && manifold.localNormal.y == kSentinel;
}

/// Two boxes with a face of the first towards the second, turned by `angle`, the second tilted by `tilt`.
bool AgreesAt(float angle, float tilt, float distance) {
    b2PolygonShape a, b;
    a.SetAsBox(3.1f, 0.77f);
    b.SetAsBox(0.53f, 0.41f);
    b2Transform xfA, xfB;
    xfA.Set(b2Vec2(1.3f, -0.7f), angle);
    const b2Vec2 offset = b2Mul(xfA.q, b2Vec2(0.31f, distance));
    xfB.Set(xfA.p + offset, angle + tilt);
    const bmr_polygon32 pa = Polygon32(a), pb = Polygon32(b);
    const bmr_transform32 frame = bmr_exact32_relative(Transform32(xfB), Transform32(xfA));
    int32_t edge = 0;
    const float separation = bmr_exact32_max_separation(&pa, &pb, &frame, &edge);
    if (!(separation > 0.0f))
        return false;
    b.m_radius = 0.0f;
    a.m_radius = separation;
    if (LeavesEarly(a, xfA, b, xfB))
        return false;
    a.m_radius = std::nextafterf(separation, 0.0f);
    return LeavesEarly(a, xfA, b, xfB);
}

} // namespace

bool Box2DRoundsAsExact32() {
    constexpr int kProbes = 32; // a contracted build disagrees in about half of them
    for (int i = 0; i < kProbes; ++i) {
        const float x = static_cast<float>(i);
        if (!AgreesAt(0.37f * x, 0.011f * x - 0.2f, 1.5f + 0.05f * x))
            return false;
    }
    return true;
}

} // namespace bmr
