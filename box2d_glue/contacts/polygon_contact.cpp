// SPDX-License-Identifier: MIT
#include "contacts/polygon_contact.h"

#include <algorithm>
#include <new>

#include <box2d/b2_block_allocator.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_fixture.h>

#include "base/rounding_mode.h"
#include "contacts/pair_registry.h"
#include "proofs/body_pair.h"
#include "shapes/convex_geometry.h"
#include "shapes/shapes32.h"
#include "start/settings.h"
#include "tell/event.h"
#include "tell/verify.h"

namespace bmr {

namespace {

// A search for a separating edge that finds none is paid for nothing, because Box2D then does its own. In a
// pile the same pairs fail again and again: after 1, 2, 4, ... failures in a row this many evaluations go to
// Box2D unsearched.
constexpr uint8_t kMostPatience = 4;

const b2PolygonShape &ShapeOf(const b2Fixture *fixture) {
    return *static_cast<const b2PolygonShape *>(fixture->GetShape());
}

/// `edgeFound`: an edge was searched, and separates the two. (So it may in the end of two that were taken for
/// touching.)
Held HeldBy(Answer answer, bool edgeFound) {
    if (edgeFound)
        return Held::Another;
    return answer == Answer::ApartByPair   ? Held::ByBodies
           : answer == Answer::ApartByEdge ? Held::Remembered
                                           : Held::Nothing;
}

} // namespace

bool PolygonContact::Serves(const b2Shape &a, const b2Shape &b) {
    return !AnyBigPolygon() || (BigPolygonOf(a) == nullptr && BigPolygonOf(b) == nullptr);
}

b2Contact *PolygonContact::Make(b2Fixture *fixtureA, int32 /*indexA*/, b2Fixture *fixtureB, int32 /*indexB*/,
                                b2BlockAllocator *allocator) {
    void *memory = allocator->Allocate(sizeof(PolygonContact));
    PolygonContact *contact = new (memory) PolygonContact(fixtureA, fixtureB);
    AttachPair(contact, allocator);
    return contact;
}

void PolygonContact::Unmake(PolygonContact *contact, b2BlockAllocator *allocator) {
    DetachPair(contact, allocator);
    contact->~PolygonContact();
    allocator->Free(contact, sizeof(PolygonContact));
}

void PolygonContact::LearnVtable() {
    const PolygonContact ours;
    polygonVtable.store(VtableOf(ours), std::memory_order_relaxed);
}

PolygonContact::PolygonContact(b2Fixture *fixtureA, b2Fixture *fixtureB)
    : SolidContact(fixtureA, 0, fixtureB, 0) {
    state.link.byEdge.number = kNoEdge;
}

void PolygonContact::Evaluate(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) {
    IsLookedAtByOthers();
    FillManifold(Ask(xfA, xfB), manifold, xfA, xfB);
}

void PolygonContact::MakeManifold(bool touched, b2Manifold *old) {
    const b2Transform &xfA = m_fixtureA->GetBody()->GetTransform(),
                      &xfB = m_fixtureB->GetBody()->GetTransform();
    const Answer answer = Ask(xfA, xfB);
    if (touched || answer >= Answer::HandedOver)
        *old = m_manifold;
    FillManifold(answer, &m_manifold, xfA, xfB);
}

inline Answer PolygonContact::Ask(const b2Transform &xfA, const b2Transform &xfB) {
    // What touched at the last look most likely touches still: no question asked. (Its own manifold is read,
    // not the caller's, which may be uninitialised.)
    if (m_manifold.pointCount > 0)
        return Answer::Touching;
    if (!RoundsToNearest())
        return Answer::HandedOver;
    // Hulls that overlapped at the last look (concave bodies, close together) most likely do so still: there
    // the edge is asked first.
    const bool pairFirst = state.pair != nullptr && state.pair->verdict == BMR_APART;
    if (pairFirst && PairSaysApart(this, xfA, xfB))
        return Answer::ApartByPair;
    if (EdgeSaysApart(xfA, xfB))
        return Answer::ApartByEdge;
    if (state.pair != nullptr && !pairFirst && PairSaysApart(this, xfA, xfB))
        return Answer::ApartByPair;
    // A manifold that is made here begins with the search for an edge; Box2D's would do it again.
    return !ManifoldIsMadeHere() && FindEdge(xfA, xfB) ? Answer::ApartBySearch : Answer::HandedOver;
}

/// The manifold, once it has been asked whether the two are apart.
inline void PolygonContact::FillManifold(Answer answer, b2Manifold *manifold, const b2Transform &xfA,
                                         const b2Transform &xfB) {
    bool edgeFound = answer == Answer::ApartBySearch;
    if (answer < Answer::HandedOver)
        manifold->pointCount = 0;
    else if (!ManifoldIsMadeHere())
        b2CollidePolygons(manifold, &ShapeOf(m_fixtureA), xfA, &ShapeOf(m_fixtureB), xfB);
    else
        edgeFound = CollideHere(manifold, xfA, xfB);
    if (edgeFound && answer == Answer::HandedOver)
        answer = Answer::ApartBySearch;
    if (GetSettings().options.statistics) {
        if (EdgesAreOn()) // else a structure of the two fixtures lives for them
            Live(HeldBy(answer, edgeFound), xfA, xfB);
        CountAnswer(answer);
    }
    if (Verifying()) {
        const b2Manifold ours = *manifold;
        b2CollidePolygons(manifold, &ShapeOf(m_fixtureA), xfA, &ShapeOf(m_fixtureB), xfB);
        VerifyManifold(m_fixtureA, m_fixtureB, ours, *manifold);
    }
}

void PolygonContact::CountAnswer(Answer answer) const {
    if (answer < Answer::Touching && answer != Answer::ApartByPair && EdgesAreOn())
        Count(&Counts::edgeChecks);
    TellOfAnswer(*this, answer, ManifoldIsMadeHere());
}

/// Are there manifolds with Box2D's bits to be had without it? (Set makes polygons of 3 vertices and more; a
/// polygon that was never Set has none.)
inline bool PolygonContact::ManifoldIsMadeHere() const {
    const auto known = [](const b2PolygonShape &shape) { return shape.m_count >= 3 && shape.m_count <= 8; };
    return ContactsAreOurs() && RoundsToNearest() &&
           (GetSettings().sameRounding || GetSettings().collideByFace != nullptr) &&
           known(ShapeOf(m_fixtureA)) && known(ShapeOf(m_fixtureB));
}

/// b2CollidePolygons where Box2D rounds otherwise: what it goes by is found here, where that is certain, and
/// its own source makes the points. Returns the edge that separates the two, as bmr_exact32_collide does.
inline int32_t PolygonContact::CollideByKnownFace(b2Manifold *manifold, const b2Transform &xfA,
                                                  const b2Transform &xfB, float tolerance) const {
    const b2PolygonShape &shapeA = ShapeOf(m_fixtureA), &shapeB = ShapeOf(m_fixtureB);
    const bmr_polygon32 a = Polygon32(shapeA), b = Polygon32(shapeB);
    const int32_t face = bmr_exact32_face_contracted(&a, Transform32(xfA), &b, Transform32(xfB),
                                                     shapeA.m_radius + shapeB.m_radius, tolerance);
    if (face >= BMR_SEPARATES32) {
        manifold->pointCount = 0;
        return face - BMR_SEPARATES32;
    }
    if (face == BMR_NO_EDGE32)
        b2CollidePolygons(manifold, &shapeA, xfA, &shapeB, xfB);
    else
        GetSettings().collideByFace(manifold, &shapeA, xfA, &shapeB, xfB, face);
    return BMR_NO_EDGE32;
}

/// b2CollidePolygons; where a face separates the two, remembers it and returns true.
inline bool PolygonContact::CollideHere(b2Manifold *manifold, const b2Transform &xfA,
                                        const b2Transform &xfB) {
    constexpr float kTolerance = 0.1f * b2_linearSlop; // Box2D's: B's face must be better by this
    const bmr_polygon32 a = Polygon32(ShapeOf(m_fixtureA)), b = Polygon32(ShapeOf(m_fixtureB));
    const int32_t edge = GetSettings().sameRounding
                             ? bmr_exact32_collide(Manifold32(manifold), &a, Transform32(xfA), &b,
                                                   Transform32(xfB), RadiusSum(), kTolerance)
                             : CollideByKnownFace(manifold, xfA, xfB, kTolerance);
    if (!EdgesAreOn())
        return false;
    state.link.byEdge.ofB = edge >= BMR_EDGES_OF_B32;
    state.link.byEdge.number =
        static_cast<uint8_t>(edge == BMR_NO_EDGE32 ? kNoEdge : edge & (BMR_EDGES_OF_B32 - 1));
    return edge != BMR_NO_EDGE32;
}

/// Box2D's own test on one edge alone: where that edge's separation is larger than the radii, so is the
/// largest. Where Box2D rounds otherwise the edge must separate by more than that can change.
inline bool PolygonContact::EdgeSeparates(uint8_t number, bool ofB, const b2Transform &xfA,
                                          const b2Transform &xfB) const {
    const b2PolygonShape &a = ShapeOf(m_fixtureA), &b = ShapeOf(m_fixtureB);
    const b2PolygonShape &owner = ofB ? b : a, &other = ofB ? a : b;
    // Also where no edge is remembered; and vertices may have been edited in place: the edge may be gone.
    if (number >= owner.m_count)
        return false;
    if (GetSettings().sameRounding) {
        const float separation = bmr_exact32_posed_separation(
            Vectors32(owner.m_vertices) + number, Vectors32(owner.m_normals) + number,
            Transform32(ofB ? xfB : xfA), Vectors32(other.m_vertices), other.m_count,
            Transform32(ofB ? xfA : xfB));
        return separation > a.m_radius + b.m_radius;
    }
    return other.m_count > 0 && bmr_exact32_separates_contracted(
                                    Vectors32(owner.m_vertices) + number, Vectors32(owner.m_normals) + number,
                                    Transform32(ofB ? xfB : xfA), Vectors32(other.m_vertices), other.m_count,
                                    Transform32(ofB ? xfA : xfB), a.m_radius + b.m_radius);
}

inline bool PolygonContact::EdgeSaysApart(const b2Transform &xfA, const b2Transform &xfB) const {
    return EdgeSeparates(state.link.byEdge.number, state.link.byEdge.ofB, xfA, xfB);
}

bmr_vec2 PolygonContact::KnownDirection() const {
    const EdgeMemory &memory = state.link.byEdge;
    const bool ofB = memory.ofB;
    const b2Fixture *owner = ofB ? m_fixtureB : m_fixtureA;
    if (memory.isVertex || memory.number >= ShapeOf(owner).m_count)
        return {0.0, 0.0};
    const b2Vec2 normal = b2Mul(owner->GetBody()->GetTransform().q, ShapeOf(owner).m_normals[memory.number]);
    const bmr_vec2 d = {static_cast<double>(normal.x), static_cast<double>(normal.y)};
    return ofB ? bmr_neg(d) : d;
}

/// Remembers the edge of largest separation of a polygon, if it separates the two in Box2D's sense.
bool PolygonContact::FindEdge(const b2Transform &xfA, const b2Transform &xfB) {
    if (!EdgesAreOn())
        return false;
    EdgeMemory &memory = state.link.byEdge;
    if (memory.number == kNoEdge && memory.unasked > 0) {
        --memory.unasked;
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
        if (bmr_exact32_max_separation(&owner, &other, &frame, &edge) > radiusSum &&
            (GetSettings().sameRounding || EdgeSeparates(static_cast<uint8_t>(edge), ofB, xfA, xfB))) {
            memory.number = static_cast<uint8_t>(edge);
            memory.ofB = ofB;
            memory.patience = 0;
            return true;
        }
    }
    memory.number = kNoEdge;
    memory.unasked = static_cast<uint8_t>((1u << memory.patience) - 1u);
    memory.patience = std::min<uint8_t>(static_cast<uint8_t>(memory.patience + 1), kMostPatience) & 0xfu;
    return false;
}

} // namespace bmr
