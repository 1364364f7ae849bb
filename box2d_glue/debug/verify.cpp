// SPDX-License-Identifier: MIT
#include "debug/verify.h"

#include <atomic>
#include <cinttypes>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>

#include <box2d/b2_body.h>
#include <box2d/b2_chain_shape.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_edge_shape.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>

#include "debug/exit_line.h"
#include "glue/contacts/convex_contact.h"
#include "start/install.h"
#include "start/settings.h"
#include "tree/pair_descent.h"

namespace bmr {

namespace {

std::atomic<bool> reported{false};

/// Where a fixture is, for a reader who looks for it in his own program: Box2D gives bodies no names.
struct Place {
    char text[160];
};

Place PlaceOf(const b2Fixture *fixture) {
    Place place;
    if (fixture == nullptr) {
        std::snprintf(place.text, sizeof place.text, "an unknown fixture");
        return place;
    }
    const b2Body *body = fixture->GetBody();
    const b2Vec2 &at = body->GetPosition();
    std::snprintf(place.text, sizeof place.text, "fixture %p of body %p (at %.9g, %.9g, angle %.9g)",
                  static_cast<const void *>(fixture), static_cast<const void *>(body),
                  static_cast<double>(at.x), static_cast<double>(at.y),
                  static_cast<double>(body->GetAngle()));
    return place;
}

/// Equal, or neither is a number.
bool Same(float a, float b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

bool Same(const b2Vec2 &a, const b2Vec2 &b) {
    return Same(a.x, b.x) && Same(a.y, b.y);
}

/// The first field that differs and has a meaning, or nullptr.
const char *FieldThatDiffers(const b2Manifold &a, const b2Manifold &b) {
    if (a.pointCount != b.pointCount)
        return "pointCount";
    if (a.pointCount == 0)
        return nullptr; // stock leaves the rest as it was
    if (a.type != b.type)
        return "type";
    if (!Same(a.localNormal, b.localNormal))
        return "localNormal";
    if (!Same(a.localPoint, b.localPoint))
        return "localPoint";
    for (int32 i = 0; i < a.pointCount; ++i) {
        if (!Same(a.points[i].localPoint, b.points[i].localPoint))
            return "points.localPoint";
        if (a.points[i].id.key != b.points[i].id.key)
            return "points.id";
    }
    return nullptr;
}

long installedIn;

/// A number as it is read: 498,299.
struct Grouped {
    explicit Grouped(uint64_t number) {
        char *at = text + sizeof text - 1;
        *at = '\0';
        for (int digits = 0; digits == 0 || number != 0; ++digits, number /= 10) {
            if (digits != 0 && digits % 3 == 0)
                *--at = ',';
            *--at = static_cast<char>('0' + number % 10);
        }
        first = at;
    }
    Grouped(const Grouped &) = delete;
    Grouped &operator=(const Grouped &) = delete;

    char text[32];
    const char *first;
};

/// Not of a process that was forked: its counts begin with its parent's.
void SayVerified() {
    if (ThisProcess() == installedIn)
        std::fprintf(stderr, "boomerang: verified %s answers, %s differ\n",
                     Grouped(GetCounts().verified).first, Grouped(GetCounts().differences).first);
}

} // namespace

void SayVerifiedAtExit() {
    installedIn = ThisProcess();
    CallAtEnd(SayVerified);
}

namespace {

void CountVerified() {
    GetCounts().verified.fetch_add(1, std::memory_order_relaxed);
}

/// `door` is what was answered; `format` says what differs, as printf does.
BMR_FORMAT(4, 5)
void ReportDifference(const char *door, const b2Fixture *fixtureA, const b2Fixture *fixtureB,
                      const char *format, ...) {
    GetCounts().differences.fetch_add(1, std::memory_order_relaxed);
    if (reported.exchange(true))
        return;
    char what[200];
    va_list arguments;
    va_start(arguments, format);
    // NOLINTNEXTLINE(clang-analyzer-valist.Uninitialized): va_start is one line above
    std::vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    std::fprintf(stderr, "boomerang: first difference from Box2D, step %" PRIu64 ", %s: %s; %s against %s\n",
                 GetCounts().steps.load(), door, what, PlaceOf(fixtureA).text, PlaceOf(fixtureB).text);
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
    b2EdgeShape link;
    switch (a.GetType()) {
    case b2Shape::e_polygon:
        b2CollidePolygons(manifold, static_cast<const b2PolygonShape *>(a.GetShape()), xfA, polygon, xfB);
        return true;
    case b2Shape::e_chain:
        static_cast<const b2ChainShape *>(a.GetShape())->GetChildEdge(&link, contact.GetChildIndexA());
        b2CollideEdgeAndPolygon(manifold, &link, xfA, polygon, xfB);
        return true;
    case b2Shape::e_edge:
        b2CollideEdgeAndPolygon(manifold, static_cast<const b2EdgeShape *>(a.GetShape()), xfA, polygon, xfB);
        return true;
    default:
        return false;
    }
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
        VerifyOverlap(a, b, contact.IsTouching(),
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
    CountVerified();
    ComparingQuery query = {&tree, b2BroadPhase::e_nullProxy, found, found + foundCount};
    for (int32 i = 0; i < count; ++i) {
        query.proxy = moves[i];
        if (moves[i] != b2BroadPhase::e_nullProxy)
            tree.Query(&query, tree.GetFatAABB(moves[i]));
    }
    if (!query.same || query.next != query.end)
        ReportDifference("pair finding", nullptr, nullptr, "pair %d of %d is another",
                         static_cast<int>(query.next - found), foundCount);
}

void VerifyExists(const b2Fixture &a, const b2Fixture &b, bool ours, bool box2d) {
    CountVerified();
    if (ours != box2d)
        ReportDifference("pair finding", &a, &b, "there is %s contact here", ours ? "a" : "no");
}

void VerifyManifold(const b2Fixture *fixtureA, const b2Fixture *fixtureB, const b2Manifold &ours,
                    const b2Manifold &box2d) {
    CountVerified();
    if (const char *field = FieldThatDiffers(ours, box2d))
        ReportDifference("polygon manifold", fixtureA, fixtureB, "%s (%d points here, %d in Box2D)", field,
                         ours.pointCount, box2d.pointCount);
}

void VerifyOverlap(const b2Fixture *fixtureA, const b2Fixture *fixtureB, bool ours, bool box2d) {
    CountVerified();
    if (ours != box2d)
        ReportDifference("sensor overlap", fixtureA, fixtureB, "%s here, %s in Box2D",
                         ours ? "overlap" : "apart", box2d ? "overlap" : "apart");
}

} // namespace bmr
