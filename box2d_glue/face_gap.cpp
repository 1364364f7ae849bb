// SPDX-License-Identifier: MIT
#include "face_gap.h"

#include <algorithm>
#include <cmath>

#include <box2d/b2_body.h>
#include <box2d/b2_fixture.h>

#include "shapes32.h"
#include "thresholds.h"

namespace bmr {

namespace {

bmr_polygon32 PolygonOf(const b2Fixture &fixture) {
    return Polygon32(static_cast<const b2PolygonShape &>(*fixture.GetShape()));
}

double Extent(const bmr_polygon32 &shape) {
    double most = 0.0;
    for (int32_t i = 0; i < shape.count; ++i)
        most = std::max(most, std::hypot(static_cast<double>(shape.vertices[i].x),
                                         static_cast<double>(shape.vertices[i].y)));
    return most;
}

bmr_transform32 FrameOf(const b2Fixture &owner, const b2Fixture &other) {
    return bmr_exact32_relative(Transform32(other.GetBody()->GetTransform()),
                                Transform32(owner.GetBody()->GetTransform()));
}

/// What a separation in the other's frame proves.
FaceGap Proved(float separation, int32_t edge, const bmr_polygon32 &owner, const bmr_polygon32 &other,
               const bmr_transform32 &frame) {
    const double distance = std::hypot(static_cast<double>(frame.p.x), static_cast<double>(frame.p.y));
    FaceGap gap = {separation, edge, 0.0};
    if (distance + Extent(owner) + Extent(other) < kReach)
        gap.proved = std::max(0.0, static_cast<double>(separation) - kRoundingMargin);
    return gap;
}

} // namespace

FaceGap LargestFaceGap(const b2Fixture &owner, const b2Fixture &other) {
    const bmr_polygon32 own = PolygonOf(owner), others = PolygonOf(other);
    const bmr_transform32 frame = FrameOf(owner, other);
    int32_t edge = 0;
    const float separation = bmr_exact32_max_separation(&own, &others, &frame, &edge);
    return Proved(separation, edge, own, others, frame);
}

FaceGap FaceGapAlong(int32_t edge, const b2Fixture &owner, const b2Fixture &other) {
    const bmr_polygon32 own = PolygonOf(owner), others = PolygonOf(other);
    const bmr_transform32 frame = FrameOf(owner, other);
    return Proved(bmr_exact32_edge_separation(&own, edge, &others, &frame), edge, own, others, frame);
}

} // namespace bmr
