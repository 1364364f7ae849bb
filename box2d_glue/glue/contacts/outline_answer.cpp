// SPDX-License-Identifier: MIT
// A piece of an outline leaves points to other pieces. Each piece decides that by what it knows of itself, so
// that two of them may leave a point to each other; and a piece that was found to be hit may leave the impact
// to one that is not. The law that mends both: a point is left to a piece that touches there, at these poses,
// in a contact of its own; where there is none, the piece answers as a polygon without seams.
#include <algorithm>
#include <cfloat>

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>

#include "boomerang/outline_shape.h"
#include "glue/contacts/convex_contact.h"
#include "shapes/outline_record.h"

namespace bmr {

/// The thing that touches as one: an outline, or a fixture that is no piece of one.
inline const void *WholeOf(const b2Fixture &fixture) {
    const OutlineRecord *record = OutlineRecordOf(*fixture.GetShape());
    return record != nullptr ? static_cast<const void *>(record) : &fixture;
}

/// Calls visit(b2Contact &other, b2Fixture &a, b2Fixture &b) with each other contact between the two wholes
/// that this contact is one of; `a` is of the body of its fixture A. Ends when `visit` returns false.
/// O(contacts of the one of the two bodies that is dynamic).
template <typename Visit> inline void ForEachOfWholes(const b2Contact &contact, Visit visit) {
    const b2Fixture &ofA = *contact.GetFixtureA(), &ofB = *contact.GetFixtureB();
    const b2Body *const bodyA = ofA.GetBody(), *const bodyB = ofB.GetBody();
    const void *const wholeA = WholeOf(ofA), *const wholeB = WholeOf(ofB);
    const b2Body *const mine = bodyA->GetType() == b2_dynamicBody ? bodyA : bodyB; // has less contacts
    const b2Body *const theirs = mine == bodyA ? bodyB : bodyA;
    for (const b2ContactEdge *edge = mine->GetContactList(); edge != nullptr; edge = edge->next) {
        b2Contact &other = *edge->contact;
        if (edge->other != theirs || &other == &contact)
            continue;
        const bool swapped = other.GetFixtureA()->GetBody() != bodyA;
        b2Fixture &a = swapped ? *other.GetFixtureB() : *other.GetFixtureA(),
                  &b = swapped ? *other.GetFixtureA() : *other.GetFixtureB();
        if (WholeOf(a) == wholeA && WholeOf(b) == wholeB && !visit(other, a, b))
            return;
    }
}

bool TouchesAlone(const b2Contact &contact) {
    bool alone = true;
    ForEachOfWholes(contact, [&alone](const b2Contact &other, const b2Fixture &, const b2Fixture &) {
        alone = !other.IsTouching();
        return alone;
    });
    return alone;
}

namespace {

/// In skins. At an impact the piece that was found to be hit is about to touch. Another that the thing is in
/// deeper than that by more than this is not hit by it now: it has been missed.
constexpr float kMissed = 0.5f;

/// Where one shape is deepest below a face of the other, as a point of a manifold has it, in the frame of
/// body A; and how far the two are apart there, without the skins of polygons and edges.
struct Place {
    b2Vec2 point;
    float gap;
};

/// Of a polygon or an edge it is no part of what is solid.
float SkinOf(const b2Shape &shape) {
    return shape.GetType() == b2Shape::e_circle ? 0.0f : shape.m_radius;
}

Place PlaceOf(const b2Manifold &manifold, int32 i, const TwoFixtures &two, const b2Transform &bInA) {
    const b2Shape &a = *two.a->GetShape(), &b = *two.b->GetShape();
    const bool ofA = manifold.type == b2Manifold::e_faceA;
    const b2Vec2 normal = ofA ? manifold.localNormal : b2Mul(bInA.q, manifold.localNormal),
                 plane = ofA ? manifold.localPoint : b2Mul(bInA, manifold.localPoint),
                 point = ofA ? b2Mul(bInA, manifold.points[i].localPoint) : manifold.points[i].localPoint;
    const float solid = a.m_radius - SkinOf(a) + b.m_radius - SkinOf(b); // of a circle
    return {point - solid * normal, b2Dot(point - plane, normal) - solid};
}

/// Is the point, in the frame of the fixture's body, beyond no side of the polygon by more than this?
bool IsNear(const b2Fixture &fixture, const b2Vec2 &point, float reach) {
    if (fixture.GetType() != b2Shape::e_polygon)
        return true;
    const bmr_convex32 polygon = RealPolygon(fixture);
    for (uint32_t i = 0; i < polygon.count; ++i) {
        const bmr_vec32 n = polygon.normals[i], v = polygon.vertices[i];
        if (n.x * (point.x - v.x) + n.y * (point.y - v.y) > reach)
            return false;
    }
    return true;
}

float DeepestOf(const b2Manifold &manifold, const TwoFixtures &two, const b2Transform &bInA) {
    float deepest = FLT_MAX;
    for (int32 i = 0; i < manifold.pointCount; ++i)
        deepest = std::min(deepest, PlaceOf(manifold, i, two, bInA).gap);
    return deepest;
}

/// The other contacts of the same two wholes, at these poses.
class Others {
public:
    Others(const b2Contact &contact, const b2Transform &xfA, const b2Transform &xfB)
        : m_contact(contact), m_xfA(xfA), m_xfB(xfB), m_bInA(b2MulT(xfA, xfB)) {}

