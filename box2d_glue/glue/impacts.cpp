// SPDX-License-Identifier: MIT
#include "glue/impacts.h"

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_time_of_impact.h>
#include <box2d/b2_world.h>

#include "base/rounding_mode.h"
#include "glue/contacts/game_calls.h"
#include "glue/pairs/pair_tables.h"
#include "glue/proofs/convex_distance.h"
#include "glue/proofs/sweep_apart.h"
#include "shapes/big_polygons.h"
#include "solver/island_solver.h"
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
inline bool IsToiCandidate(b2Contact *contact) {
    return !contact->GetFixtureA()->IsSensor() && !contact->GetFixtureB()->IsSensor() &&
           (IsBulletOrStatic(BodyA(contact)) || IsBulletOrStatic(BodyB(contact)));
}

/// Does Box2D ask for it?
inline bool IsAskedForToi(b2Contact *contact) {
    return IsToiCandidate(contact) && (IsActive(BodyA(contact)) || IsActive(BodyB(contact)));
}

/// A guess of a direction along which the two are apart: the normal that they touch along, or what is
/// remembered of two polygons. Of unit length, or zero.
bmr_vec32 GuessAxis(const b2Contact &contact) {
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

} // namespace

// The pass.

ImpactPass::ImpactPass(b2World *world, const b2TimeStep &step, IslandSolver *solver, PairTable *table)
    : m_world(world), m_manager(const_cast<b2ContactManager *>(&world->GetContactManager())), m_step(step),
      m_solver(solver), m_listener(PostSolveListener(m_manager->m_contactListener)),
      m_table(table != nullptr && !LeaveIfNotWhole(table) ? table : nullptr),
      m_candidates(world, &solver->Scratch().toiCandidates) {}

void ImpactPass::Run() {
    bool &stepComplete = m_world->*Named(StepComplete());
    BeginScan();
    if (stepComplete)
        BeginStep();
    for (bool isFirst = true;; isFirst = false) {
        float time = 1.0f;
        b2Contact *const contact = m_table != nullptr ? Earliest(&time) : EarliestInList(&time);
        if (contact == nullptr || 1.0f - 10.0f * b2_epsilon < time) {
            stepComplete = true;
            break;
        }
        if (PairTable *const table = FindPairTable(m_manager))
            table->cost.NoteSearch();
        if (isFirst && m_table != nullptr && m_table->deferred.GameRan())
            FindDisabled();
        const bool met = Meet(contact, time);
        if (m_table != nullptr)
            ReadWhatGameDid();
        BeginScan(); // bodies have moved
        if (met && m_world->GetSubStepping()) {
            stepComplete = false; // the next steps go on with this one's impacts, by Box2D's list
            if (m_table != nullptr)
                m_table->GiveMarksBack();
            break;
        }
    }
}

void ImpactPass::BeginScan() {
    m_scan = RoundsToNearest() ? ImpactScan::Begin() : nullptr;
}

// The beginning of a step.

void ImpactPass::BeginStep() {
    BeginBodies();
    if (m_table != nullptr) {
        SearchByTable();
        return;
    }
    for (b2Contact *contact = m_manager->m_contactList; contact != nullptr; contact = contact->GetNext())
        ClearImpactMarks(contact);
}

/// All bodies are at the beginning of their sweeps, and in no island.
void ImpactPass::BeginBodies() {
    Bodies *const bodies = m_table != nullptr ? &m_table->bodies : nullptr;
    const auto begin = [](b2Body *body) {
        BodyInIsland::Clear(body);
        SweepOf(body).alpha0 = 0.0f;
    };
    if (bodies != nullptr && bodies->OnlyAwakeInIslands() && !bodies->MayBeDisplaced()) {
        for (uint32_t i = 0; i < bodies->AwakeCount(); ++i)
            begin(bodies->Awake(i));
        return;
    }
    for (b2Body *body = m_world->GetBodyList(); body != nullptr; body = body->GetNext())
        begin(body);
    if (bodies != nullptr)
        bodies->NotePutBack();
}

// The first search of a step, by the table.

/// (IslandPass awakens every pair of a body that it wakes.)
void ImpactPass::SearchByTable() {
    ImpactTimes &impacts = m_table->impacts;
    if (impacts.areKnown)
        for (uint32_t word = 0; word < impacts.marked.Words(); ++word)
            for (uint64_t left = impacts.marked.Word(word); left != 0; left &= left - 1) {
                const uint32_t i = word * 64 + LowestBit(left);
                if (i < m_table->Count() && m_table->Contact(i) != nullptr)
                    ClearImpactMarks(m_table->Contact(i));
            }
    else
        for (b2Contact *contact = m_manager->m_contactList; contact != nullptr; contact = contact->GetNext())
            ClearImpactMarks(contact);
    impacts.ForgetAll();
    m_table->BeginSearch();
    for (uint32_t word = m_table->Count() / 64 + 1; word-- > 0;)
        for (uint64_t left = m_table->ToSearch(word); left != 0;) {
            const uint32_t bit = HighestBit(left), i = word * 64 + bit;
            left &= ~(uint64_t{1} << bit);
            if (i >= m_table->Count() || m_table->Contact(i) == nullptr || !m_table->MayImpact(i))
                continue;
            if (m_table->OutlastsSweeps(i))
                impacts.noImpact.Set(i);
            else
                FindTimeOfPair(i);
        }
}

