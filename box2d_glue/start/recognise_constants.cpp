// SPDX-License-Identifier: MIT
#include "start/recognise_constants.h"

#include <cfloat>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <initializer_list>

#include <box2d/b2_broad_phase.h>
#include <box2d/b2_distance.h>
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_time_of_impact.h>
#include <box2d/b2_world.h>

namespace bmr {

namespace {

struct Constant {
    const char *name;
    float here, expected;
};

char anotherConstant[120];

const char *IsAnother(const Constant &constant) {
    std::snprintf(anotherConstant, sizeof anotherConstant,
                  "%s is %.5g here, %.5g in the Box2D this was built for", constant.name,
                  static_cast<double>(constant.here), static_cast<double>(constant.expected));
    return anotherConstant;
}

/// Measured to a few units in the last place of a metre, the distance over which both points below fly.
bool Agrees(const Constant &constant) {
    constexpr float kError = 4.0f * FLT_EPSILON * kTrialMetre;
    return std::fabs(constant.here - constant.expected) <= kError;
}

/// Does one factor make the second of both?
bool IsOneFactor(const Constant &a, const Constant &b) {
    constexpr float kError = 1e-3f;
    const float factor = a.here / a.expected;
    return std::fabs(b.here / b.expected - factor) <= kError * factor;
}

/// Equal but for the rounding of coordinates as large as these.
bool IsBox(const b2AABB &box, b2Vec2 lower, b2Vec2 upper) {
    const auto error = [](b2Vec2 v) { return 4.0f * FLT_EPSILON * (std::fabs(v.x) + std::fabs(v.y)); };
    return b2Distance(box.lowerBound, lower) <= error(lower) &&
           b2Distance(box.upperBound, upper) <= error(upper);
}

b2DistanceProxy Point(const b2Vec2 *place) {
    b2DistanceProxy proxy;
    proxy.m_vertices = place;
    proxy.m_count = 1;
    proxy.m_radius = 0.0f;
    return proxy;
}

/// A proxy at the origin, then well beside its fat box after a long way to the right.
const char *WhyFatBoxesAreOthers(b2BroadPhase *broadPhase, Constant *extension) {
    constexpr float kWay = 1024.0f;
    b2AABB box;
    box.lowerBound.SetZero();
    box.upperBound.SetZero();
    const int32 proxy = broadPhase->CreateProxy(box, nullptr);
    const b2AABB first = broadPhase->GetFatAABB(proxy);
    const float r = first.upperBound.x, beside = 1.0f + 8.0f * r;
    box.lowerBound.Set(beside, beside);
    box.upperBound.Set(beside, beside);
    broadPhase->MoveProxy(proxy, box, b2Vec2(kWay, 0.0f));
    const b2AABB second = broadPhase->GetFatAABB(proxy);
    broadPhase->DestroyProxy(proxy);

    const float right = second.upperBound.x;
    if (!(r >= 0.0f) || !IsBox(first, b2Vec2(-r, -r), b2Vec2(r, r)) ||
        !IsBox(second, b2Vec2(beside - r, beside - r), b2Vec2(right, beside + r)))
        return "the boxes of the broad phase are others than in 2.4.1";
    extension->here = r;
    const Constant multiplier = {"b2_aabbMultiplier", (right - (beside + r)) / kWay, b2_aabbMultiplier};
    // (Fused multiply-add rounds once, not twice.)
    constexpr float kError = 4.0f * FLT_EPSILON * b2_aabbMultiplier;
    return std::fabs(multiplier.here - multiplier.expected) <= kError ? nullptr : IsAnother(multiplier);
}

/// Two points, a metre apart, of which one flies at the other.
float MeasureSlop() {
    const b2Vec2 origin(0.0f, 0.0f), way(kTrialMetre, 0.0f);
    return kTrialMetre * (1.0f - TrialImpact(Point(&origin), way, Point(&origin), way));
}

/// The same: polygons have at least this radius for b2ShapeCast, and overlap by it where they touch.
float MeasureRadius() {
    const b2Vec2 origin(0.0f, 0.0f);
    b2ShapeCastInput input;
    input.proxyA = input.proxyB = Point(&origin);
    input.transformA.SetIdentity();
    input.transformB.SetIdentity();
    input.transformB.p.Set(kTrialMetre, 0.0f);
    input.translationB.Set(-kTrialMetre, 0.0f);
    b2ShapeCastOutput output;
    const float way = b2ShapeCast(&output, &input) ? output.lambda : 0.0f; // a larger radius leaves none
    return kTrialMetre * (1.0f - way);
}

} // namespace

float TrialImpact(const b2DistanceProxy &flying, b2Vec2 way, const b2DistanceProxy &resting, b2Vec2 place) {
    b2TOIInput input;
    input.proxyA = flying;
    input.proxyB = resting;
    for (b2Sweep *sweep : {&input.sweepA, &input.sweepB}) {
        sweep->localCenter.SetZero();
        sweep->c0.SetZero();
        sweep->c.SetZero();
        sweep->a0 = sweep->a = sweep->alpha0 = 0.0f;
    }
    input.sweepA.c = way;
    input.sweepB.c0 = input.sweepB.c = place;
    input.tMax = 1.0f;
    b2TOIOutput output;
    b2TimeOfImpact(&output, &input);
    return output.state == b2TOIOutput::e_touching ? output.t : -1.0f;
}

const char *WhyVerticesAreOthers(b2PolygonShape *shape, size_t margin) {
    const b2Vec2 firstNormal(0.0f, -1.0f);
    shape->SetAsBox(kTrialMetre, kTrialMetre);
    if (shape->m_count == 4 && shape->m_normals[0] == firstNormal)
        return nullptr;
    // Behind as many vertices as there are in this Box2D stand the normals.
    const auto *bytes = reinterpret_cast<const unsigned char *>(shape->m_vertices);
    const size_t most = margin / sizeof(b2Vec2);
    for (size_t i = 4; i < most; ++i) {
        b2Vec2 there;
        std::memcpy(&there, bytes + i * sizeof there, sizeof there);
        if (there == firstNormal && i != b2_maxPolygonVertices)
            return IsAnother({"b2_maxPolygonVertices", static_cast<float>(i), b2_maxPolygonVertices});
    }
    return "the fields of b2PolygonShape lie elsewhere than in 2.4.1";
}

const char *WhyConstantsAreOthers(b2World *world) {
    b2BroadPhase &broadPhase = const_cast<b2ContactManager &>(world->GetContactManager()).m_broadPhase;
    Constant extension = {"b2_aabbExtension", 0.0f, b2_aabbExtension};
    if (const char *why = WhyFatBoxesAreOthers(&broadPhase, &extension))
        return why;
    const Constant slop = {"b2_linearSlop", MeasureSlop(), b2_linearSlop};
    const Constant radius = {"b2_polygonRadius", MeasureRadius(), b2_polygonRadius};
    const bool same = extension.here == extension.expected;
    if (!same && IsOneFactor(extension, slop))
        return IsAnother({"b2_lengthUnitsPerMeter",
                          extension.here / extension.expected * b2_lengthUnitsPerMeter,
                          b2_lengthUnitsPerMeter});
    if (!same)
        return IsAnother(extension);
    if (!Agrees(slop))
        return IsAnother(slop);
    return Agrees(radius) ? nullptr : IsAnother(radius);
}

} // namespace bmr
