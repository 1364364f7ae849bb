// SPDX-License-Identifier: MIT
// b2World::SolveTOI: one impact, its island, and what it leaves to be asked again.
#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>

#include "base/private_members.h"
#include "glue/contact_update.h"
#include "glue/impacts.h"
#include "glue/sweeps.h"
#include "solver/island_solver.h"
#include "start/box2d_asserts.h"
#include "start/current_step.h"

namespace bmr {

namespace {

b2TimeStep RestOf(const b2TimeStep &step, float time) {
    b2TimeStep rest = step;
    rest.dt = (1.0f - time) * step.dt;
    rest.inv_dt = 1.0f / rest.dt;
    rest.dtRatio = 1.0f;
    rest.positionIterations = 20;
    rest.warmStarting = false;
    return rest;
}

bool IsSolidAndTouches(const b2Contact &contact) {
    return contact.IsEnabled() && contact.IsTouching();
}

} // namespace

/// Code of the game is to be called in this impact. What it may change is compared with what it was ahead of
/// the pass's first call.
void ImpactPass::BeforeGame() {
    m_wasGameCalled = true;
    m_stoppers.BeforeGame();
    if (m_ledger != nullptr && !m_flagsAreRead)
        m_ledger->GetMovers().LookAtAllSweeps(m_ledger->CurrentLook());
    m_flagsAreRead = true;
    bmr::BeforeGame(m_manager);
}

void ImpactPass::PutBack(b2Body *body, const b2Sweep &sweep) {
    SweepOf(body) = sweep;
    SynchronizeTransform(body);
}

/// Lets the two bodies of the contact meet. False where they do not touch then, or are not to: they go on as
/// they were.
bool ImpactPass::Meet(b2Contact *contact, float time) {
    m_wasGameCalled = false;
    if (m_ledger != nullptr)
        DoubtBudgets();
    m_marks.LookAgain();
    if (Ledger *const ledger = FindLedger(m_manager))
        ledger->GetBodies().NoteDisplaced();
    b2Body *const a = contact->GetFixtureA()->GetBody(), *const b = contact->GetFixtureB()->GetBody();
    const b2Sweep sweepA = SweepOf(*a), sweepB = SweepOf(*b);
    Advance(a, time);
    Advance(b, time);
    Update(contact);
    m_marks.ForgetTime(contact);
    m_marks.CountImpact(contact);
    if (!IsSolidAndTouches(*contact)) {
        contact->SetEnabled(false);
        if (m_ledger != nullptr)
            m_ledger->Flag(contact, 0);
        PutBack(a, sweepA);
        PutBack(b, sweepB);
        AfterGame();
        return false;
    }
    Wake(a);
    Wake(b);
    const b2TimeStep rest = RestOf(m_step, time);
    m_solver->Begin(rest, m_listener, false);
    Island island;
    Add(a, &island);
    Add(b, &island);
    Add(contact, &island);
    Spread(a, time, &island);
    Spread(b, time, &island);
    if (IsOfGame(m_listener))
        BeforeGame();
    m_solver->SolveToi();
    m_solver->Finish(nullptr);
    EndIsland(island);
    AfterGame();
    FindNewContacts();
    return true;
}

/// The world may have left its table: its list is searched from here on.
void ImpactPass::CheckTable() {
    if (m_ledger != nullptr && (m_ledger->WasLeft() || !m_ledger->IsWhole()))
        m_ledger = nullptr;
}

/// Ahead of the search for new contacts.
void ImpactPass::AfterGame() {
    CheckTable();
    if (m_wasGameCalled)
        m_stoppers.AfterGame();
}

void ImpactPass::Add(b2Body *body, Island *island) {
    BodyInIsland::Set(body);
    island->bodies[island->bodyCount++] = body;
    m_solver->Add(body);
}

void ImpactPass::Add(b2Contact *contact, Island *island) {
    m_marks.PutInIsland(contact);
    ++island->contactCount;
    m_solver->Add(contact);
}

/// The contacts of one of the two that touch by now, and their bodies. The island goes no farther.
void ImpactPass::Spread(b2Body *body, float time, Island *island) {
    if (body->GetType() != b2_dynamicBody)
        return;
    for (b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
        if (island->bodyCount == 2 * b2_maxTOIContacts || island->contactCount == b2_maxTOIContacts)
            break;
        b2Contact *const contact = edge->contact;
        b2Body *const other = edge->other;
        if (m_marks.IsInIsland(contact) ||
            (other->GetType() == b2_dynamicBody && !body->IsBullet() && !other->IsBullet()) ||
            contact->GetFixtureA()->IsSensor() || contact->GetFixtureB()->IsSensor())
            continue;
        const b2Sweep sweep = SweepOf(*other);
        if (!BodyInIsland::Is(other))
            Advance(other, time);
        Update(contact);
        if (!IsSolidAndTouches(*contact)) {
            PutBack(other, sweep);
            continue;
        }
        Add(contact, island);
        if (BodyInIsland::Is(other))
            continue;
        if (other->GetType() != b2_staticBody)
            Wake(other);
        Add(other, island);
    }
}

/// Ends the island. Pairs of the bodies that it displaced forget their times of impact.
void ImpactPass::EndIsland(const Island &island) {
    m_marks.LookAgain(); // PostSolve may have made a step, in which the world got a ledger
    for (int32 i = 0; i < island.bodyCount; ++i) {
        b2Body *const body = island.bodies[i];
        BodyInIsland::Clear(body);
        if (body->GetType() != b2_dynamicBody)
            continue;
        (body->*Named(SynchronizeFixtures()))();
        for (b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
            m_marks.ForgetTime(edge->contact);
            m_marks.TakeOutOfIsland(edge->contact);
        }
    }
}

void ImpactPass::FindNewContacts() {
    if (IsOfGame(m_manager->m_contactFilter)) {
        BeforeGame();
        m_stoppers.Forget();
    }
    m_manager->FindNewContacts();
    m_marks.LookAgain();
    CheckTable();
}

/// b2Contact::Update. Notes what it changes: who is awake, what is enabled.
void ImpactPass::Update(b2Contact *contact) {
    b2Body *const a = contact->GetFixtureA()->GetBody(), *const b = contact->GetFixtureB()->GetBody();
    const bool wasAwakeA = a->IsAwake(), wasAwakeB = b->IsAwake();
    b2ContactListener *const listener = m_manager->m_contactListener;
    const ContactChange change = UpdateContact(contact);
    if (Ledger *const ledger = FindLedger(m_manager))
        ledger->Flag(contact, 0); // it is due in the next step, which reads whether it touches
    TellListener(listener, contact, change, [this] { BeforeGame(); });
    m_marks.LookAgain();
    CheckTable();
    const uint32_t i = m_ledger != nullptr ? m_ledger->NumberOf(contact) : Ledger::kNone;
    if (i == Ledger::kNone)
        return;
    m_ledger->Owed().NoteLookedAt(i);
    if (!m_ledger->GetMarks().known.Has(i))
        m_ledger->GetMarks().asked.Set(i);
    else if (m_ledger->GetMarks().parked.Has(i))
        Queue(i);
    if (!wasAwakeA && a->IsAwake())
        AskPairsOf(a);
    if (!wasAwakeB && b->IsAwake())
        AskPairsOf(b);
}

void ImpactPass::Wake(b2Body *body) {
    const bool wasAwake = body->IsAwake();
    body->SetAwake(true);
    if (!wasAwake && body->IsAwake())
        AskPairsOf(body);
}

void ImpactPass::AskPairsOf(const b2Body *body) {
    if (m_ledger == nullptr)
        return;
    Marks &marks = m_ledger->GetMarks();
    for (const b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
        const uint32_t i = m_ledger->NumberOf(edge->contact);
        if (i != Ledger::kNone && !marks.known.Has(i))
            marks.asked.Set(i);
    }
}

/// If the game was called while two bodies met, this reads what Box2D would read in its next search: which
/// bodies are awake or bullets, which fixtures are sensors, which contacts are enabled; and all of it after a
/// step inside this one. Bodies are read one by one, for a listener changes them by inline functions. Where
/// it was not called, Update, Wake and EndIsland have noted all that the impact changed.
void ImpactPass::ReadWhatGameDid() {
    if (!m_wasGameCalled)
        return;
    CheckTable();
    if (m_ledger == nullptr)
        return;
    Marks &marks = m_ledger->GetMarks();
    Movers &movers = m_ledger->GetMovers();
    for (uint32_t row = movers.NextNewSweep(0); row != Movers::kNone; row = movers.NextNewSweep(row + 1))
        AskPairsOf(movers[row].body);
    for (uint32_t word = 0; word < marks.parked.Words(); ++word)
        for (uint64_t left = marks.parked.Word(word); left != 0; left &= left - 1) {
            const uint32_t i = word * 64 + LowestBit(left);
            if (i >= m_ledger->Count() || m_ledger->Contact(i) == nullptr ||
                !m_ledger->Contact(i)->IsEnabled())
                continue;
            marks.parked.Clear(i);
            if (!marks.known.Has(i))
                marks.asked.Set(i);
            else
                Queue(i);
        }
}

/// From the marks alone: known times are in the heap, all others of who is awake are asked.
void ImpactPass::Rebuild() {
    m_ledger->TakeMarks();
    Marks &marks = m_ledger->GetMarks();
    m_budgetsDoubted = true; // what is known by now stays so
    marks.heapCount = 0;
    marks.parked.ClearAll();
    marks.asked.ClearAll();
    if (m_gameRan)
        m_ledger->GetMovers().LookAtAllSweeps(m_ledger->CurrentLook());
    for (uint32_t i = 0; m_ledger != nullptr && i < m_ledger->Count(); ++i) {
        if (m_ledger->Contact(i) == nullptr)
            continue;
        if (m_gameRan ? m_ledger->WatchIfAwake(i) : m_ledger->IsWatched(i))
            marks.asked.Set(i);
        EnableIfOwed(i); // the game may have disabled it meanwhile
        if (marks.known.Has(i))
            Queue(i);
    }
}

} // namespace bmr
