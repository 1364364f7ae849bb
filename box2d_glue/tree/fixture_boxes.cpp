// SPDX-License-Identifier: MIT
// For polygons and circles both poses are done at once, in registers, in the order of
// b2PolygonShape::ComputeAABB, and for big ConvexShapes as in theirs; and most leaves, which stay, are
// recognised here.
#include "tree/edit.h"

#include <cstring>

#include <box2d/b2_body.h>
#include <box2d/b2_broad_phase.h>
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_world.h>

#include "base/private_members.h"
#include "base/rounding_mode.h"
#include "shapes/big_polygons.h"
#include "shapes/shapes32.h"
#include "start/settings.h"

namespace bmr::tree {

namespace {

/// The points whose box, made larger by the shape's radius, is the shape's.
struct Corners {
    const b2Vec2 *points;
    int32 count; ///< 0: the shape is none that is known here
    const bmr_convex32_block *big = nullptr;
};

/// Up to so many vertices reading each of them costs less than a search for the outermost ones.
constexpr uint32_t kMostOneByOne = 24;

/// Of Box2D's own polygons and circles, and of ConvexShapes; of nothing that a game has derived from them. (A
/// circle's box is by b2CircleShape::ComputeAABB what a polygon's of its middle alone would be, to the bit.)
Corners CornersOf(const b2Shape &shape) {
    const b2PolygonShape polygonModel;
    const b2CircleShape circleModel;
    if (internal::TableOf(shape) == internal::TableOf(circleModel))
        return {&static_cast<const b2CircleShape &>(shape).m_p, 1};
    if (internal::TableOf(shape) != internal::TableOf(polygonModel) && !internal::IsConvexShape(shape))
        return {nullptr, 0};
    const auto &polygon = static_cast<const b2PolygonShape &>(shape);
    // A polygon of more than 8 vertices shows 7 or 8 of them. Of fewer, all are there, also if the polygon is
    // a piece of an outline.
    if (polygon.m_count < b2_maxPolygonVertices - 1)
        return {polygon.m_vertices, polygon.m_count};
    const bmr_convex32_block *big = BigPolygonOf(polygon);
    if (big == nullptr || big->polygon.count > kMostOneByOne)
        return {polygon.m_vertices, polygon.m_count, big};
    return {reinterpret_cast<const b2Vec2 *>(big->polygon.vertices), static_cast<int32>(big->polygon.count)};
}

/// The box of a fixture that moves, and how far its middle does.
struct Swept {
    Box around;
    float4 displacement; ///< in the lower half
};

float4 High(float4 a) {
    return highs4(a, a);
}

// Lanes: x and y at the first pose, x and y at the second.

Swept WithSkin(float4 lower, float4 upper, float skin) {
    const float4 radius = all4(skin);
    lower = sub4(lower, radius);
    upper = add4(upper, radius);
    const float4 middle = mul4(all4(0.5f), add4(lower, upper));
    return {lows4(min4(lower, High(lower)), max4(upper, High(upper))), sub4(High(middle), middle)};
}

Swept SweepBig(const bmr_convex32 &polygon, float skin, const b2Transform &xf1, const b2Transform &xf2) {
    bmr_vec32 lower[2], upper[2];
    bmr_convex32_box(&polygon, Transform32(xf1), &lower[0], &upper[0]);
    bmr_convex32_box(&polygon, Transform32(xf2), &lower[1], &upper[1]);
    return WithSkin(load4(&lower[0].x), load4(&upper[0].x), skin);
}

Swept Sweep(const Corners &corners, float skin, const b2Transform &xf1, const b2Transform &xf2) {
    const float4 first = load4(&xf1.p.x), second = load4(&xf2.p.x);
    const float4 place = lows4(first, second), turns = highs4(first, second);
    const float4 ofX = swap4(turns); // cosine, sine
    const float4 ofY = flip_even4(turns);
    const auto posed = [&](const b2Vec2 &v) {
        const float4 x = all4(v.x), y = all4(v.y);
        return add4(add4(mul4(ofX, x), mul4(ofY, y)), place);
    };
    float4 lower = posed(corners.points[0]), upper = lower;
    for (int32 i = 1; i < corners.count; ++i) {
        const float4 v = posed(corners.points[i]);
        lower = min4(lower, v);
        upper = max4(upper, v);
    }
    return WithSkin(lower, upper, skin);
}

/// Would MoveProxy leave the leaf where it is? It does where the leaf's box holds this one, and is held by
/// this one made larger by one extension, what the displacement foretells, and four more. Without the
/// displacement that is smaller, also once it is rounded: so a yes is right.
bool Stays(Box leaf, Box box) {
    const float4 once = flip_low4(all4(b2_aabbExtension)), more = flip_low4(all4(4.0f * b2_aabbExtension));
    const float4 huge = add4(add4(box, once), more);
    const auto holds = [](Box outer, Box inner) {
        return at_most4(low_high4(outer, inner), low_high4(inner, outer));
    };
    return every4(both4(holds(leaf, box), holds(huge, leaf)));
}

/// Is all of it finite? (An infinity less itself is no number; the displacement's upper half is the second
/// middle less itself.)
bool IsFinite(const Swept &swept) {
    return HasNumbers(sub4(swept.around, swept.around)) && HasNumbers(swept.displacement);
}

/// b2BroadPhase::MoveProxy. Box2D's own is asked for boxes that are not finite.
void MoveProxy(b2BroadPhase *broadPhase, const b2FixtureProxy &proxy, const b2Vec2 &displacement) {
    bool moved;
    if (!MoveHere(&(broadPhase->*Named(Tree())), proxy.proxyId, proxy.aabb, displacement, &moved))
        broadPhase->MoveProxy(proxy.proxyId, proxy.aabb, displacement);
    else if (moved)
        broadPhase->TouchProxy(proxy.proxyId);
}

/// Of a shape that has one proxy and corners. False where nothing is done.
bool SynchronizeCorners(const b2Shape &shape, b2FixtureProxy *proxy, b2BroadPhase *broadPhase,
                        const b2Transform &xf1, const b2Transform &xf2) {
    const Corners corners = CornersOf(shape);
    if (corners.count == 0)
        return false;
    const Swept swept = corners.big != nullptr ? SweepBig(corners.big->polygon, shape.m_radius, xf1, xf2)
                                               : Sweep(corners, shape.m_radius, xf1, xf2);
    // Numbers that are none go through MoveProxy's comparisons, and keep their bits.
    if (!IsFinite(swept))
        return false;
    store4(&proxy->aabb.lowerBound.x, swept.around);
    if (!Stays(BoxOf(broadPhase->GetFatAABB(proxy->proxyId)), swept.around)) {
        b2Vec2 displacement;
        store_low4(&displacement.x, swept.displacement);
        MoveProxy(broadPhase, *proxy, displacement);
    }
    return true;
}

/// b2Fixture::Synchronize.
void Synchronize(b2Fixture *fixture, b2BroadPhase *broadPhase, const b2Transform &xf1,
                 const b2Transform &xf2) {
    const b2Shape &shape = *fixture->GetShape();
    const int32 count = FixtureAccess::ProxyCount(fixture);
    b2FixtureProxy *const proxies = FixtureAccess::Proxies(fixture);
    if (count == 1 && SynchronizeCorners(shape, proxies, broadPhase, xf1, xf2))
        return;
    for (int32 i = 0; i < count; ++i) {
        b2AABB first, second;
        shape.ComputeAABB(&first, xf1, proxies[i].childIndex);
        shape.ComputeAABB(&second, xf2, proxies[i].childIndex);
        proxies[i].aabb.Combine(first, second);
        MoveProxy(broadPhase, proxies[i], second.GetCenter() - first.GetCenter());
    }
}

} // namespace

void SynchronizeBoxes(b2Body *body) {
    if (!RoundsToNearest()) {
        (body->*Named(SynchronizeFixtures()))();
        return;
    }
    const b2Sweep &sweep = SweepOf(*body);
    b2Transform begin = body->GetTransform();
    if (body->IsAwake()) {
        begin.q.Set(sweep.a0);
        begin.p = sweep.c0 - b2Mul(begin.q, sweep.localCenter);
    }
    auto &manager = const_cast<b2ContactManager &>(body->GetWorld()->GetContactManager());
    for (b2Fixture *fixture = body->GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext())
        Synchronize(fixture, &manager.m_broadPhase, begin, body->GetTransform());
}

} // namespace bmr::tree
