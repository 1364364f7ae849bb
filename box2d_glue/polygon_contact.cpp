// SPDX-License-Identifier: MIT
#include "polygon_contact.h"

#include <algorithm>
#include <cstring>
#include <new>

#include <box2d/b2_block_allocator.h>
#include <box2d/b2_body.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_world_callbacks.h>

#include "body_pair.h"
#include "current_step.h"
#include "pair_registry.h"
#include "settings.h"
#include "shapes32.h"
#include "verify.h"

namespace bmr {

namespace {

// A search for a separating edge that finds none is paid for nothing, because Box2D then does its own. In a
// pile the same pairs fail again and again: after 1, 2, 4, ... failures in a row this many evaluations go to
// Box2D unsearched.
constexpr uint8_t kMostPatience = 4;

/// What the register held before us: it made the contacts that are not ours.
b2ContactDestroyFcn *stockDestroy = nullptr;

/// Tells our contacts from stock's. Games build Box2D without run-time type information too, where typeid has
/// nothing to look at; but an object's table of virtual functions is always its first word, on every ABI that
/// Box2D runs on.
const void *ourVtable = nullptr;

const void *VtableOf(const b2Contact *contact) {
    const void *vtable;
    std::memcpy(&vtable, static_cast<const void *>(contact), sizeof vtable);
    return vtable;
}

const b2PolygonShape &ShapeOf(const b2Fixture *fixture) {
    return *static_cast<const b2PolygonShape *>(fixture->GetShape());
}

} // namespace

void PolygonContact::Register() {
    // Whoever found out which Box2D this is made contacts: else the first b2Contact::Create of the process
    // would fill the register and overwrite our entry.
    b2Assert(s_initialized);
    const PolygonContact ours;
    ourVtable = VtableOf(&ours);
    stockDestroy = s_registers[b2Shape::e_polygon][b2Shape::e_polygon].destroyFcn;
    AddType(Create, Destroy, b2Shape::e_polygon, b2Shape::e_polygon);
}

PolygonContact *PolygonContact::AsOurs(b2Contact *contact) {
    return VtableOf(contact) == ourVtable ? static_cast<PolygonContact *>(contact) : nullptr;
}

const PolygonContact *PolygonContact::AsOurs(const b2Contact *contact) {
    return AsOurs(const_cast<b2Contact *>(contact));
}

PolygonContact::PolygonContact(b2Fixture *fixtureA, b2Fixture *fixtureB)
    : b2Contact(fixtureA, 0, fixtureB, 0), state() {
    state.edge = kNoEdge;
}

b2Contact *PolygonContact::Create(b2Fixture *fixtureA, int32 /*indexA*/, b2Fixture *fixtureB,
                                  int32 /*indexB*/, b2BlockAllocator *allocator) {
    void *memory = allocator->Allocate(sizeof(PolygonContact));
    PolygonContact *contact = new (memory) PolygonContact(fixtureA, fixtureB);
    AttachPair(contact, allocator);
    return contact;
}

void PolygonContact::Destroy(b2Contact *contact, b2BlockAllocator *allocator) {
    PolygonContact *ours = AsOurs(contact);
    if (ours == nullptr) {
        stockDestroy(contact, allocator);
        return;
    }
    DetachPair(ours, allocator);
    ours->~PolygonContact();
    allocator->Free(ours, sizeof(PolygonContact));
}

float PolygonContact::RadiusSum() const {
    return ShapeOf(m_fixtureA).m_radius + ShapeOf(m_fixtureB).m_radius;
}

void PolygonContact::Evaluate(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) {
    if (!Verifying()) {
        EvaluateHere(manifold, xfA, xfB);
        return;
    }
    b2Manifold ours = *manifold;
    EvaluateHere(&ours, xfA, xfB);
    b2CollidePolygons(manifold, &ShapeOf(m_fixtureA), xfA, &ShapeOf(m_fixtureB), xfB);
    VerifyManifold(m_fixtureA, m_fixtureB, ours, *manifold);
}

inline void PolygonContact::EvaluateHere(b2Manifold *manifold, const b2Transform &xfA,
                                         const b2Transform &xfB) {
    FillManifold(Ask(xfA, xfB), manifold, xfA, xfB);
}

/// The manifold, once it has been asked whether the two are apart.
inline void PolygonContact::FillManifold(Answer answer, b2Manifold *manifold, const b2Transform &xfA,
                                         const b2Transform &xfB) {
    if (answer < Answer::HandedOver)
        manifold->pointCount = 0;
    else if (!ManifoldIsMadeHere())
        b2CollidePolygons(manifold, &ShapeOf(m_fixtureA), xfA, &ShapeOf(m_fixtureB), xfB);
    else if (CollideHere(manifold, xfA, xfB) && answer == Answer::HandedOver)
        answer = Answer::ApartBySearch;
    if (GetSettings().options.statistics)
        CountAnswer(answer);
}

void PolygonContact::UpdateSolid(b2ContactListener *listener) {
    b2Body *bodyA = m_fixtureA->GetBody(), *bodyB = m_fixtureB->GetBody();
    const b2Transform &xfA = bodyA->GetTransform(), &xfB = bodyB->GetTransform();
    const bool wasTouching = (m_flags & e_touchingFlag) != 0;
    m_flags |= e_enabledFlag;
    const Answer answer = Ask(xfA, xfB);
    if (answer < Answer::HandedOver && !wasTouching) { // nothing has happened that anybody is to be told
        FillManifold(answer, &m_manifold, xfA, xfB);
        return;
    }
    const b2Manifold old = m_manifold;
    FillManifold(answer, &m_manifold, xfA, xfB);
    KeepImpulses(old);
    const bool touching = m_manifold.pointCount > 0;
    if (touching != wasTouching) {
        bodyA->SetAwake(true);
        bodyB->SetAwake(true);
        m_flags ^= e_touchingFlag;
    }
    if (listener == nullptr)
        return;
    if (touching && !wasTouching)
        listener->BeginContact(this);
    if (!touching && wasTouching)
        listener->EndContact(this);
    if (touching)
        listener->PreSolve(this, &old);
}

/// Points that were there before, by their features, keep the impulses that the solver starts from.
inline void PolygonContact::KeepImpulses(const b2Manifold &old) {
    for (int32 i = 0; i < m_manifold.pointCount; ++i) {
        b2ManifoldPoint &point = m_manifold.points[i];
        const b2ManifoldPoint *before = nullptr;
        for (int32 j = old.pointCount; j-- > 0;) // the first of equals, should there be any, is taken last
            if (old.points[j].id.key == point.id.key)
                before = &old.points[j];
        point.normalImpulse = before != nullptr ? before->normalImpulse : 0.0f;
        point.tangentImpulse = before != nullptr ? before->tangentImpulse : 0.0f;
    }
}

void PolygonContact::UpdateByBox2D(b2Contact *contact, b2ContactListener *listener) {
    (contact->*(&PolygonContact::Update))(listener);
}

inline Answer PolygonContact::Ask(const b2Transform &xfA, const b2Transform &xfB) {
    // What touched at the last look most likely touches still: no question asked. (Its own manifold is read,
    // not the caller's, which anybody may pass uninitialised.)
    if (m_manifold.pointCount > 0)
        return Answer::Touching;
    // Hulls that overlapped at the last look (concave bodies, close together) most likely do so still: there
    // the edge is asked first.
    const bool pairFirst = state.pair != nullptr && state.pair->verdict == BMR_APART;
    if (pairFirst && PairSaysApart(xfA, xfB))
        return Answer::ApartByPair;
    if (EdgeSaysApart(xfA, xfB))
        return Answer::ApartByEdge;
    if (state.pair != nullptr && !pairFirst && PairSaysApart(xfA, xfB))
        return Answer::ApartByPair;
    // A manifold that is made here begins with the search for an edge; Box2D's would do it again.
    return !ManifoldIsMadeHere() && FindEdge(xfA, xfB) ? Answer::ApartBySearch : Answer::HandedOver;
}

void PolygonContact::CountAnswer(Answer answer) const {
    Count(&Counts::evaluations);
    Count(answer < Answer::HandedOver ? &Counts::provedApart : &Counts::handedOver);
    if (answer >= Answer::HandedOver && ManifoldIsMadeHere())
        Count(&Counts::touchingAnswered);
    if (answer == Answer::Touching)
        Count(&Counts::handedOverTouching);
    else if (answer != Answer::ApartByPair && EdgesAreOn())
        Count(&Counts::edgeChecks);
    const Options &options = GetSettings().options;
    if (options.onAnswer != nullptr)
        options.onAnswer(options.eventContext, *this, answer);
}

/// Are there manifolds with Box2D's bits to be had without it? (Set makes polygons of 3 vertices and more; a
/// polygon that was never Set has none.)
inline bool PolygonContact::ManifoldIsMadeHere() const {
    const auto known = [](const b2PolygonShape &shape) { return shape.m_count >= 3 && shape.m_count <= 8; };
    return HookIsOn(Hook::TouchingManifold) && GetSettings().sameRounding && known(ShapeOf(m_fixtureA)) &&
           known(ShapeOf(m_fixtureB));
}

/// b2CollidePolygons; where a face separates the two, remembers it and returns true.
inline bool PolygonContact::CollideHere(b2Manifold *manifold, const b2Transform &xfA,
                                        const b2Transform &xfB) {
    constexpr float kTolerance = 0.1f * b2_linearSlop; // Box2D's: B's face must be better by this
    const bmr_polygon32 a = Polygon32(ShapeOf(m_fixtureA)), b = Polygon32(ShapeOf(m_fixtureB));
    const int32_t edge = bmr_exact32_collide(Manifold32(manifold), &a, Transform32(xfA), &b, Transform32(xfB),
                                             RadiusSum(), kTolerance);
    if (!EdgesAreOn())
        return false;
    state.edgeOfB = edge >= BMR_EDGES_OF_B32;
    state.edge = static_cast<uint8_t>(edge == BMR_NO_EDGE32 ? kNoEdge : edge & (BMR_EDGES_OF_B32 - 1));
    return edge != BMR_NO_EDGE32;
}

bool PolygonContact::PairSaysApart(const b2Transform &xfA, const b2Transform &xfB) {
    BodyPair *pair = state.pair, *parent = pair->parent;
    const uint64_t step = CurrentStep();
    if ((pair->a->lookedAt != step || pair->b->lookedAt != step || parent != nullptr) && !LookAtShapes(this))
        return false;
    if (state.stamp != StampOf(*pair) ? !VerifyStamp(this) : state.excluded)
        return false;
    const b2Body *bodyA = m_fixtureA->GetBody();
    const float radiusSum = RadiusSum();
    const auto apart = [&](BodyPair *asked) {
        const bool swapped = asked->a->body != bodyA;
        // Radii may be changed by anybody at any time.
        return radiusSum <= asked->radiusSum && KnownApart(asked, swapped ? xfB : xfA, swapped ? xfA : xfB);
    };
    return (parent != nullptr && apart(parent)) || apart(pair);
}

/// Box2D's own test on the remembered edge alone: where that edge's separation is larger than the radii, so
/// is the largest.
inline bool PolygonContact::EdgeSaysApart(const b2Transform &xfA, const b2Transform &xfB) const {
    const b2PolygonShape &a = ShapeOf(m_fixtureA), &b = ShapeOf(m_fixtureB);
    const bool ofB = state.edgeOfB;
    const b2PolygonShape &owner = ofB ? b : a, &other = ofB ? a : b;
    // Also where no edge is remembered; and vertices may have been edited in place: the edge may be gone.
    if (state.edge >= owner.m_count)
        return false;
    const float separation = bmr_exact32_posed_separation(
        Vectors32(owner.m_vertices) + state.edge, Vectors32(owner.m_normals) + state.edge,
        Transform32(ofB ? xfB : xfA), Vectors32(other.m_vertices), other.m_count,
        Transform32(ofB ? xfA : xfB));
    return separation > a.m_radius + b.m_radius;
}

/// Remembers the edge of largest separation of a polygon, if it separates the two in Box2D's sense.
bool PolygonContact::FindEdge(const b2Transform &xfA, const b2Transform &xfB) {
    if (!EdgesAreOn())
        return false;
    if (state.edge == kNoEdge && state.unasked > 0) {
        --state.unasked;
        return false;
    }
    Count(&Counts::edgeSearches);
    const float radiusSum = RadiusSum();
    // The first polygon that has a separating edge will do, as it does for Box2D.
    for (const bool ofB : {false, true}) {
        const bmr_polygon32 owner = Polygon32(ShapeOf(ofB ? m_fixtureB : m_fixtureA));
        const bmr_polygon32 other = Polygon32(ShapeOf(ofB ? m_fixtureA : m_fixtureB));
        const bmr_transform32 frame =
            bmr_exact32_relative(Transform32(ofB ? xfA : xfB), Transform32(ofB ? xfB : xfA));
        int32_t edge = 0;
        if (bmr_exact32_max_separation(&owner, &other, &frame, &edge) > radiusSum) {
            state.edge = static_cast<uint8_t>(edge);
            state.edgeOfB = ofB;
            state.patience = 0;
            return true;
        }
    }
    state.edge = kNoEdge;
    state.unasked = static_cast<uint8_t>((1u << state.patience) - 1u);
    state.patience = std::min<uint8_t>(static_cast<uint8_t>(state.patience + 1), kMostPatience) & 0xfu;
    return false;
}

} // namespace bmr
