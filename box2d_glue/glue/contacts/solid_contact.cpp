// SPDX-License-Identifier: MIT
#include "glue/contacts/solid_contact.h"

#include <box2d/b2_world.h>

#include "debug/statistics.h"
#include "glue/pairs/pair_table.h"
#include "glue/pairs/pair_tables.h"
#include "glue/proofs/apart_line.h"
#include "start/current_step.h"
#include "start/settings.h"

namespace bmr {

std::atomic<const void *> SolidContact::polygonVtable{nullptr}, SolidContact::convexVtable{nullptr};

namespace {

Ledger *LedgerOf(const b2Contact &contact) {
    return FindLedger(&contact.GetFixtureA()->GetBody()->GetWorld()->GetContactManager());
}

} // namespace

bool SolidContact::HullsSayApart(const b2Transform &xfA, const b2Transform &xfB) const {
    Ledger *const ledger = LedgerOf(*this);
    const uint32_t number = ledger != nullptr ? ledger->NumberOf(this) : Ledger::kNone;
    return number != Ledger::kNone && ledger->GetHullPairs().SayApart(number, *this, xfA, xfB);
}

bmr_vec2 SolidContact::GuessDirection() const {
    Ledger *const ledger = PairsAreHulls() ? LedgerOf(*this) : nullptr;
    const HullPair *const pair =
        ledger != nullptr ? ledger->GetHullPairs().Find(ledger->NumberOf(this)) : nullptr;
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

void SolidContact::IsLookedAtByOthers() const {
    GameRan() = true; // it may be the game that asks, in the midst of a call
    if (Ledger *ledger = LedgerOf(*this))
        ledger->Flag(this, 0);
}

namespace {

constexpr int8_t kCoarse = BMR_LEVEL_DISKS, kPolygons = 0;

/// The life after a look, and the event; BMR_EVENT_KIND_COUNT if there is none.
struct Turn {
    Life next;
    bmr_event_kind event;
    int8_t levelBefore, levelAfter;
};

constexpr Turn Quiet(Life life) {
    return {life, BMR_EVENT_KIND_COUNT, 0, 0};
}

/// A row for each life, a column for each finding: Nothing, ByDisks, Remembered, Another.
constexpr Turn kTurns[4][4] = {
    {{Life::Contact, BMR_EVENT_CONTACT, kCoarse, kPolygons},
     {Life::Coarse, BMR_EVENT_START, kCoarse, kCoarse},
     {Life::Apart, BMR_EVENT_START, kCoarse, kPolygons},
     {Life::Apart, BMR_EVENT_START, kCoarse, kPolygons}},
    {{Life::Contact, BMR_EVENT_CONTACT, kCoarse, kPolygons},
     Quiet(Life::Coarse),
     {Life::Apart, BMR_EVENT_STAB, kCoarse, kPolygons},
     {Life::Apart, BMR_EVENT_STAB, kCoarse, kPolygons}},
    {{Life::Contact, BMR_EVENT_CONTACT, kPolygons, kPolygons},
     {Life::Coarse, BMR_EVENT_COARSEN, kPolygons, kCoarse},
     Quiet(Life::Apart),
     {Life::Apart, BMR_EVENT_PUSH, kPolygons, kPolygons}},
    {Quiet(Life::Contact),
     {Life::Coarse, BMR_EVENT_LEAVE, kPolygons, kCoarse},
     {Life::Apart, BMR_EVENT_LEAVE, kPolygons, kPolygons},
     {Life::Apart, BMR_EVENT_LEAVE, kPolygons, kPolygons}},
};

} // namespace

void SolidContact::Live(Held held) {
    const Turn &turn = kTurns[static_cast<int>(state.life)][static_cast<int>(held)];
    state.life = turn.next;
    if (turn.event != BMR_EVENT_KIND_COUNT)
        TellOfEvent(m_fixtureA->GetBody(), m_fixtureB->GetBody(),
                    {turn.event, turn.levelBefore, turn.levelAfter, nullptr, nullptr, 0.0});
}

void SolidContact::LeaveByLine() {
    if (state.life == Life::Contact)
        Live(Held::Another);
}

void SolidContact::LiveAsSensor(bmr_vec2 before) {
    if (IsTouching()) {
        Live(Held::Nothing);
        return;
    }
    // If Box2D found the two apart, the direction is from another look, or there is none.
    const bmr_vec2 now = GuessDirection();
    if (SeparatesAlong(*m_fixtureA, *m_fixtureB, now))
        Live(now.x == before.x && now.y == before.y ? Held::Remembered : Held::Another);
}

} // namespace bmr
