// SPDX-License-Identifier: MIT
#include "debug/verify.h"

#include <atomic>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <initializer_list>

#include <box2d/b2_body.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_edge_shape.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>

#include "debug/statistics.h"
#include "glue/contacts/convex_contact.h"
#include "start/install.h"
#include "start/settings.h"
#include "tree/pair_descent.h"

namespace bmr {

namespace {

std::atomic<bool> reported{false};

/// Equal, or neither is a number.
bool Same(float a, float b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

bool Same(const b2Vec2 &a, const b2Vec2 &b) {
    return Same(a.x, b.x) && Same(a.y, b.y);
}

/// (Without points stock leaves the rest as it was.)
bool Same(const b2Manifold &a, const b2Manifold &b) {
    bool same = a.pointCount == b.pointCount &&
                (a.pointCount == 0 || (a.type == b.type && Same(a.localNormal, b.localNormal) &&
                                       Same(a.localPoint, b.localPoint)));
    for (int32 i = 0; same && i < a.pointCount; ++i)
        same =
            Same(a.points[i].localPoint, b.points[i].localPoint) && a.points[i].id.key == b.points[i].id.key;
    return same;
}

/// Counts a comparison. `what` was answered; the fixtures, if it was about two, are described for a reader
/// who looks for them in his own program: Box2D gives bodies no names.
void Compared(bool same, const char *what, const b2Fixture *fixtureA, const b2Fixture *fixtureB) {
    GetCounts().verified.fetch_add(1, std::memory_order_relaxed);
    if (same)
        return;
    GetCounts().differences.fetch_add(1, std::memory_order_relaxed);
    if (reported.exchange(true))
        return;
    std::fprintf(stderr, "boomerang: first difference from Box2D, step %" PRIu64 ": %s",
                 GetCounts().steps.load(), what);
    for (const b2Fixture *fixture : {fixtureA, fixtureB}) {
        if (fixture == nullptr)
            continue;
        const b2Body *body = fixture->GetBody();
        std::fprintf(stderr, "; fixture %p of body %p (at %.9g, %.9g, angle %.9g)",
                     static_cast<const void *>(fixture), static_cast<const void *>(body),
                     static_cast<double>(body->GetPosition().x), static_cast<double>(body->GetPosition().y),
                     static_cast<double>(body->GetAngle()));
    }
    std::fprintf(stderr, "\n");
}

/// The manifold that Box2D's functions make of the two where they are. False if they make the one that is
/// compared, too. Box2D knows no big polygons: of two that are found apart the plugin's own search must find
/// no points when it begins anew.
bool MakeByBox2D(const b2Contact &contact, b2Manifold *manifold) {
    const b2Fixture &a = *contact.GetFixtureA(), &b = *contact.GetFixtureB();
    const b2Transform &xfA = a.GetBody()->GetTransform(), &xfB = b.GetBody()->GetTransform();
    if (b.GetType() != b2Shape::e_polygon)
        return false;
    const auto *const polygon = static_cast<const b2PolygonShape *>(b.GetShape());
    if (ConvexContact::AsOurs(const_cast<b2Contact *>(&contact)) != nullptr) {
        bmr_convex32_memory nothing = {};
        if (a.GetType() != b2Shape::e_polygon || contact.GetManifold()->pointCount > 0)
            return false;
        CollideConvex({&a, &b, contact.GetChildIndexA()}, Seams::Known, manifold, xfA, xfB, &nothing);
        return true;
    }
    if (a.GetType() == b2Shape::e_polygon) {
        b2CollidePolygons(manifold, static_cast<const b2PolygonShape *>(a.GetShape()), xfA, polygon, xfB);
    } else {
        const b2EdgeShape link = LinkOf(a, contact.GetChildIndexA());
        b2CollideEdgeAndPolygon(manifold, &link, xfA, polygon, xfB);
    }
    return true;
}

/// The pairs in Box2D's order, from its own query, held against those that were found.
struct ComparingQuery {
    const b2DynamicTree *tree;
    int32 proxy;
    const b2Pair *next, *end;
    bool same = true;

    bool QueryCallback(int32 leaf) {
        if (!tree::Reports(proxy, leaf, tree->WasMoved(leaf)) ||
            tree::BodyOf(tree->GetUserData(leaf)) == tree::BodyOf(tree->GetUserData(proxy)))
            return true;
        same = same && next != end && next->proxyIdA == b2Min(leaf, proxy) &&
               next->proxyIdB == b2Max(leaf, proxy);
        next += same ? 1 : 0;
        return same;
    }
};

} // namespace

void VerifyContact(const b2Contact &contact) {
    const b2Fixture *const a = contact.GetFixtureA(), *const b = contact.GetFixtureB();
    if (a->IsSensor() || b->IsSensor()) {
        VerifyAnswer("a sensor's overlap", a, b, contact.IsTouching(),
                     b2TestOverlap(a->GetShape(), contact.GetChildIndexA(), b->GetShape(),
                                   contact.GetChildIndexB(), a->GetBody()->GetTransform(),
                                   b->GetBody()->GetTransform()));
        return;
    }
    b2Manifold box2d;
    if (MakeByBox2D(contact, &box2d))
        VerifyManifold(a, b, *contact.GetManifold(), box2d);
}

void VerifyPairs(const b2DynamicTree &tree, const int32 *moves, int32 count, const b2Pair *found,
                 int32 foundCount) {
    ComparingQuery query = {&tree, b2BroadPhase::e_nullProxy, found, found + foundCount};
    for (int32 i = 0; i < count; ++i) {
        query.proxy = moves[i];
        if (moves[i] != b2BroadPhase::e_nullProxy)
            tree.Query(&query, tree.GetFatAABB(moves[i]));
    }
    Compared(query.same && query.next == query.end, "pairs of a search", nullptr, nullptr);
}

void SayVerified() {
    std::fprintf(stderr, "boomerang: verified %" PRIu64 " answers, %" PRIu64 " differ\n",
                 GetCounts().verified.load(), GetCounts().differences.load());
}

void VerifyManifold(const b2Fixture *fixtureA, const b2Fixture *fixtureB, const b2Manifold &ours,
                    const b2Manifold &box2d) {
    Compared(Same(ours, box2d), "a manifold", fixtureA, fixtureB);
}

void VerifyAnswer(const char *what, const b2Fixture *fixtureA, const b2Fixture *fixtureB, bool ours,
                  bool box2d) {
    Compared(ours == box2d, what, fixtureA, fixtureB);
}

} // namespace bmr
