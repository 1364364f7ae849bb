// SPDX-License-Identifier: MIT
#include "glue/proofs/sweep_apart.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <new>

#include <box2d/b2_distance.h>
#include <box2d/b2_fixture.h>

#include "base/memory.h"
#include "glue/proofs/convex_distance.h"
#include "glue/proofs/thresholds.h"
#include "shapes/big_polygons.h"
#include "shapes/shapes32.h"

namespace bmr {

namespace {

float LargestCoordinate(const b2Vec2 &a, const b2Vec2 &b) {
    return std::max(std::max(std::fabs(a.x), std::fabs(a.y)), std::max(std::fabs(b.x), std::fabs(b.y)));
}

} // namespace

SweptShape Sweep(const b2DistanceProxy &proxy, const b2Sweep &sweep, const b2Rot &rotation) {
    SweptShape swept;
    swept.radius = proxy.m_radius;
    swept.tilt = 0.0f;
    swept.rounding = std::numeric_limits<float>::infinity();
    if (proxy.m_count < 1 || proxy.m_count > BMR_SWEPT32_MOST) {
        swept.points = {};
        return swept;
    }
    bmr_motion32 motion;
    motion.center = *Vectors32(&sweep.localCenter);
    motion.start = *Vectors32(&sweep.c0);
    motion.end = *Vectors32(&sweep.c);
    motion.s = rotation.s;
    motion.c = rotation.c;
    motion.turn = sweep.a - sweep.a0;
    bmr_swept32_make(&swept.points, Vectors32(proxy.m_vertices), proxy.m_count, &motion);
    const float coordinate = LargestCoordinate(sweep.c0, sweep.c) + swept.points.radius;
    const float angle = std::max(std::fabs(sweep.a0), std::fabs(sweep.a));
    const float reach = swept.points.radius + std::fabs(sweep.localCenter.x) + std::fabs(sweep.localCenter.y);
    if (coordinate <= kSweepReach && angle <= kSweepAngle && swept.points.edge >= kShortestSide) {
        swept.rounding = kUnit * (kErrorPerCoordinate * coordinate + kErrorPerReach * reach +
                                  kErrorPerAngle * angle * swept.points.radius);
        swept.tilt = kUnit * (kTiltPerCoordinate * coordinate + kTiltPerReach * reach);
    }
    return swept;
}

namespace {

/// So far apart along a fixed direction they are not found touching. Infinite where Box2D must answer: there
/// a side may be too short to divide by.
float NeverTouchBeyond(const SweptShape &a, const SweptShape &b) {
    if (!(a.rounding + b.rounding <= std::numeric_limits<float>::max()))
        return std::numeric_limits<float>::infinity();
    const float lever = 1.0f + std::max(a.points.width / b.points.edge, b.points.width / a.points.edge);
    const float impact = ImpactDistance(a.radius + b.radius);
    const float tilt = a.tilt + b.tilt + (kTiltAlways + kUnit * kTiltPerDistance * impact);
    return impact * (1.0f + kUnit * kErrorPerDistance) + (a.rounding + b.rounding) + tilt * lever;
}

} // namespace

bool NeverTouch(const SweptShape &a, const SweptShape &b, bmr_vec32 *direction) {
    const float distance = NeverTouchBeyond(a, b);
    return distance <= std::numeric_limits<float>::max() &&
           bmr_swept32_find_apart(&a.points, &b.points, distance, direction);
}

bool NeverTouchAlong(const SweptShape &a, const SweptShape &b, bmr_vec32 direction) {
    const float distance = NeverTouchBeyond(a, b);
    return distance <= std::numeric_limits<float>::max() &&
           bmr_swept32_apart_along(&a.points, &b.points, distance, direction);
}

ImpactScan *ImpactScan::Begin() {
    ImpactScan *scan = PerThread<ImpactScan>();
    if (scan != nullptr)
        ++scan->m_scan;
    return scan;
}

inline bool ImpactScan::Resting::IsOf(const b2DistanceProxy &proxy, const Side &side) const {
    static_assert(offsetof(b2Sweep, alpha0) == sizeof sweep);
    // All of them are floats without padding, and the same bits make the same shape.
    return count == proxy.m_count && radius == proxy.m_radius &&
           // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
           std::memcmp(sweep, &side.sweep, sizeof sweep) == 0 &&
           // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
           std::memcmp(&rotation, &side.rotation, sizeof rotation) == 0 &&
           std::memcmp(points, proxy.m_vertices, static_cast<size_t>(count) * sizeof *points) == 0;
}

inline void ImpactScan::Resting::Set(const b2DistanceProxy &proxy, const Side &side) {
    count = 0;
    const b2Sweep &its = side.sweep;
    if (proxy.m_count > BMR_SWEPT32_MOST || !(its.c0 == its.c && its.a0 == its.a))
        return;
    count = proxy.m_count;
    radius = proxy.m_radius;
    std::memcpy(sweep, &side.sweep, sizeof sweep);
    rotation = side.rotation;
    std::memcpy(points, proxy.m_vertices, static_cast<size_t>(count) * sizeof *points);
}

inline const SweptShape &ImpactScan::Shape(Places &places, const Side &side) const {
    const uint64_t mixed = (static_cast<uint64_t>(reinterpret_cast<uintptr_t>(side.fixture)) +
                            static_cast<uint64_t>(side.child)) *
                           0x9e3779b97f4a7c15u;
    Place &place = places[mixed >> (64u - kPlaceBits)];
    if (place.fixture == side.fixture && place.child == side.child && place.scan == m_scan &&
        place.from == side.sweep.alpha0)
        return place.shape;
    b2DistanceProxy proxy;
    SetProxy(&proxy, *side.fixture->GetShape(), side.child);
    if (place.resting.count == 0 || !place.resting.IsOf(proxy, side)) {
        new (&place.shape) SweptShape(Sweep(proxy, side.sweep, side.rotation)); // made in place
        place.resting.Set(proxy, side);
    }
    place.fixture = side.fixture;
    place.child = side.child;
    place.scan = m_scan;
    place.from = side.sweep.alpha0;
    return place.shape;
}

bool ImpactScan::NeverTouch(const Side &a, const Side &b, bmr_vec32 guess, bool touching) {
    bool never;
    if (AnyBigPolygon() && BigNeverTouch({*a.fixture->GetShape(), a.child, a.sweep},
                                         {*b.fixture->GetShape(), b.child, b.sweep}, guess, &never))
        return never;
    const SweptShape &shapeA = Shape(m_ofA, a), &shapeB = Shape(m_ofB, b);
    return touching ? NeverTouchAlong(shapeA, shapeB, guess) : bmr::NeverTouch(shapeA, shapeB, &guess);
}

} // namespace bmr
