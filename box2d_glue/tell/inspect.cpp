// SPDX-License-Identifier: MIT
#include "boomerang/inspect.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>

#include "contacts/polygon_contact.h"
#include "proofs/face_gap.h"
#include "proofs/polygon_view.h"
#include "start/reach.h"
#include "start/settings.h"
#include "world/ledger.h"
#include "world/ledgers.h"

namespace bmr {

namespace {

b2Vec2 Float(const bmr_vec2 &v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y)};
}

b2Vec2 FromPolygon(bmr_vec32 v) {
    return {v.x, v.y};
}

b2Vec2 FromCertificate(const float v[2]) {
    return {v[0], v[1]};
}

/// Rounded down: still a lower bound.
float Slack(double gap) {
    return gap > 0.0 ? std::nextafterf(static_cast<float>(gap), 0.0f) : 0.0f;
}

bool IsSolidPolygon(const b2Fixture &fixture) {
    return fixture.GetType() == b2Shape::e_polygon && !fixture.IsSensor();
}

void SetSupport(ProofSide *side, const b2Vec2 &point) {
    side->support = side->window[0] = side->window[1] = point;
}

/// A hierarchy's own level for a level of the pair: where one is deeper, the other's polygon stays.
uint32_t LevelOf(const bmr_hierarchy &hierarchy, int32_t level) {
    return std::min(static_cast<uint32_t>(std::max(level, 0)), bmr_hierarchy_depth(&hierarchy));
}

void FillDisks(const HullPair &pair, const bmr_pair &kinetic, ProofSide *a, ProofSide *b, Proof *proof) {
    proof->kind = ProofKind::Disks;
    SetSupport(a, FromCertificate(kinetic.certificate.normal));
    SetSupport(b, FromCertificate(kinetic.certificate.window[0]));
    a->diskRadius = static_cast<float>(pair.a->Shape().polygon->radius);
    b->diskRadius = static_cast<float>(pair.b->Shape().polygon->radius);
}

/// The pair remembers which vertex of the other was the nearest when the direction was taken; by now it may
/// be another.
void FillDirection(const bmr_polygon &own, const bmr_polygon &others, const bmr_pair &kinetic,
                   ProofSide *owner, ProofSide *other, Proof *proof) {
    proof->kind = ProofKind::Direction;
    const b2Vec2 facing = other->body->GetLocalVector(
        owner->body->GetWorldVector(-FromCertificate(kinetic.certificate.normal)));
    const bmr_vec2 way = {static_cast<double>(facing.x), static_cast<double>(facing.y)};
    SetSupport(owner, Float(own.vertices[kinetic.edge]));
    SetSupport(other, Float(others.vertices[bmr_polygon_support_from(&others, way, kinetic.other)]));
    for (int i = 0; i < 2; ++i)
        other->window[i] = FromCertificate(kinetic.certificate.window[i]);
}

void FillEdgeLine(const bmr_hierarchy &own, const bmr_hierarchy &others, const bmr_pair &kinetic,
                  ProofSide *owner, ProofSide *other, Proof *proof) {
    proof->kind = ProofKind::EdgeLine;
    proof->level = kinetic.level;
    const uint32_t level = LevelOf(own, kinetic.level);
    const bmr_corner ends[2] = {bmr_hierarchy_corner_before(&own, kinetic.edge, level),
                                bmr_hierarchy_corner_after(&own, kinetic.edge, level)};
    for (int i = 0; i < 2; ++i)
        proof->edge[i] = Float(bmr_hierarchy_corner_point(&own, ends[i]));
    const bmr_corner facing = bmr_hierarchy_corner(&others, kinetic.other, kinetic.other_after);
    SetSupport(owner, proof->edge[0]);
    SetSupport(other, Float(bmr_hierarchy_corner_point(&others, facing)));
}