/// Ahead of the first impact, where the game may have disabled contacts: a deadline knows nothing of that.
void ImpactPass::FindDisabled() {
    ImpactTimes &impacts = m_table->impacts;
    for (uint32_t i = 0; i < m_table->Count(); ++i)
        if (m_table->Contact(i) != nullptr && impacts.noImpact.Has(i) && !m_table->Contact(i)->IsEnabled()) {
            impacts.noImpact.Clear(i);
            impacts.disabled.Set(i);
        }
}

// Later searches, by the table.

void ImpactPass::SearchPending() {
    ImpactTimes &impacts = m_table->impacts;
    for (uint32_t word = m_table->Count() / 64 + 1; word-- > 0;)
        while (word < impacts.pending.Words() && impacts.pending.Word(word) != 0) {
            const uint32_t i = word * 64 + HighestBit(impacts.pending.Word(word));
            impacts.pending.Clear(i);
            b2Contact *const contact = i < m_table->Count() ? m_table->Contact(i) : nullptr;
            if (contact != nullptr && !impacts.IsKnown(i, contact))
                FindTimeOfPair(i);
        }
}

void ImpactPass::FindTimeOfPair(uint32_t i) {
    b2Contact *const contact = m_table->Contact(i);
    m_table->deferred.Settle(i);
    if (!contact->IsEnabled())
        m_table->impacts.disabled.Set(i);
    else if (ContactAccess::CountOfImpacts(contact) <= b2_maxSubSteps && IsAskedForToi(contact))
        Queue(i, FindTime(contact));
}

/// A pair whose time was found, and stands in the contact.
void ImpactPass::Queue(uint32_t i, float time) {
    m_table->impacts.marked.Set(i);
    if (time < 1.0f)
        m_table->impacts.Push(i, time);
}

b2Contact *ImpactPass::Earliest(float *time) {
    SearchPending();
    ImpactTimes &impacts = m_table->impacts;
    while (impacts.heapCount > 0) {
        const ImpactTimes::Impact first = impacts.heap[0];
        b2Contact *const contact = m_table->Contact(first.number);
        if (contact != nullptr && (ContactAccess::Flags(contact) & ContactAccess::kTimeIsKnown) != 0 &&
            ContactAccess::TimeOfImpact(contact) == first.time) {
            if (contact->IsEnabled()) {
                *time = first.time;
                return contact;
            }
            impacts.disabled.Set(first.number);
        }
        impacts.Pop();
    }
    return nullptr;
}

// Searches as Box2D makes them.

b2Contact *ImpactPass::EarliestInList(float *time) {
    b2Contact *earliest = nullptr;
    if (m_candidates.AreKnown()) {
        for (uint32_t i = 0; i < m_candidates.Count(); ++i)
            if (IsEarlier(m_candidates[i], time))
                earliest = m_candidates[i];
        return earliest;
    }
    m_candidates.Begin();
    for (b2Contact *contact = m_manager->m_contactList; contact != nullptr; contact = contact->GetNext()) {
        if ((ContactAccess::Flags(contact) & ContactAccess::kTimeIsKnown) == 0 && !IsToiCandidate(contact))
            continue;
        m_candidates.Add(contact);
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
        if (!IsAskedForToi(contact))
            return false;
        FindTime(contact);
    }
    const float its = ContactAccess::TimeOfImpact(contact);
    if (!(its < *time))
        return false;
    *time = its;
    return true;
}

float ImpactPass::FindTime(b2Contact *contact) {
    b2Body *const a = BodyA(contact), *const b = BodyB(contact);
    // Both sweeps go on from the same time.
    b2Sweep &sweepA = SweepOf(a), &sweepB = SweepOf(b);
    const float from = b2Max(sweepA.alpha0, sweepB.alpha0);
    if (sweepA.alpha0 < sweepB.alpha0)
        sweepA.Advance(from);
    else if (sweepB.alpha0 < sweepA.alpha0)
        sweepB.Advance(from);
    const float time = TimeOf(contact, from);
    ContactAccess::TimeOfImpact(contact) = time;
    ContactAccess::Flags(contact) |= ContactAccess::kTimeIsKnown;
    return time;
}

float ImpactPass::TimeOf(b2Contact *contact, float from) {
    if (m_scan != nullptr && IsProvedApart(*contact))
        return 1.0f;
    const b2Fixture *a = contact->GetFixtureA(), *b = contact->GetFixtureB();
    b2TOIInput input;
    SetProxy(&input.proxyA, *a->GetShape(), contact->GetChildIndexA());
    SetProxy(&input.proxyB, *b->GetShape(), contact->GetChildIndexB());
    input.sweepA = SweepOf(*a->GetBody());
    input.sweepB = SweepOf(*b->GetBody());
    input.tMax = 1.0f;
    b2TOIOutput output;
    b2TimeOfImpact(&output, &input); // its hook answers for big polygons
    return output.state == b2TOIOutput::e_touching ? b2Min(from + (1.0f - from) * output.t, 1.0f) : 1.0f;
}

/// Over all that is left of the step.
bool ImpactPass::IsProvedApart(const b2Contact &contact) {
    const b2Body *a = contact.GetFixtureA()->GetBody(), *b = contact.GetFixtureB()->GetBody();
    const bool apart = m_scan->NeverTouch(
        {contact.GetFixtureA(), contact.GetChildIndexA(), SweepOf(*a), a->GetTransform().q},
        {contact.GetFixtureB(), contact.GetChildIndexB(), SweepOf(*b), b->GetTransform().q},
        GuessAxis(contact), contact.GetManifold()->pointCount > 0);
    if (apart)
        Count(&Counts::toiAnswered);
    return apart;
}

void SolveImpacts(b2World *world, const b2TimeStep &step, IslandSolver *solver, PairTable *table) {
    ImpactPass(world, step, solver, table).Run();
}

} // namespace bmr
