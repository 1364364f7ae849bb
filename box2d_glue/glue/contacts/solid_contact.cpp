// SPDX-License-Identifier: MIT
#include "glue/contacts/solid_contact.h"

#include <box2d/b2_collision.h>
#include <box2d/b2_edge_shape.h>
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_world.h>

#include "base/private_members.h"
#include "base/rounding_mode.h"
#include "debug/statistics.h"
#include "debug/verify.h"
#include "glue/contacts/convex_contact.h"
#include "glue/pairs/pair_tables.h"
#include "shapes/big_polygons.h"
#include "shapes/shapes32.h"
#include "start/settings.h"

namespace bmr {

// An update.

namespace {

/// b2TestOverlap of a contact of which a fixture is a sensor.
bool Overlaps(b2Contact *contact) {
    const b2Fixture &a = *contact->GetFixtureA(), &b = *contact->GetFixtureB();
    const int32 childA = contact->GetChildIndexA(), childB = contact->GetChildIndexB();
    const b2Transform &poseA = a.GetBody()->GetTransform(), &poseB = b.GetBody()->GetTransform();
    const auto ofBox2D = [&] {
        return b2TestOverlap(a.GetShape(), childA, b.GetShape(), childB, poseA, poseB);
    };
    if (!RoundsToNearest())
        return ofBox2D();
    PolygonContact *const ours = PolygonContact::AsOurs(contact);
    const Overlap answer = CertainOverlap(*a.GetShape(), childA, *b.GetShape(), childB, poseA, poseB,
                                          ours != nullptr ? ours->Memory() : nullptr, contact->IsTouching());
    return answer == Overlap::kUnknown ? ofBox2D() : answer == Overlap::kOverlapping;
}

/// Points that were there before, by their features, keep the impulses that the solver starts from.
void KeepImpulses(b2Manifold *manifold, const b2Manifold &old) {
    for (int32 i = 0; i < manifold->pointCount; ++i) {
        b2ManifoldPoint &point = manifold->points[i];
        const b2ManifoldPoint *before = nullptr;
        for (int32 j = old.pointCount; j-- > 0;) // the first of equals, should there be any, is taken last
            if (old.points[j].id.key == point.id.key)
                before = &old.points[j];
        point.normalImpulse = before != nullptr ? before->normalImpulse : 0.0f;
        point.tangentImpulse = before != nullptr ? before->tangentImpulse : 0.0f;
    }
}

} // namespace

ContactChange UpdateContact(b2Contact *contact) {
    ContactChange change;
    b2Fixture *const a = contact->GetFixtureA(), *const b = contact->GetFixtureB();
    b2Manifold &manifold = *contact->GetManifold();
    change.touched = contact->IsTouching();
    change.isSensor = a->IsSensor() || b->IsSensor();
    ContactAccess::Flags(contact) |= ContactAccess::kEnabled;
    if (change.isSensor) {
        change.touches = Overlaps(contact);
        manifold.pointCount = 0;
    } else {
        change.old = manifold;
        if (SolidContact *const ours = SolidContact::AsOurs(contact))
            ours->MakeManifold();
        else
            contact->Evaluate(&manifold, a->GetBody()->GetTransform(), b->GetBody()->GetTransform());
        KeepImpulses(&manifold, change.old);
        change.touches = manifold.pointCount > 0;
    }
    if (change.touches != change.touched) {
        if (!change.isSensor) {
            a->GetBody()->SetAwake(true);
            b->GetBody()->SetAwake(true);
        }
        ContactAccess::Flags(contact) ^= ContactAccess::kTouching;
    }
    if (Verifying())
        VerifyContact(*contact);
    return change;
}

namespace {

PairTable *PairTableOf(const b2Contact &contact) {
    return FindPairTable(&contact.GetFixtureA()->GetBody()->GetWorld()->GetContactManager());
}

} // namespace

bool SolidContact::HullsSayApart(const b2Transform &xfA, const b2Transform &xfB) const {
    PairTable *const table = PairTableOf(*this);
    const uint32_t number = table != nullptr ? table->NumberOf(this) : PairTable::kNone;
    return number != PairTable::kNone && table->hullPairs.SayApart(number, *this, xfA, xfB);
}

bmr_vec2 SolidContact::GuessDirection() const {
    PairTable *const table = PairsAreHulls() ? PairTableOf(*this) : nullptr;
    const HullPair *const pair = table != nullptr ? table->hullPairs.Find(table->NumberOf(this)) : nullptr;
    const bmr_vec2 ofHulls = pair != nullptr ? DirectionOf(*pair, *this) : bmr_vec2{0.0, 0.0};
    return ofHulls.x != 0.0 || ofHulls.y != 0.0 ? ofHulls : KnownDirection();
}

void SolidContact::Evaluate(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) {
    if (PairTable *const table = PairTableOf(*this)) {
        table->deferred.NoteGame(); // it may be the game that asks, in the midst of a call
        table->Flag(this);
    }
    Fill(manifold, xfA, xfB);
}

// Two polygons of Box2D's own size.

namespace {

const b2PolygonShape &PolygonShapeOf(const b2Fixture *fixture) {
    return *static_cast<const b2PolygonShape *>(fixture->GetShape());
}

/// Set makes polygons of 3 vertices and more; a polygon that was never Set has none.
bool HasCornersOfBox2D(const b2PolygonShape &shape) {
    return shape.m_count >= 3 && shape.m_count <= b2_maxPolygonVertices;
}

/// `edgeFound`: an edge was searched, and separates the two. (So it may in the end of two that were taken for
/// touching.)
ProofResult ResultOf(Answer answer, bool edgeFound) {
    if (edgeFound)
        return ProofResult::Another;
    return answer == Answer::ApartByEdge ? ProofResult::Remembered : ProofResult::Nothing;
}

} // namespace

bool PolygonContact::Serves(const b2Shape &a, const b2Shape &b) {
    return !AnyBigPolygon() || (BigPolygonOf(a) == nullptr && BigPolygonOf(b) == nullptr);
}

/// b2PolygonContact::Evaluate. Ahead of it the edge that is remembered is asked, or the structure of the two
/// bodies. Not if the two touched at the last update: most likely they touch still. (Then their own manifold
/// has points; the caller's may be uninitialised.)
inline void PolygonContact::Fill(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) {
    const bool toNearest = RoundsToNearest(), hulls = PairsAreHulls();
    Answer answer = m_manifold.pointCount > 0 ? Answer::Touching : Answer::HandedOver;
    if (answer == Answer::HandedOver && toNearest &&
        (hulls ? HullsSayApart(xfA, xfB) : EdgeSeparates(xfA, xfB)))
        answer = hulls ? Answer::ApartByPair : Answer::ApartByEdge;
    const b2PolygonShape &a = PolygonShapeOf(m_fixtureA), &b = PolygonShapeOf(m_fixtureB);
    const bool here = toNearest && HasCornersOfBox2D(a) && HasCornersOfBox2D(b);
    bool edgeFound = false;
    if (IsApart(answer))
        manifold->pointCount = 0;
    else if (here)
        edgeFound = Search(manifold, xfA, xfB);
    else
        b2CollidePolygons(manifold, &a, xfA, &b, xfB);
    if (edgeFound && answer == Answer::HandedOver)
        answer = Answer::ApartBySearch;
    if (!GetSettings().options.statistics)
        return;
    if (!hulls) { // else the structure of the two bodies has events
        TakeResult(ResultOf(answer, edgeFound));
        if (answer != Answer::Touching)
            Count(&Counts::edgeChecks);
    }
    ReportAnswer(*this, answer, here);
}

/// b2CollidePolygons; where a face separates the two, remembers it and returns true.
inline bool PolygonContact::Search(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) {
    constexpr float kTolerance = 0.1f * b2_linearSlop; // Box2D's: B's face must be better by this
    const bmr_polygon32 a = Polygon32(PolygonShapeOf(m_fixtureA)), b = Polygon32(PolygonShapeOf(m_fixtureB));
    const int32_t edge = bmr_exact32_collide(Manifold32(manifold), &a, Transform32(xfA), &b, Transform32(xfB),
                                             RadiusSum(), kTolerance);
    // (With Options::pairsBy no update asks this edge: it is the direction of the pair's line.)
    state.edge.ofB = edge >= BMR_EDGES_OF_B32;
    state.edge.number = static_cast<uint8_t>(edge == BMR_NO_EDGE32 ? kNoEdge : edge & (BMR_EDGES_OF_B32 - 1));
    return edge != BMR_NO_EDGE32;
}

/// Box2D's own test, on the remembered edge alone: where that edge's separation is larger than the radii, so
/// is the largest.
inline bool PolygonContact::EdgeSeparates(const b2Transform &xfA, const b2Transform &xfB) const {
    const EdgeMemory &memory = state.edge;
    const b2PolygonShape &owner = PolygonShapeOf(memory.ofB ? m_fixtureB : m_fixtureA),
                         &other = PolygonShapeOf(memory.ofB ? m_fixtureA : m_fixtureB);
    // Also where no edge is remembered; and vertices may have been edited in place: the edge may be gone.
    if (memory.number >= owner.m_count)
        return false;
    const float separation = bmr_exact32_posed_separation(
        Vectors32(owner.m_vertices) + memory.number, Vectors32(owner.m_normals) + memory.number,
        Transform32(memory.ofB ? xfB : xfA), Vectors32(other.m_vertices), other.m_count,
        Transform32(memory.ofB ? xfA : xfB));
    return separation > RadiusSum();
}

bmr_vec2 PolygonContact::KnownDirection() const {
    const EdgeMemory &memory = state.edge;
    const bool ofB = memory.ofB;
    const b2Fixture *owner = ofB ? m_fixtureB : m_fixtureA;
    if (memory.isVertex || memory.number >= PolygonShapeOf(owner).m_count)
        return {0.0, 0.0};
    const b2Vec2 normal =
        b2Mul(owner->GetBody()->GetTransform().q, PolygonShapeOf(owner).m_normals[memory.number]);
    return Double(ofB ? -normal : normal);
}

// An edge or a link of a chain, and a polygon.

bool EdgeContact::Serves(const b2Shape & /*a*/, const b2Shape &b) {
    return BigPolygonOf(b) == nullptr;
}

void EdgeContact::Evaluate(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) {
    const b2PolygonShape &polygon = PolygonShapeOf(m_fixtureB);
    if (HasCornersOfBox2D(polygon) && RoundsToNearest()) {
        const bmr_edge32 edge = EdgeOf(m_fixtureA, m_indexA);
        const bmr_polygon32 other = Polygon32(polygon);
        if (bmr_exact32_collide_edge(Manifold32(manifold), &edge, Transform32(xfA), &other,
                                     *Vectors32(&polygon.m_centroid), Transform32(xfB),
                                     polygon.m_radius + m_fixtureA->GetShape()->m_radius))
            return;
    }
    const b2EdgeShape link = LinkOf(*m_fixtureA, m_indexA);
    b2CollideEdgeAndPolygon(manifold, &link, xfA, &polygon, xfB);
}

// The events of a contact.

namespace {

/// The event of an update that leads from one state to the next; BMR_EVENT_KIND_COUNT if there is none.
bmr_event_kind EventOf(CertificateState before, CertificateState after, ProofResult result) {
    if (after == CertificateState::Contact)
        return before == after ? BMR_EVENT_KIND_COUNT : BMR_EVENT_CONTACT;
    if (before == CertificateState::None)
        return BMR_EVENT_START;
    if (before == CertificateState::Contact)
        return BMR_EVENT_LEAVE;
    if (before != after)
        return after == CertificateState::Coarse ? BMR_EVENT_COARSEN : BMR_EVENT_STAB;
    return result == ProofResult::Another ? BMR_EVENT_PUSH : BMR_EVENT_KIND_COUNT;
}

} // namespace

void SolidContact::TakeResult(ProofResult result) {
    constexpr int8_t kCoarse = BMR_LEVEL_DISKS, kPolygons = 0;
    const CertificateState before = state.certificate;
    state.certificate = result == ProofResult::Nothing   ? CertificateState::Contact
                        : result == ProofResult::ByDisks ? CertificateState::Coarse
                                                         : CertificateState::Apart;
    const bmr_event_kind event = EventOf(before, state.certificate, result);
    const bool fromPolygons = before == CertificateState::Apart || before == CertificateState::Contact;
    const bool toCoarse = state.certificate == CertificateState::Coarse;
    if (event != BMR_EVENT_KIND_COUNT)
        ReportEvent(m_fixtureA->GetBody(), m_fixtureB->GetBody(),
                    {event, fromPolygons ? kPolygons : kCoarse, toCoarse ? kCoarse : kPolygons, nullptr,
                     nullptr, 0.0});
}

void SolidContact::LeaveByLine() {
    if (state.certificate == CertificateState::Contact)
        TakeResult(ProofResult::Another);
}

} // namespace bmr