/// With Options::pairsBy: the proof of the bodies' structure at their poses. False if it proves nothing.
bool AskHulls(const b2Contact &contact, Proof *proof) {
    Ledger *const ledger = FindLedger(&contact.GetFixtureA()->GetBody()->GetWorld()->GetContactManager());
    const HullPair *const pair =
        ledger != nullptr ? ledger->GetHullPairs().Find(ledger->NumberOf(&contact)) : nullptr;
    double gap = 0.0;
    const bmr_pair kinetic = pair != nullptr ? KineticPairNow(*pair, &gap) : bmr_pair{};
    if (!(gap > 0.0))
        return false;
    const bool swapped = pair->IsSwapped(contact);
    ProofSide *sides[2] = {swapped ? &proof->b : &proof->a, swapped ? &proof->a : &proof->b};
    const Hull *hulls[2] = {pair->a, pair->b};
    for (int i = 0; i < 2; ++i)
        sides[i]->fixture = hulls[i]->Fixture();
    const int owner = kinetic.owner;
    if (kinetic.level == BMR_LEVEL_DISKS) {
        FillDisks(*pair, kinetic, sides[0], sides[1], proof);
    } else {
        const Hull &own = *hulls[owner], &others = *hulls[1 - owner];
        if (own.Hierarchy() == nullptr || others.Hierarchy() == nullptr || kinetic.free != 0)
            FillDirection(*own.Shape().polygon, *others.Shape().polygon, kinetic, sides[owner],
                          sides[1 - owner], proof);
        else
            FillEdgeLine(*own.Hierarchy(), *others.Hierarchy(), kinetic, sides[owner], sides[1 - owner],
                         proof);
        proof->normal = FromCertificate(kinetic.certificate.normal);
        proof->ownerIsB = (owner == 1) != swapped;
    }
    proof->slack = Slack(gap);
    // Has the advance changed anything? Bits will do. NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
    proof->remembered = std::memcmp(&kinetic, &pair->kinetic, sizeof kinetic) == 0;
    proof->structure = pair;
    return true;
}

const b2PolygonShape &ShapeOf(const b2Fixture &fixture) {
    return static_cast<const b2PolygonShape &>(*fixture.GetShape());
}

/// In Box2D's sense.
bool Separates(const FaceGap &gap, const b2Fixture &owner, const b2Fixture &other) {
    return gap.separation > ShapeOf(owner).m_radius + ShapeOf(other).m_radius;
}

/// If the edge separates the two, it is the proof.
bool AskEdge(const FaceGap &gap, const b2Fixture &owner, const b2Fixture &other, bool ofB, Proof *proof) {
    if (!Separates(gap, owner, other))
        return false;
    const bmr_convex32 own = RealPolygon(owner), others = RealPolygon(other);
    const auto first = static_cast<uint32_t>(gap.edge), second = first + 1 == own.count ? 0 : first + 1;
    proof->kind = ProofKind::RememberedEdge;
    proof->ownerIsB = ofB;
    proof->normal = FromPolygon(own.normals[first]);
    proof->edge[0] = FromPolygon(own.vertices[first]);
    proof->edge[1] = FromPolygon(own.vertices[second]);
    proof->slack = Slack(gap.proved);
    proof->a.fixture = ofB ? &other : &owner;
    proof->b.fixture = ofB ? &owner : &other;
    const b2Vec2 facing =
        b2MulT(other.GetBody()->GetTransform().q, b2Mul(owner.GetBody()->GetTransform().q, -proof->normal));
    const uint32_t nearest = bmr_convex32_support(&others, *Vectors32(&facing));
    SetSupport(ofB ? &proof->b : &proof->a, proof->edge[0]);
    SetSupport(ofB ? &proof->a : &proof->b, FromPolygon(others.vertices[nearest]));
    return true;
}

bool AskRememberedEdge(const PolygonContact &contact, Proof *proof) {
    const EdgeMemory &memory = contact.state.edge;
    const bool ofB = memory.ofB;
    const b2Fixture &owner = ofB ? *contact.GetFixtureB() : *contact.GetFixtureA();
    const b2Fixture &other = ofB ? *contact.GetFixtureA() : *contact.GetFixtureB();
    if (memory.number >= ShapeOf(owner).m_count || IsBig(owner) || IsBig(other))
        return false;
    proof->remembered = AskEdge(FaceGapAlong(memory.number, owner, other), owner, other, ofB, proof);
    return proof->remembered;
}

