// SPDX-License-Identifier: MIT
#include "glue/contacts/contact_life.h"

#include "debug/event.h"
#include "glue/contacts/solid_contact.h"
#include "glue/proofs/apart_line.h"

namespace bmr {

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
