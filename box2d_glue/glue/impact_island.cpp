// SPDX-License-Identifier: MIT
// b2World::SolveTOI: one impact, its island, and what it leaves to be asked again.
#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>

#include "base/private_members.h"
#include "glue/contacts/game_calls.h"
#include "glue/impacts.h"
#include "glue/pairs/pair_tables.h"
#include "glue/passes.h"
#include "solver/island_solver.h"
#include "tree/edit.h"

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
    m_candidates.Forget();
    if (m_table == nullptr)
        return;
    if (!m_table->deferred.GameRan()) // else BeginSearch has, or this
        m_table->motions.UpdateAllSweeps(m_table->Stamp());
    m_table->deferred.BeforeGame();
}

void ImpactPass::PutBack(b2Body *body, const b2Sweep &sweep) {
    SweepOf(body) = sweep;
    (body->*Named(SynchronizeTransform()))();
}

/// Lets the two bodies of the contact meet. False where they do not touch then, or are not to: they go on as
/// they were.
bool ImpactPass::Meet(b2Contact *contact, float time) {
    m_wasGameCalled = false;
    if (m_table != nullptr)
        m_table->bodies.NoteDisplaced();
    b2Body *const a = contact->GetFixtureA()->GetBody(), *const b = contact->GetFixtureB()->GetBody();
    const b2Sweep sweepA = SweepOf(*a), sweepB = SweepOf(*b);
    (a->*Named(AdvanceBody()))(time);
    (b->*Named(AdvanceBody()))(time);
    Update(contact);
    ForgetTime(contact);
    ++ContactAccess::CountOfImpacts(contact);
    if (!IsSolidAndTouches(*contact)) {
        contact->SetEnabled(false);
        PutBack(a, sweepA);
        PutBack(b, sweepB);
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
    FindNewContacts();
    return true;
}

/// The world may have left its table: its list is searched from here on.
void ImpactPass::CheckTable() {
    if (m_table != nullptr && LeaveIfNotWhole(m_table))
        m_table = nullptr;
}

void ImpactPass::ForgetTime(b2Contact *contact) {
    const uint32_t i = m_table != nullptr ? m_table->NumberOf(contact) : PairTable::kNone;
    if (i != PairTable::kNone)
        m_table->impacts.Forget(i, contact);
    else
        ContactAccess::Flags(contact) &= ~ContactAccess::kTimeIsKnown;
}

void ImpactPass::Add(b2Body *body, Island *island) {
    BodyInIsland::Set(body);
    island->bodies[island->bodyCount++] = body;
    m_solver->Add(body);
}

void ImpactPass::Add(b2Contact *contact, Island *island) {
    ContactAccess::Flags(contact) |= ContactAccess::kInIsland;
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
        if ((ContactAccess::Flags(contact) & ContactAccess::kInIsland) != 0 ||
            (other->GetType() == b2_dynamicBody && !body->IsBullet() && !other->IsBullet()) ||
            contact->GetFixtureA()->IsSensor() || contact->GetFixtureB()->IsSensor())
            continue;
        const b2Sweep sweep = SweepOf(*other);
        if (!BodyInIsland::Is(other))
            (other->*Named(AdvanceBody()))(time);
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
    CheckTable();
    for (int32 i = 0; i < island.bodyCount; ++i) {
        b2Body *const body = island.bodies[i];
        BodyInIsland::Clear(body);
        if (body->GetType() != b2_dynamicBody)
            continue;
        tree::SynchronizeBoxes(body);
        for (b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
            ForgetTime(edge->contact);
            ContactAccess::Flags(edge->contact) &= ~ContactAccess::kInIsland;
        }
    }
}

void ImpactPass::FindNewContacts() {
    if (IsOfGame(m_manager->m_contactFilter))
        BeforeGame();
    bmr::FindNewContacts(m_manager);
    CheckTable();
}

/// b2Contact::Update. Notes who is awake by now. (Meet or EndIsland forgets the contact's time of impact.)
void ImpactPass::Update(b2Contact *contact) {
    b2Body *const a = contact->GetFixtureA()->GetBody(), *const b = contact->GetFixtureB()->GetBody();
    const bool wasAwakeA = a->IsAwake(), wasAwakeB = b->IsAwake();
    b2ContactListener *const listener = m_manager->m_contactListener;
    const ContactChange change = UpdateContact(contact);
    if (m_table != nullptr)
        m_table->Flag(contact); // it is due in the next step, which reads whether it touches
    CallListener(listener, contact, change, [this] { BeforeGame(); });
    CheckTable();
    if (m_table == nullptr)
        return;
    if (!wasAwakeA && a->IsAwake())
        MarkPending(a);
    if (!wasAwakeB && b->IsAwake())
        MarkPending(b);
}

void ImpactPass::Wake(b2Body *body) {
    const bool wasAwake = body->IsAwake();
    body->SetAwake(true);
    if (!wasAwake && body->IsAwake())
        MarkPending(body);
}

void ImpactPass::MarkPending(const b2Body *body) {
    if (m_table == nullptr)
        return;
    for (const b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
        const uint32_t i = m_table->NumberOf(edge->contact);
        if (i != PairTable::kNone && !m_table->impacts.IsKnown(i, edge->contact))
            m_table->impacts.pending.Set(i);
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
    if (m_table == nullptr)
        return;
    ImpactTimes &impacts = m_table->impacts;
    FixtureMotions &motions = m_table->motions;
    for (uint32_t row = motions.NextChangedSweep(0); row != FixtureMotions::kNone;
         row = motions.NextChangedSweep(row + 1))
        MarkPending(motions[row].body);
    for (uint32_t word = 0; word < impacts.disabled.Words(); ++word)
        for (uint64_t left = impacts.disabled.Word(word); left != 0; left &= left - 1) {
            const uint32_t i = word * 64 + LowestBit(left);
            b2Contact *const contact = i < m_table->Count() ? m_table->Contact(i) : nullptr;
            if (contact == nullptr || !contact->IsEnabled())
                continue;
            impacts.disabled.Clear(i);
            if (!impacts.IsKnown(i, contact))
                impacts.pending.Set(i);
            else
                Queue(i, ContactAccess::TimeOfImpact(contact));
        }
}

} // namespace bmr