bool SearchEdge(const b2Contact &contact, Proof *proof) {
    const b2Fixture &a = *contact.GetFixtureA(), &b = *contact.GetFixtureB();
    return AskEdge(LargestFaceGap(a, b), a, b, false, proof) ||
           AskEdge(LargestFaceGap(b, a), b, a, true, proof);
}

/// In the order of PolygonContact::Ask, and of ConvexContact's, which remembers vertices and no edge.
void Ask(const SolidContact &contact, const PolygonContact *ofSmall, Proof *proof) {
    if (PairsAreHulls())
        AskHulls(contact, proof);
    else if (ofSmall == nullptr || !AskRememberedEdge(*ofSmall, proof))
        SearchEdge(contact, proof);
}

int32_t CopyVertices(const bmr_polygon &polygon, b2Vec2 *vertices, int32_t capacity) {
    const auto count = static_cast<int32_t>(polygon.count);
    for (int32_t i = 0; i < std::min(count, capacity); ++i)
        vertices[i] = Float(polygon.vertices[i]);
    return count;
}

int32_t CopyEnvelope(const bmr_hierarchy &hierarchy, uint32_t level, b2Vec2 *vertices, int32_t capacity) {
    int32_t count = 0;
    bmr_edge edge = 0;
    do {
        const bmr_corner corner = bmr_hierarchy_corner_after(&hierarchy, edge, level);
        if (count < capacity)
            vertices[count] = Float(bmr_hierarchy_corner_point(&hierarchy, corner));
        ++count;
        edge = corner.after;
    } while (edge != 0); // a root: on every level
    return count;
}

} // namespace

const char *NameOf(ProofKind kind) {
    switch (kind) {
    case ProofKind::None:
        return "none";
    case ProofKind::Disks:
        return "disks";
    case ProofKind::EdgeLine:
        return "edge-line";
    case ProofKind::Direction:
        return "direction";
    case ProofKind::RememberedEdge:
        return "remembered-edge";
    case ProofKind::Count:
        break;
    }
    return nullptr;
}

Proof Inspect(const b2Contact &contact) {
    Proof proof;
    const b2Fixture *a = contact.GetFixtureA(), *b = contact.GetFixtureB();
    proof.a.body = a->GetBody();
    proof.b.body = b->GetBody();
    const SolidContact *ours = SolidContact::AsOurs(const_cast<b2Contact *>(&contact));
    const bool touched = contact.GetManifold()->pointCount > 0;
    if (ours != nullptr && !touched && IsSolidPolygon(*a) && IsSolidPolygon(*b))
        Ask(*ours, PolygonContact::AsOurs(&contact), &proof);
    return proof;
}

Proof Inspect(const b2Body *bodyA, const b2Body *bodyB) {
    Proof least;
    bool any = false;
    for (const b2ContactEdge *edge = bodyA != nullptr ? bodyA->GetContactList() : nullptr; edge != nullptr;
         edge = edge->next) {
        const b2Contact &contact = *edge->contact;
        if (edge->other != bodyB || !IsSolidPolygon(*contact.GetFixtureA()) ||
            !IsSolidPolygon(*contact.GetFixtureB()))
            continue;
        const Proof proof = Inspect(contact);
        if (!any || proof.kind == ProofKind::None ||
            (least.kind != ProofKind::None && proof.slack < least.slack))
            least = proof;
        any = true;
    }
    return least;
}

int32_t InspectHull(const Proof &proof, bool ofB, int32_t level, b2Vec2 *vertices, int32_t capacity) {
    const auto *pair = static_cast<const HullPair *>(proof.structure);
    if (pair == nullptr)
        return 0;
    const b2Body *body = ofB ? proof.b.body : proof.a.body;
    const Hull &hull = pair->a->Body() == body ? *pair->a : *pair->b;
    const bmr_hierarchy *hierarchy = hull.Hierarchy();
    if (hierarchy == nullptr || level == kHullLevel)
        return CopyVertices(*hull.Shape().polygon, vertices, capacity);
    return CopyEnvelope(*hierarchy, LevelOf(*hierarchy, level), vertices, capacity);
}

void internal::LinkOfInspect() {}

} // namespace bmr
