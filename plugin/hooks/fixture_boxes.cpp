// SPDX-License-Identifier: MIT
// b2Fixture::Synchronize: after a step each fixture's box is set anew, around where it was and where it is,
// and its leaf of the tree moves if it must. For polygons and circles both poses are done at once, in
// registers, in the order of b2PolygonShape::ComputeAABB, and for big ConvexShapes as in theirs; and most
// leaves, which stay, are recognised here. Leaves that move are b2BroadPhase::MoveProxy's. Other shapes go to
// Box2D.
#include <box2d/b2_body.h>
#include <box2d/b2_broad_phase.h>
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>

#include "hooks/tree_descent.h"
#include "reach/stock.h"
#include "shapes/convex_access.h"
#include "shapes/convex_geometry.h"
#include "shapes/shapes32.h"
#include "start/rounding_mode.h"
#include "start/settings.h"
#include "tell/verify.h"

namespace bmr::hooks {

namespace {

#if defined(__SSE2__)

/// Names protected members of b2Fixture's.
struct ProxyAccess : b2Fixture {
    /// The proxy of a fixture that has one; nullptr where it has none, or several.
    static b2FixtureProxy *OnlyProxyOf(const b2Fixture *fixture) {
        return fixture->*(&ProxyAccess::m_proxyCount) == 1 ? fixture->*(&ProxyAccess::m_proxies) : nullptr;
    }
};

/// The points whose box, made larger by the shape's radius, is the shape's.
struct Corners {
    const b2Vec2 *points;
    int32 count; ///< 0: the shape is none that is known here
    const bmr_convex32_block *big = nullptr;
};

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
    return {polygon.m_vertices, polygon.m_count, BigPolygonOf(polygon)};
}

/// The box of a fixture that moves, and how far its middle does.
struct Swept {
    Box around;
    __m128 displacement; ///< in the lower half
};

__m128 Low(__m128 a, __m128 b) {
    return _mm_movelh_ps(a, b);
}
__m128 High(__m128 a) {
    return _mm_movehl_ps(a, a);
}

// Lanes: x and y at the first pose, x and y at the second.

Swept WithSkin(__m128 lower, __m128 upper, float skin) {
    const __m128 radius = _mm_set1_ps(skin);
    lower = _mm_sub_ps(lower, radius);
    upper = _mm_add_ps(upper, radius);
    const __m128 middle = _mm_mul_ps(_mm_set1_ps(0.5f), _mm_add_ps(lower, upper));
    return {Low(_mm_min_ps(lower, High(lower)), _mm_max_ps(upper, High(upper))),
            _mm_sub_ps(High(middle), middle)};
}

Swept SweepBig(const bmr_convex32 &polygon, float skin, const b2Transform &xf1, const b2Transform &xf2) {
    bmr_vec32 lower[2], upper[2];
    bmr_convex32_box(&polygon, Transform32(xf1), &lower[0], &upper[0]);
    bmr_convex32_box(&polygon, Transform32(xf2), &lower[1], &upper[1]);
    return WithSkin(_mm_loadu_ps(&lower[0].x), _mm_loadu_ps(&upper[0].x), skin);
}

Swept Sweep(const Corners &corners, float skin, const b2Transform &xf1, const b2Transform &xf2) {
    const __m128 first = _mm_loadu_ps(&xf1.p.x), second = _mm_loadu_ps(&xf2.p.x);
    const __m128 odd = _mm_castsi128_ps(_mm_set_epi32(0, INT32_MIN, 0, INT32_MIN));
    const __m128 place = Low(first, second);
    const __m128 ofX = _mm_shuffle_ps(first, second, _MM_SHUFFLE(2, 3, 2, 3)); // cosine, sine
    const __m128 ofY = _mm_xor_ps(_mm_shuffle_ps(first, second, _MM_SHUFFLE(3, 2, 3, 2)), odd);
    const auto posed = [&](const b2Vec2 &v) {
        const __m128 x = _mm_set1_ps(v.x), y = _mm_set1_ps(v.y);
        return _mm_add_ps(_mm_add_ps(_mm_mul_ps(ofX, x), _mm_mul_ps(ofY, y)), place);
    };
    __m128 lower = posed(corners.points[0]), upper = lower;
    for (int32 i = 1; i < corners.count; ++i) {
        const __m128 v = posed(corners.points[i]);
        lower = _mm_min_ps(lower, v);
        upper = _mm_max_ps(upper, v);
    }
    return WithSkin(lower, upper, skin);
}

/// Would MoveProxy leave the leaf where it is? It does where the leaf's box holds this one, and is held by
/// this one made larger by one extension, what the displacement foretells, and four more. Without the
/// displacement that is smaller, also once it is rounded: so a yes is right.
bool Stays(Box leaf, Box box) {
    const __m128 lowerSigns = _mm_castsi128_ps(_mm_set_epi32(0, 0, INT32_MIN, INT32_MIN));
    const __m128 once = _mm_xor_ps(_mm_set1_ps(b2_aabbExtension), lowerSigns);
    const __m128 more = _mm_xor_ps(_mm_set1_ps(4.0f * b2_aabbExtension), lowerSigns);
    const __m128 huge = _mm_add_ps(_mm_add_ps(box, once), more);
    const auto holds = [](Box outer, Box inner) {
        return _mm_cmple_ps(_mm_shuffle_ps(outer, inner, _MM_SHUFFLE(3, 2, 1, 0)),
                            _mm_shuffle_ps(inner, outer, _MM_SHUFFLE(3, 2, 1, 0)));
    };
    return _mm_movemask_ps(_mm_and_ps(holds(leaf, box), holds(huge, leaf))) == 0xf;
}

/// Is all of it finite? (An infinity less itself is no number; the displacement's upper half is the second
/// middle less itself.)
bool IsFinite(const Swept &swept) {
    return HasNumbers(_mm_sub_ps(swept.around, swept.around)) && HasNumbers(swept.displacement);
}

bool SameBits(Box a, Box b) {
    return _mm_movemask_epi8(_mm_cmpeq_epi32(_mm_castps_si128(a), _mm_castps_si128(b))) == 0xffff;
}

void CompareWithBox2D(b2Fixture *fixture, b2BroadPhase *broadPhase, const b2Transform &xf1,
                      const b2Transform &xf2, const b2FixtureProxy &proxy, Box ours) {
    const Box leaf = BoxOf(broadPhase->GetFatAABB(proxy.proxyId));
    stock::Synchronize(fixture, broadPhase, xf1, xf2);
    CountVerified();
    if (!SameBits(BoxOf(proxy.aabb), ours))
        ReportDifference("fixture boxes", fixture, nullptr, "another box");
    if (Stays(leaf, ours) && !SameBits(leaf, BoxOf(broadPhase->GetFatAABB(proxy.proxyId))))
        ReportDifference("fixture boxes", fixture, nullptr, "the leaf moves");
}

/// False where the fixture is Box2D's to do.
bool SynchronizeHere(b2Fixture *fixture, b2BroadPhase *broadPhase, const b2Transform &xf1,
                     const b2Transform &xf2) {
    const b2Shape &shape = *fixture->GetShape();
    const Corners corners = CornersOf(shape);
    b2FixtureProxy *proxy = ProxyAccess::OnlyProxyOf(fixture);
    if (corners.count == 0 || proxy == nullptr || !GetSettings().sameRounding)
        return false;
    const Swept swept = corners.big != nullptr ? SweepBig(corners.big->polygon, shape.m_radius, xf1, xf2)
                                               : Sweep(corners, shape.m_radius, xf1, xf2);
    // Numbers that are none go through MoveProxy's comparisons, and keep their bits.
    if (!IsFinite(swept))
        return false;
    if (Verifying()) {
        CompareWithBox2D(fixture, broadPhase, xf1, xf2, *proxy, swept.around);
        return true;
    }
    _mm_storeu_ps(&proxy->aabb.lowerBound.x, swept.around);
    if (!Stays(BoxOf(broadPhase->GetFatAABB(proxy->proxyId)), swept.around)) {
        b2Vec2 displacement;
        _mm_storel_pi(reinterpret_cast<__m64 *>(&displacement), swept.displacement);
        broadPhase->MoveProxy(proxy->proxyId, proxy->aabb, displacement);
    }
    return true;
}

#else

bool SynchronizeHere(b2Fixture *, b2BroadPhase *, const b2Transform &, const b2Transform &) {
    return false;
}

#endif

BMR_NOINLINE void SynchronizeInstalled(b2Fixture *fixture, b2BroadPhase *broadPhase, const b2Transform &xf1,
                                       const b2Transform &xf2) {
    if (!HookIsOn(Hook::FixtureBoxes) || !RoundsToNearest() ||
        !SynchronizeHere(fixture, broadPhase, xf1, xf2))
        stock::Synchronize(fixture, broadPhase, xf1, xf2);
}

} // namespace

} // namespace bmr::hooks

using namespace bmr;
using namespace bmr::hooks;

BMR_FOR_LOADERS("_ZN9b2Fixture11SynchronizeEP12b2BroadPhaseRK11b2TransformS4_");

void b2Fixture::Synchronize(b2BroadPhase *broadPhase, const b2Transform &xf1, const b2Transform &xf2) {
    if (NothingIsInstalled())
        stock::Synchronize(this, broadPhase, xf1, xf2);
    else
        SynchronizeInstalled(this, broadPhase, xf1, xf2);
}