    const b2Transform &BInA() const { return m_bInA; }

    /// Does one of them touch at this place, in the frame of body A?
    bool TouchAt(const b2Vec2 &place) {
        bool touch = false;
        ForEachOfWholes(m_contact, [&](const b2Contact &other, const b2Fixture &a, const b2Fixture &b) {
            touch = Touches(other, a, b, &place);
            return !touch;
        });
        return touch;
    }

    /// The same, with nullptr of any place; where the manifold of one is deeper than `*depth`, writes both.
    bool DeepestAt(const b2Vec2 *place, b2Manifold *manifold, float *depth) {
        bool touch = false;
        ForEachOfWholes(m_contact, [&](const b2Contact &other, const b2Fixture &a, const b2Fixture &b) {
            if (!Touches(other, a, b, place))
                return true;
            touch = true;
            const float depthHere = DeepestOf(m_manifold, m_two, m_bInA);
            if (depthHere < *depth) {
                *depth = depthHere;
                *manifold = m_manifold;
            }
            return true;
        });
        return touch;
    }

private:
    /// Makes the manifold, too.
    bool Touches(const b2Contact &other, const b2Fixture &a, const b2Fixture &b, const b2Vec2 *place) {
        const float reach = SkinOf(*a.GetShape()) + SkinOf(*b.GetShape());
        if (a.IsSensor() || b.IsSensor())
            return false;
        if (place != nullptr && (!IsNear(a, *place, reach) || !IsNear(b, b2MulT(m_bInA, *place), reach)))
            return false;
        const bool swapped = other.GetFixtureA() != &a;
        m_two = {&a, &b, swapped ? other.GetChildIndexB() : other.GetChildIndexA()};
        bmr_convex32_memory nothing = {};
        m_manifold = {};
        CollideConvex(m_two, Seams::Known, &m_manifold, m_xfA, m_xfB, &nothing);
        return m_manifold.pointCount > 0;
    }

