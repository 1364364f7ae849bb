// SPDX-License-Identifier: MIT
#include "proofs/sweep_apart.h"

#include <cmath>
#include <limits>

#include <box2d/b2_distance.h>
#include <box2d/b2_time_of_impact.h>

#include "ledger/pair_memory.h"
#include "proofs/thresholds.h"
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

bool NeverTouch(const SweptShape &a, const SweptShape &b, bmr_vec32 *direction) {
    const float lever = 1.0f + std::max(a.points.width / b.points.edge, b.points.width / a.points.edge);
    const float impact = ImpactDistance(a.radius + b.radius);
    const float tilt = a.tilt + b.tilt + (kTiltAlways + kUnit * kTiltPerDistance * impact);
    const float distance =
        impact * (1.0f + kUnit * kErrorPerDistance) + (a.rounding + b.rounding) + tilt * lever;
    return bmr_swept32_compare(&a.points, &b.points, distance, distance, direction) == BMR_SWEPT32_APART;
}

namespace {

/// What is remembered of the two; nullptr without memory, and where more is asked for than the way from 0 to
/// 1 that is proved: Box2D's sweeps go on at either end.
PairMemory *MemoryOf(const b2TOIInput &input) {
    return input.tMax >= 0.0f && input.tMax <= 1.0f ? Remember(KeyOf(input.proxyA), KeyOf(input.proxyB))
                                                    : nullptr;
}

bool NeverTouch(const b2TOIInput &input, PairMemory *memory) {
    return NeverTouch(Sweep(input.proxyA, input.sweepA, b2Rot(input.sweepA.a)),
                      Sweep(input.proxyB, input.sweepB, b2Rot(input.sweepB.a)), &memory->direction);
}

} // namespace

bool NeverTouch(const b2TOIInput &input) {
    PairMemory *memory = MemoryOf(input);
    return memory != nullptr && NeverTouch(input, memory);
}

bool NeverTouchUnlessResting(const b2TOIInput &input) {
    PairMemory *memory = MemoryOf(input);
    return memory != nullptr &&
           SeekUnlessResting(memory, 0, [&input, memory] { return NeverTouch(input, memory); });
}

} // namespace bmr
