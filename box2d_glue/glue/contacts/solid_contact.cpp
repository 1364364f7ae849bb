// SPDX-License-Identifier: MIT
#include "glue/contacts/solid_contact.h"

#include <box2d/b2_world.h>

#include "debug/statistics.h"
#include "glue/pairs/pair_table.h"
#include "glue/pairs/pair_tables.h"
#include "glue/proofs/apart_line.h"
#include "start/settings.h"

namespace bmr {

namespace {

PairTable *PairTableOf(const b2Contact &contact) {
    return FindPairTable(&contact.GetFixtureA()->GetBody()->GetWorld()->GetContactManager());
}

} // namespace

bool SolidContact::HullsSayApart(const b2Transform &xfA, const b2Transform &xfB) const {
    PairTable *const table = PairTableOf(*this);
    const uint32_t number = table != nullptr ? table->NumberOf(this) : PairTable::kNone;
    return number != PairTable::kNone &&
           table->hullPairs.SayApart(number, *this, xfA, xfB, table->deferred.GameRan() ? 0 : table->Stamp());
}

bmr_vec2 SolidContact::GuessDirection() const {
    PairTable *const table = PairsAreHulls() ? PairTableOf(*this) : nullptr;
    const HullPair *const pair = table != nullptr ? table->hullPairs.Find(table->NumberOf(this)) : nullptr;
    const bmr_vec2 ofHulls = pair != nullptr ? DirectionOf(*pair, *this) : bmr_vec2{0.0, 0.0};
    return ofHulls.x != 0.0 || ofHulls.y != 0.0 ? ofHulls : KnownDirection();
}

bmr_vec32 GuessDirection(const b2Contact &contact) {
    const b2Manifold &manifold = *contact.GetManifold();
    b2Vec2 d(0.0f, 0.0f);
    if (manifold.pointCount > 0) {
        const b2Transform &xfA = contact.GetFixtureA()->GetBody()->GetTransform(),
                          &xfB = contact.GetFixtureB()->GetBody()->GetTransform();
        if (manifold.type == b2Manifold::e_faceA)
            d = b2Mul(xfA.q, manifold.localNormal);
        else if (manifold.type == b2Manifold::e_faceB)
            d = -b2Mul(xfB.q, manifold.localNormal);
        else
            d = b2Mul(xfB, manifold.points[0].localPoint) - b2Mul(xfA, manifold.localPoint);
    } else if (const SolidContact *ours = SolidContact::AsOurs(&contact)) {
        const bmr_vec2 known = ours->IsOfPolygons() ? ours->GuessDirection() : bmr_vec2{0.0, 0.0};
        d.Set(static_cast<float>(known.x), static_cast<float>(known.y));
    }
    // (Normals may be written to in place.)
    return d.Normalize() > 0.0f ? bmr_vec32{d.x, d.y} : bmr_vec32{0.0f, 0.0f};
}

void SolidContact::NoteOtherCaller() const {
    PairTable *const table = PairTableOf(*this);
    if (table == nullptr)
        return;
    table->deferred.NoteGame(); // it may be the game that asks, in the midst of a call
    table->Flag(this, 0);
}

namespace {

constexpr int8_t kCoarse = BMR_LEVEL_DISKS, kPolygons = 0;

/// The state after an update, and the event; BMR_EVENT_KIND_COUNT if there is none.
struct Transition {
    CertificateState next;
    bmr_event_kind event;
    int8_t levelBefore, levelAfter;
};

constexpr Transition Quiet(CertificateState state) {
    return {state, BMR_EVENT_KIND_COUNT, 0, 0};
}

/// A row for each state, a column for each result: Nothing, ByDisks, Remembered, Another.
constexpr Transition kTransitions[4][4] = {
    {{CertificateState::Contact, BMR_EVENT_CONTACT, kCoarse, kPolygons},
     {CertificateState::Coarse, BMR_EVENT_START, kCoarse, kCoarse},
     {CertificateState::Apart, BMR_EVENT_START, kCoarse, kPolygons},
     {CertificateState::Apart, BMR_EVENT_START, kCoarse, kPolygons}},
    {{CertificateState::Contact, BMR_EVENT_CONTACT, kCoarse, kPolygons},
     Quiet(CertificateState::Coarse),
     {CertificateState::Apart, BMR_EVENT_STAB, kCoarse, kPolygons},
     {CertificateState::Apart, BMR_EVENT_STAB, kCoarse, kPolygons}},
    {{CertificateState::Contact, BMR_EVENT_CONTACT, kPolygons, kPolygons},
     {CertificateState::Coarse, BMR_EVENT_COARSEN, kPolygons, kCoarse},
     Quiet(CertificateState::Apart),
     {CertificateState::Apart, BMR_EVENT_PUSH, kPolygons, kPolygons}},
    {Quiet(CertificateState::Contact),
     {CertificateState::Coarse, BMR_EVENT_LEAVE, kPolygons, kCoarse},
     {CertificateState::Apart, BMR_EVENT_LEAVE, kPolygons, kPolygons},
     {CertificateState::Apart, BMR_EVENT_LEAVE, kPolygons, kPolygons}},
};

} // namespace

void SolidContact::TakeResult(ProofResult result) {
    const Transition &transition =
        kTransitions[static_cast<int>(state.certificate)][static_cast<int>(result)];
    state.certificate = transition.next;
    if (transition.event != BMR_EVENT_KIND_COUNT)
        ReportEvent(m_fixtureA->GetBody(), m_fixtureB->GetBody(),
                    {transition.event, transition.levelBefore, transition.levelAfter, nullptr, nullptr, 0.0});
}

void SolidContact::LeaveByLine() {
    if (state.certificate == CertificateState::Contact)
        TakeResult(ProofResult::Another);
}

void SolidContact::TakeSensorResult(bmr_vec2 before) {
    if (IsTouching()) {
        TakeResult(ProofResult::Nothing);
        return;
    }
    // If Box2D found the two apart, the direction is from another update, or there is none.
    const bmr_vec2 now = GuessDirection();
    if (SeparatesAlong(*m_fixtureA, *m_fixtureB, now))
        TakeResult(now.x == before.x && now.y == before.y ? ProofResult::Remembered : ProofResult::Another);
}

} // namespace bmr