    const b2Contact &m_contact;
    const b2Transform &m_xfA, &m_xfB;
    b2Transform m_bInA;
    TwoFixtures m_two = {};
    b2Manifold m_manifold = {};
};

/// For two polygons, a quick look; false says nothing.
bool AreApart(const TwoFixtures &two, const b2Transform &xfA, const b2Transform &xfB,
              bmr_convex32_memory *memory) {
    if (two.a->GetType() != b2Shape::e_polygon || two.b->GetType() != b2Shape::e_polygon)
        return false;
    const bmr_convex32 a = RealPolygon(*two.a), b = RealPolygon(*two.b);
    return bmr_convex32_apart(&a, Transform32(xfA), &b, Transform32(xfB), 0.0f, memory);
}

/// Calls visit(vertex, in the frame of body A) with each vertex of one polygon that is in the other.
template <typename Visit>
void ForEachVertexInside(const TwoFixtures &two, const b2Transform &bInA, Visit visit) {
    if (two.a->GetType() != b2Shape::e_polygon || two.b->GetType() != b2Shape::e_polygon)
        return;
    const bmr_convex32 a = RealPolygon(*two.a), b = RealPolygon(*two.b);
    for (uint32_t i = 0; i < a.count; ++i) {
        const b2Vec2 v(a.vertices[i].x, a.vertices[i].y);
        if (IsNear(*two.b, b2MulT(bInA, v), 0.0f))
            visit(v);
    }
    for (uint32_t i = 0; i < b.count; ++i) {
        const b2Vec2 v = b2Mul(bInA, b2Vec2(b.vertices[i].x, b.vertices[i].y));
        if (IsNear(*two.a, v, 0.0f))
            visit(v);
    }
}

/// The rule of poses: an overlap is left to others if they touch at each point that the plain manifold has,
/// and at each vertex of the one polygon in the other.
bool IsLeft(Others *others, const TwoFixtures &two, const b2Manifold &plain) {
    const b2Transform &bInA = others->BInA();
    bool left = true;
    const auto leave = [&](const b2Vec2 &place) { left = left && others->TouchAt(place); };
    for (int32 i = 0; i < plain.pointCount; ++i) {
        const Place place = PlaceOf(plain, i, two, bInA);
        if (place.gap < 0.0f)
            leave(place.point);
    }
    ForEachVertexInside(two, bInA, leave);
    return left;
}

/// The rule of impacts: others have to touch at each point, and the deepest of their manifolds becomes this
/// contact's, for Box2D asks no other contact about this impact. Far from the origin Box2D finds a piece to
/// be hit that is a bit farther away than the skins: then any other that touches will do. False: the plain
/// manifold answers.
bool IsLeftAtImpact(Others *others, const TwoFixtures &two, const b2Manifold &plain, b2Manifold *manifold) {
    const b2Transform &bInA = others->BInA();
    b2Manifold deepest = {};
    float depth = FLT_MAX;
    if (plain.pointCount == 0 && !others->DeepestAt(nullptr, &deepest, &depth))
        return false;
    for (int32 i = 0; i < plain.pointCount; ++i) {
        const b2Vec2 place = PlaceOf(plain, i, two, bInA).point;
        if (!others->DeepestAt(&place, &deepest, &depth))
            return false;
    }
    if (plain.pointCount > 0 && depth < DeepestOf(plain, two, bInA) - kMissed * two.RadiusSum())
        return false;
    *manifold = deepest;
    return true;
}

} // namespace

bool HasSeams(const TwoFixtures &two) {
    for (const b2Fixture *fixture : {two.a, two.b}) {
        const bmr_convex32_block *piece = BigPolygonOf(*fixture->GetShape());
        if (piece != nullptr && piece->polygon.seams != nullptr)
            return true;
    }
    return false;
}

void AnswerForOthers(const b2Contact &contact, const TwoFixtures &two, bool isImpact, b2Manifold *manifold,
                     const b2Transform &xfA, const b2Transform &xfB, bmr_convex32_memory memory) {
    if (!isImpact && AreApart(two, xfA, xfB, &memory)) // nothing overlaps
        return;
    b2Manifold plain = *manifold;
    CollideConvex(two, Seams::Ignored, &plain, xfA, xfB, &memory);
    if (plain.pointCount == 0 && !isImpact)
        return;
    Others others(contact, xfA, xfB);
    if (isImpact ? !IsLeftAtImpact(&others, two, plain, manifold) : !IsLeft(&others, two, plain))
        *manifold = plain;
}

} // namespace bmr
