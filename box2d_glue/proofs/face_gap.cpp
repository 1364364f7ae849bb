// SPDX-License-Identifier: MIT
#include "proofs/face_gap.h"

#include <algorithm>
#include <cmath>

#include <box2d/b2_body.h>
#include <box2d/b2_fixture.h>

#include "convex32/convex32_collide.h"
#include "proofs/polygon_view.h"
#include "proofs/thresholds.h"

namespace bmr {

namespace {

bmr_polygon32 SmallPolygon(const b2Fixture &fixture) {
    return Polygon32(static_cast<const b2PolygonShape &>(*fixture.GetShape()));
}

bmr_transform32 FrameOf(const b2Fixture &owner, const b2Fixture &other) {
    return bmr_exact32_relative(Transform32(other.GetBody()->GetTransform()),
                                Transform32(owner.GetBody()->GetTransform()));
}

/// How far the owner's own vertices lie beyond the line of its edge, in units of the normal: nowhere but by
/// rounding, unless vertices or normals were edited in place. A NaN makes it infinite.
double Overhang(const bmr_convex32 &owner, int32_t edge) {
    const bmr_vec32 &n = owner.normals[edge], &foot = owner.vertices[edge];
    constexpr float kLongest = 1.0f + 1e-5f; // of a square; a shorter normal makes separations smaller
    if (!(n.x * n.x + n.y * n.y <= kLongest))
        return INFINITY;
    float most = 0.0f;
    for (uint32_t i = 0; i < owner.count; ++i) {
        const float beyond = n.x * (owner.vertices[i].x - foot.x) + n.y * (owner.vertices[i].y - foot.y);
        if (!(beyond <= most))
            most = beyond;
    }
    return static_cast<double>(most);
}

/// The gap that a separation in the other's frame proves.
FaceGap Proved(float separation, int32_t edge, const bmr_convex32 &owner, const bmr_convex32 &other,
               const bmr_transform32 &frame) {
    const double distance = std::hypot(static_cast<double>(frame.p.x), static_cast<double>(frame.p.y));
    FaceGap gap = {separation, edge, 0.0};
    if (distance + Extent(owner) + Extent(other) < kReach)
        gap.proved = std::max(0.0, static_cast<double>(separation) - kRoundingMargin - Overhang(owner, edge));
    return gap;
}

} // namespace

FaceGap LargestFaceGap(const b2Fixture &owner, const b2Fixture &other) {
    const bmr_transform32 frame = FrameOf(owner, other);
    const bmr_convex32 own = RealPolygon(owner), others = RealPolygon(other);
    if (!IsBig(owner) && !IsBig(other)) { // to the bit
        const bmr_polygon32 small = SmallPolygon(owner), otherSmall = SmallPolygon(other);
        int32_t edge = 0;
        const float separation = bmr_exact32_max_separation(&small, &otherSmall, &frame, &edge);
        return Proved(separation, edge, own, others, frame);
    }
    uint32_t edge = 0, vertex = 0;
    const float separation = bmr_convex32_max_separation(&own, &others, &frame, 0, &edge, &vertex);
    return Proved(separation, static_cast<int32_t>(edge), own, others, frame);
}

FaceGap FaceGapAlong(int32_t edge, const b2Fixture &owner, const b2Fixture &other) {
    const bmr_polygon32 small = SmallPolygon(owner), otherSmall = SmallPolygon(other);
    const bmr_transform32 frame = FrameOf(owner, other);
    return Proved(bmr_exact32_edge_separation(&small, edge, &otherSmall, &frame), edge, RealPolygon(owner),
                  RealPolygon(other), frame);
}

} // namespace bmr
