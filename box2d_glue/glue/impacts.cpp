// SPDX-License-Identifier: MIT
#include "glue/impacts.h"

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_time_of_impact.h>
#include <box2d/b2_world.h>

#include "base/rounding_mode.h"
#include "glue/contact_update.h"
#include "glue/contacts/solid_contact.h"
#include "glue/proofs/convex_distance.h"
#include "glue/proofs/sweep_apart.h"
#include "glue/sweeps.h"
#include "shapes/convex_geometry.h"
#include "solver/island_solver.h"
#include "start/box2d_asserts.h"
#include "start/current_step.h"
#include "start/settings.h"

namespace bmr {

namespace {

b2Body *BodyA(b2Contact *contact) {
    return contact->GetFixtureA()->GetBody();
}

b2Body *BodyB(b2Contact *contact) {
    return contact->GetFixtureB()->GetBody();
}

/// May Box2D ask for the time of its impact, if one of the two is awake? Only code of the game changes that.
inline bool MayStop(b2Contact *contact) {
    return !contact->GetFixtureA()->IsSensor() && !contact->GetFixtureB()->IsSensor() &&
           (Stops(BodyA(contact)) || Stops(BodyB(contact)));
}

/// Does it?
inline bool MayImpact(b2Contact *contact) {
    return MayStop(contact) && (IsActive(BodyA(contact)) || IsActive(BodyB(contact)));
}

} // namespace

// The contacts that may have an impact.

bool Stops(const b2Body *body) {
    return body->IsBullet() || body->GetType() != b2_dynamicBody;
}

/// (New contacts come at the head of the list.)
bool Stoppers::AreKnown() const {
    return m_known && m_world->GetContactManager().m_contactList == m_newest;
}

void Stoppers::Begin() {
    const b2ContactManager &manager = m_world->GetContactManager();
    m_known = true;
    m_room->Reserve(static_cast<uint32_t>(manager.m_contactCount));
    m_hasDigest = false;
    m_count = 0;
    m_contactCount = manager.m_contactCount;
    m_newest = manager.m_contactList;
    m_step = LatestStep();
}

void Stoppers::BeforeGame() {
    if (m_known && !m_hasDigest)
        m_digest = Digest();
    m_hasDigest = true;
}

void Stoppers::AfterGame() {
    const b2ContactManager &manager = m_world->GetContactManager();
    m_known = m_known && m_world->IsLocked() && LatestStep() == m_step &&
              manager.m_contactCount == m_contactCount && Digest() == m_digest;
}

/// Who is a bullet, and which fixtures are sensors. Two different answers have the same digest with a
/// probability of 2^-64.
uint64_t Stoppers::Digest() const {
    uint64_t digest = 1;
    const auto add = [&digest](bool is) {
        digest = (digest ^ (is ? 1 : 2)) * 0x9e3779b97f4a7c15u;
        digest ^= digest >> 32;
    };
    for (const b2Body *body = m_world->GetBodyList(); body != nullptr; body = body->GetNext()) {
        add(body->IsBullet());
        for (const b2Fixture *fixture = body->GetFixtureList(); fixture != nullptr;
             fixture = fixture->GetNext())
            add(fixture->IsSensor());
    }
    return digest;
}

// The pass.

ImpactPass::ImpactPass(b2World *world, const b2TimeStep &step, IslandSolver *solver)
    : m_world(world), m_manager(const_cast<b2ContactManager *>(&world->GetContactManager())), m_step(step),
      m_solver(solver), m_listener(m_manager->m_contactListener), m_ledger(FindLedger(m_manager)),
      m_marks(m_manager), m_stoppers(world, &solver->Room().stoppers), m_gameRan(GameRan()),
      m_flagsAreRead(m_gameRan) {
    if (m_listener != nullptr && !HasOwnPostSolve(*m_listener))
        m_listener = nullptr;
}

/// Does the ledger know all pairs, and what this step did to them?
bool ImpactPass::MayUseHeap() const {
    return m_ledger != nullptr && m_ledger->IsLookedAtIn(CurrentStep()) && m_ledger->IsWhole();
}

void ImpactPass::Run() {
    bool &stepComplete = m_world->*Named(StepComplete());
    if (MayUseHeap())
        m_pass.emplace(m_ledger);
    else
        m_ledger = nullptr;
    if (stepComplete)
        BeginStep();
    else if (m_ledger != nullptr)
        Rebuild();
    for (;;) {
        float time = 1.0f;
        b2Contact *const contact = m_ledger != nullptr ? Earliest(&time) : EarliestInList(&time);
        m_scan = nullptr;
        if (contact == nullptr || 1.0f - 10.0f * b2_epsilon < time) {
            stepComplete = true;
            break;
        }
        if (Ledger *const ledger = FindLedger(m_manager))
            ledger->NoteSearch();
        const bool met = Meet(contact, time);
        if (m_ledger != nullptr)
            ReadWhatGameDid();
        if (met && m_world->GetSubStepping()) {
            stepComplete = false;
            break;
        }
    }
    if (m_pass.has_value())
        m_pass->Complete();
}

// The beginning of a step.

void ImpactPass::BeginStep() {
    BeginBodies();
    m_scan = RoundsToNearest() ? ImpactScan::Begin() : nullptr;
    if (m_ledger == nullptr) {
        for (b2Contact *contact = m_manager->m_contactList; contact != nullptr; contact = contact->GetNext())
            m_marks.ForgetImpact(contact);
        return;
    }
    Marks &marks = m_ledger->GetMarks();
    const bool islandsAreOurs = marks.areHere;
    marks.areHere = true; // all of them are forgotten
    marks.ForgetImpacts();
    SearchByLedger(m_gameRan || !islandsAreOurs);
}

/// All bodies are at the beginning of their sweeps, and in no island.
void ImpactPass::BeginBodies() {
    Bodies *const bodies = m_ledger != nullptr ? &m_ledger->GetBodies() : nullptr;
    const auto begin = [](b2Body *body) {
        BodyInIsland::Clear(body);
        SweepOf(body).alpha0 = 0.0f;
    };
    if (bodies != nullptr && bodies->AreAlone(CurrentStep()) && !bodies->MayBeDisplaced()) {
        for (uint32_t i = 0; i < bodies->AwakeCount(); ++i)
            begin(bodies->Awake(i));
        return;
    }
    for (b2Body *body = m_world->GetBodyList(); body != nullptr; body = body->GetNext())
        begin(body);
    if (bodies != nullptr)
        bodies->NotePutBack();
}

// The first search of a step, by the ledger.

/// Looks at `all` pairs, or at those that are watched. (IslandPass watches every pair of a body that it
/// wakes. Code of the game and Box2D's b2World::Solve wake bodies otherwise.)
void ImpactPass::SearchByLedger(bool all) {
    m_ledger->BeginSearch(m_gameRan);
    for (uint32_t word = m_ledger->Count() / 64 + 1; word-- > 0;) {
        uint64_t left = m_ledger->ToSearch(word, all);
        while (left != 0) {
            const uint32_t bit = HighestBit(left), i = word * 64 + bit;
            left &= ~(uint64_t{1} << bit);
            if (i >= m_ledger->Count() || m_ledger->Contact(i) == nullptr)
                continue;
            if (!m_ledger->LookForImpact(i))
                continue;
            SearchPair(i);
        }
    }
}

void ImpactPass::SearchPair(uint32_t i) {
    Marks &marks = m_ledger->GetMarks();
    b2Contact *const contact = m_ledger->Contact(i);
    if (m_ledger->OutlastsSweeps(i)) {
        marks.known.Set(i); // and its time is 1
        return;
    }
    EnableIfOwed(i);
    if (!contact->IsEnabled()) {
        marks.known.Clear(i);
        marks.parked.Set(i);
    } else if (MayImpact(contact)) {
        FindTime(contact);
        Queue(i);
    }
}

/// Ahead of the first impact, where the game may have disabled contacts: a budget knows nothing of that.
void ImpactPass::DoubtBudgets() {
    if (m_budgetsDoubted || !m_gameRan)
        return;
    m_budgetsDoubted = true;
    Marks &marks = m_ledger->GetMarks();
    for (uint32_t i = 0; i < m_ledger->Count(); ++i)
        if (m_ledger->Contact(i) != nullptr && marks.known.Has(i) && !marks.met.Has(i) &&
            !m_ledger->Contact(i)->IsEnabled()) {
            marks.known.Clear(i);
            marks.parked.Set(i);
        }
}

// Later searches, by the ledger.

/// Box2D enabled it, if it was active, before the first search.
void ImpactPass::EnableIfOwed(uint32_t i) {
    m_ledger->Owed().EnableIfOwed(i);
    m_ledger->Owed().NoteLookedAt(i);
}

void ImpactPass::AskAgain() {
    Marks &marks = m_ledger->GetMarks();
    for (uint32_t word = m_ledger->Count() / 64 + 1; word-- > 0;)
        while (word < marks.asked.Words() && marks.asked.Word(word) != 0) {
            const uint32_t i = word * 64 + HighestBit(marks.asked.Word(word));
            marks.asked.Clear(i);
            if (i < m_ledger->Count() && m_ledger->Contact(i) != nullptr && !marks.known.Has(i))
                Ask(i);
        }
}

void ImpactPass::Ask(uint32_t i) {
    b2Contact *const contact = m_ledger->Contact(i);
    EnableIfOwed(i);
    if (!contact->IsEnabled())
        m_ledger->GetMarks().parked.Set(i);
    else if (m_ledger->GetMarks().CountOf(i) <= b2_maxSubSteps && MayImpact(contact)) {
        FindTime(contact);
        Queue(i);
    }
}

/// A pair whose time is known.
void ImpactPass::Queue(uint32_t i) {
    Marks &marks = m_ledger->GetMarks();
    const float time = marks.Time(i);
    if (time < 1.0f)
        marks.Push(i, time);
}

b2Contact *ImpactPass::Earliest(float *time) {
    AskAgain();
    while (m_ledger->GetMarks().heapCount > 0) {
        Marks &marks = m_ledger->GetMarks();
        const Marks::Impact first = marks.heap[0];
        b2Contact *const contact = m_ledger->Contact(first.number);
        if (contact != nullptr && marks.known.Has(first.number) && marks.Time(first.number) == first.time) {
            if (contact->IsEnabled()) {
                *time = first.time;
                return contact;
            }
            marks.parked.Set(first.number);
        }
        marks.Pop();
    }
    return nullptr;
}

// Searches as Box2D makes them.

b2Contact *ImpactPass::EarliestInList(float *time) {
    b2Contact *earliest = nullptr;
    if (Ledger *const ledger = FindLedger(m_manager)) { // marks and flags are read where the contacts are
        if (ledger->IsLookedAtIn(CurrentStep()))
            ledger->Owed().EnableDownTo(0);
        ledger->GiveMarksBack();
    }
    m_marks.LookAgain();
    if (m_stoppers.AreKnown()) {
        for (uint32_t i = 0; i < m_stoppers.Count(); ++i)
            if (IsEarlier(m_stoppers[i], time))
                earliest = m_stoppers[i];
        return earliest;
    }
    m_stoppers.Begin();
    for (b2Contact *contact = m_manager->m_contactList; contact != nullptr; contact = contact->GetNext()) {
        if ((ContactAccess::Flags(contact) & ContactAccess::kTimeIsKnown) == 0 && !MayStop(contact))
            continue;
        m_stoppers.Add(contact);
        if (IsEarlier(contact, time))
            earliest = contact;
    }
    return earliest;
}

/// Finds the contact's time of impact where Box2D would. Is it ahead of `*time`, which it then becomes?
bool ImpactPass::IsEarlier(b2Contact *contact, float *time) {
    if (!contact->IsEnabled() || ContactAccess::CountOfImpacts(contact) > b2_maxSubSteps)
        return false;
    if ((ContactAccess::Flags(contact) & ContactAccess::kTimeIsKnown) == 0) {
        if (!MayImpact(contact))
            return false;
        FindTime(contact);
    }
    const float its = ContactAccess::TimeOfImpact(contact);
    if (!(its < *time))
        return false;
    *time = its;
    return true;
}

void ImpactPass::FindTime(b2Contact *contact) {
    b2Body *const a = BodyA(contact), *const b = BodyB(contact);
    // Both sweeps go on from the same time.
    b2Sweep &sweepA = SweepOf(a), &sweepB = SweepOf(b);
    const float from = b2Max(sweepA.alpha0, sweepB.alpha0);
    if (sweepA.alpha0 < sweepB.alpha0)
        Advance(&sweepA, from);
    else if (sweepB.alpha0 < sweepA.alpha0)
        Advance(&sweepB, from);
    BMR_BOX2D_ASSERTS(from < 1.0f, "alpha0 < 1.0f");
    m_marks.SetTime(contact, TimeOf(contact, from));
}

float ImpactPass::TimeOf(b2Contact *contact, float from) {
    b2TOIInput input;
    if (RoundsToNearest() && IsProvedApart(*contact, &input))
        return 1.0f;
    FillInput(*contact, &input);
    b2TOIOutput output;
    if (!AnyBigPolygon() || !BigImpact(&output, input))
        b2TimeOfImpact(&output, &input);
    return output.state == b2TOIOutput::e_touching ? b2Min(from + (1.0f - from) * output.t, 1.0f) : 1.0f;
}

void ImpactPass::FillInput(const b2Contact &contact, b2TOIInput *input) {
    const b2Fixture *a = contact.GetFixtureA(), *b = contact.GetFixtureB();
    SetProxy(&input->proxyA, *a->GetShape(), contact.GetChildIndexA());
    SetProxy(&input->proxyB, *b->GetShape(), contact.GetChildIndexB());
    input->sweepA = SweepOf(*a->GetBody());
    input->sweepB = SweepOf(*b->GetBody());
    input->tMax = 1.0f;
}

/// Over all that is left of the step.
bool ImpactPass::IsProvedApart(const b2Contact &contact, b2TOIInput *input) {
    bool apart;
    if (m_scan != nullptr) {
        const b2Body *a = contact.GetFixtureA()->GetBody(), *b = contact.GetFixtureB()->GetBody();
        apart = m_scan->NeverTouch(
            {contact.GetFixtureA(), contact.GetChildIndexA(), SweepOf(*a), a->GetTransform().q},
            {contact.GetFixtureB(), contact.GetChildIndexB(), SweepOf(*b), b->GetTransform().q},
            GuessDirection(contact), contact.GetManifold()->pointCount > 0);
    } else if (!AnyBigPolygon()) {
        FillInput(contact, input);
        apart = NeverTouch(*input);
    } else {
        apart = false;
    }
    if (apart)
        Count(&Counts::toiAnswered);
    return apart;
}

} // namespace bmr
