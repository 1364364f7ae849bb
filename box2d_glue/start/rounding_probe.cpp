// SPDX-License-Identifier: MIT
#include "start/rounding_probe.h"

#include <cfloat>
#include <cmath>
#include <cstring>

#include <box2d/b2_collision.h>
#include <box2d/b2_edge_shape.h>
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

/// Two polygons that overlap, in the i-th of many ways.
struct Overlapping {
    b2PolygonShape a, b;
    b2Transform xfA, xfB;

    explicit Overlapping(int i) {
        const float x = static_cast<float>(i), around = 0.61f * x;
        b2Vec2 corners[b2_maxPolygonVertices];
        const int32 count = 3 + i % (b2_maxPolygonVertices - 2);
        for (int32 k = 0; k < count; ++k) {
            const float angle =
                (static_cast<float>(k) + 0.013f * x) * 2.0f * b2_pi / static_cast<float>(count);
            corners[k] = kSize * b2Vec2(0.83f * std::cos(angle), 0.59f * std::sin(angle));
        }
        a.SetAsBox(2.3f * kSize, 0.77f * kSize);
        b.Set(corners, count);
        xfA.Set(kSize * b2Vec2(1.3f + 0.7f * x, -0.7f), 0.37f * x);
        xfB.Set(xfA.p + b2Mul(xfA.q, kSize * b2Vec2(2.6f * std::cos(around), 1.1f * std::sin(around))),
                0.37f * x + 0.41f * std::sin(1.7f * x));
    }

    static constexpr float kSize = b2_lengthUnitsPerMeter;
};

/// The i-th of many links with a polygon about one of its ends.
bool EdgeAgrees(int i, b2Manifold *manifold) {
    const float x = static_cast<float>(i), at = 0.1f * static_cast<float>(i % 12) - 0.05f;
    const Overlapping shapes(i);
    const b2Vec2 bend(0.0f, 0.4f * std::sin(2.3f * x)), first(-0.9f, 0.1f), second(0.8f, 0.13f * std::cos(x));
    b2EdgeShape edge;
    edge.m_vertex0 = Overlapping::kSize * (first + bend - b2Vec2(1.1f, 0.0f));
    edge.m_vertex1 = Overlapping::kSize * first;
    edge.m_vertex2 = Overlapping::kSize * second;
    edge.m_vertex3 = Overlapping::kSize * (second - bend + b2Vec2(1.3f, 0.0f));
    edge.m_oneSided = i % 4 != 0;
    const b2PolygonShape &polygon = i % 2 == 0 ? shapes.a : shapes.b;
    b2Transform xfB = shapes.xfB;
    const b2Vec2 place = edge.m_vertex1 + at * (edge.m_vertex2 - edge.m_vertex1);
    xfB.p = b2Mul(shapes.xfA, place - b2Vec2(0.0f, 0.004f * std::sin(3.1f * x) * Overlapping::kSize)) -
            b2Mul(xfB.q, polygon.m_vertices[i % polygon.m_count]);
    b2Manifold ours;
    std::memset(static_cast<void *>(&ours), 0, sizeof ours);
    std::memset(static_cast<void *>(manifold), 0, sizeof *manifold);
    b2CollideEdgeAndPolygon(manifold, &edge, shapes.xfA, &polygon, xfB);
    const bmr_polygon32 other = Polygon32(polygon);
    const bmr_edge32 link = Edge32(edge);
    return bmr_exact32_collide_edge(Manifold32(&ours), &link, Transform32(shapes.xfA), &other,
                                    *Vectors32(&polygon.m_centroid), Transform32(xfB),
                                    polygon.m_radius + edge.m_radius) &&
           // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): bits, and all of them were written
           std::memcmp(&ours, manifold, sizeof ours) == 0;
}

} // namespace

bool Box2DCollidesEdgesAsExact32() {
    constexpr int kProbes = 96, kLeast = kProbes / 16;
    int points[3] = {};
    for (int i = 0; i < kProbes; ++i) {
        b2Manifold manifold;
        if (!EdgeAgrees(i, &manifold))
            return false;
        ++points[manifold.pointCount];
    }
    return points[0] >= kLeast && points[1] >= kLeast && points[2] >= kLeast;
}

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
