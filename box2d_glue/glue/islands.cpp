// SPDX-License-Identifier: MIT
#include "glue/passes.h"

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_joint.h>
#include <box2d/b2_timer.h>

#include "glue/contacts/game_calls.h"
#include "glue/pairs/pair_tables.h"
#include "solver/island_solver.h"
#include "tree/edit.h"

namespace bmr {

namespace {

constexpr uint32_t kNoLink = 0x7fffffffu;
// With more of them the links cost what they save.
constexpr uint32_t kMostTouchingOf = 3;

bool MayBeSeed(const b2Body *body) {
    return !BodyInIsland::Is(body) && body->IsAwake() && body->IsEnabled() &&
           body->GetType() != b2_staticBody;
}

/// The number of the body's first link, with kLinked, until the body is in an island. Otherwise it is the
/// place that the body had in its last island, which Box2D's gear reads.
int32 &FirstLinkOf(b2Body *body) {
    return body->*Named(IslandIndex());
}

constexpr int32 kLinked = 1 << 30;  ///< this bit is set where FirstLinkOf is the number of a link
constexpr int32 kSlept = INT32_MIN; ///< and this one where the body slept when contacts were linked

class IslandPass {
public:
    IslandPass(b2World *world, const b2TimeStep &step, IslandSolver *solver, PairTable *table);
    void Run();

private:
    void BuildIslands(b2Profile *profile);
    void ClearFlags();
    bool Link();
    void LinkTo(b2Body *body, b2Contact *contact, b2Body *other);

    b2Body *NextSeed(const b2Body *seed);
    void BuildIsland(b2Body *seed);
    void Take(b2Body *body);
    void Take(b2Contact *contact, b2Body *other);
    void WakeInIsland(b2Body *body);
    void TakeJoints(const b2Body *body);
    void Push(b2Body *body);
    void SolveIsland();
    void AfterGame();
    void Synchronize();
    void PutPlaceBack(b2Body *body);
    void MoveBoxes(b2Body *body);

    b2World *m_world;
    b2ContactManager *m_manager;
    const b2TimeStep &m_step;
    IslandSolver *m_solver;
    b2ContactListener *m_listener; ///< of PostSolve
    PairTable *m_table;            ///< nullptr: the world has none, or has left it
    IslandScratch &m_scratch;
    uint32_t m_stackCount = 0, m_linkCount = 0;
    uint32_t m_seed = 0;
    bool m_mayLink = false;       ///< no gear joint reads the places of bodies in islands
    bool m_isLinked = false;      ///< the links are all contacts that touch of bodies that are awake
    bool m_seedsAreAwake = false; ///< they are Bodies::Awake
    bool m_onlyAwake = false;     ///< only bodies of Bodies::Awake are in islands
};

IslandPass::IslandPass(b2World *world, const b2TimeStep &step, IslandSolver *solver, PairTable *table)
    : m_world(world), m_manager(const_cast<b2ContactManager *>(&world->GetContactManager())), m_step(step),
      m_solver(solver), m_listener(PostSolveListener(m_manager->m_contactListener)),
      m_table(table != nullptr && !LeaveIfNotWhole(table) ? table : nullptr), m_scratch(solver->Scratch()) {}

void IslandPass::Run() {
    b2Profile &profile = m_world->*Named(Profile());
    profile.solveInit = profile.solveVelocity = profile.solvePosition = 0.0f;
    ClearFlags();
    if (m_table != nullptr)
        m_isLinked = m_mayLink && Link();
    BuildIslands(&profile);
    const b2Timer timer;
    Synchronize();
    FindNewContacts(m_manager);
    profile.broadphase = timer.GetMilliseconds();
}

void IslandPass::BuildIslands(b2Profile *profile) {
    m_solver->Begin(m_step, m_listener, m_mayLink && !IsOfGame(m_listener));
    for (b2Body *seed = NextSeed(nullptr); seed != nullptr; seed = NextSeed(seed))
        if (MayBeSeed(seed))
            BuildIsland(seed);
    m_solver->Finish(profile);
}

void IslandPass::ClearFlags() {
    bool hasGear = false;
    for (b2Joint *joint = m_world->GetJointList(); joint != nullptr; joint = joint->GetNext()) {
        joint->*Named(JointInIsland()) = false;
        hasGear = hasGear || joint->GetType() == e_gearJoint;
    }
    m_mayLink = !hasGear;
    // (Where Bodies finds who is awake it has put all bodies out of islands.)
    m_onlyAwake = m_table != nullptr && m_mayLink &&
                  m_table->bodies.FindAwake(m_world->GetBodyList(), m_world->GetBodyCount());
    m_seedsAreAwake = m_onlyAwake;
    for (b2Body *body = m_onlyAwake ? nullptr : m_world->GetBodyList(); body != nullptr;
         body = body->GetNext()) {
        BodyInIsland::Clear(body);
        FirstLinkOf(body) &= ~(kSlept | kLinked); // Box2D sets no place when it makes a body
        if (m_mayLink && body->GetType() != b2_staticBody && !body->IsAwake())
            FirstLinkOf(body) |= kSlept;
    }
    for (uint32_t i = 0; m_onlyAwake && i < m_table->bodies.AwakeCount(); ++i)
        FirstLinkOf(m_table->bodies.Awake(i)) &= ~(kSlept | kLinked);
    // (By a table each island clears the marks of its contacts.)
    for (b2Contact *contact = m_table != nullptr ? nullptr : m_manager->m_contactList; contact != nullptr;
         contact = contact->GetNext())
        ContactAccess::Flags(contact) &= ~ContactAccess::kInIsland;
}

// Links.

/// False where it does not pay: islands are built from the lists of bodies.
bool IslandPass::Link() {
    const uint32_t most = m_table->Count() / kMostTouchingOf;
    Column<uint32_t> &touching = m_scratch.touching;
    uint32_t count = 0;
    for (uint32_t word = m_table->Count() / 64 + 1; word-- > 0;) {
        uint64_t left = m_table->TouchingOf(word);
        if (!m_table->deferred.GameRan()) // or the game may have woken bodies of pairs that sleep
            left &= m_table->AwakeOf(word);
        const uint32_t more = CountBits(left);
        if (count + more > most)
            return false;
        touching.Reserve(count + more);
        for (; left != 0; left &= ~(uint64_t{1} << HighestBit(left)))
            touching[count++] = word * 64 + HighestBit(left);
    }
    m_scratch.links.Reserve(2 * count + 1);
    while (count-- > 0) { // from the oldest on, each at the head of its lists, as when they were made
        b2Contact *const contact = m_table->Contact(touching[count]);
        b2Body *const a = contact->GetFixtureA()->GetBody(), *const b = contact->GetFixtureB()->GetBody();
        LinkTo(a, contact, b);
        LinkTo(b, contact, a);
    }
    return true;
}

void IslandPass::LinkTo(b2Body *body, b2Contact *contact, b2Body *other) {
    if (body->GetType() == b2_staticBody || !body->IsAwake())
        return;
    const int32 before = FirstLinkOf(body);
    const bool isHead = (before & kLinked) != 0;
    const uint32_t head = isHead ? static_cast<uint32_t>(before & ~kLinked) : kNoLink;
    m_scratch.links[m_linkCount] = {contact, body, other, head,
                                    isHead ? m_scratch.links[head].place : before};
    FirstLinkOf(body) = static_cast<int32>(m_linkCount++) | kLinked;
}

// Islands.

/// The first one follows nullptr.
b2Body *IslandPass::NextSeed(const b2Body *seed) {
    if (!m_seedsAreAwake)
        return seed != nullptr ? seed->*Named(NextBody()) : m_world->GetBodyList();
    return m_seed < m_table->bodies.AwakeCount() ? m_table->bodies.Awake(m_seed++) : nullptr;
}

void IslandPass::BuildIsland(b2Body *seed) {
    Push(seed);
    while (m_stackCount > 0)
        Take(m_scratch.stack[--m_stackCount]);
    SolveIsland();
}

void IslandPass::Push(b2Body *body) {
    BodyInIsland::Set(body);
    m_scratch.stack.Reserve(m_stackCount + 1);
    m_scratch.stack[m_stackCount++] = body;
}

/// The next body of the island. Islands do not go on across static bodies.
void IslandPass::Take(b2Body *body) {
    const int32 first = FirstLinkOf(body);
    m_solver->Add(body);
    if (body->GetType() == b2_staticBody)
        return;
    const bool wasAwake = body->IsAwake();
    if (!wasAwake)
        WakeInIsland(body);
    if (m_isLinked && wasAwake && (first & kSlept) == 0)
        for (uint32_t at = (first & kLinked) != 0 ? static_cast<uint32_t>(first & ~kLinked) : kNoLink;
             at != kNoLink; at = m_scratch.links[at].next)
            Take(m_scratch.links[at].contact, m_scratch.links[at].other);
    else
        for (b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next)
            Take(edge->contact, edge->other);
    TakeJoints(body);
}

/// (Its time asleep goes on.)
void IslandPass::WakeInIsland(b2Body *body) {
    uint16 &flags = body->*Named(BodyFlags());
    flags = static_cast<uint16>(flags | BodyInIsland::kAwake);
    m_onlyAwake = false;
    if (m_table != nullptr)
        m_table->AwakenPassed(body);
}

void IslandPass::Take(b2Contact *contact, b2Body *other) {
    uint32 &flags = ContactAccess::Flags(contact);
    if ((flags & ContactAccess::kInIsland) != 0 || !contact->IsEnabled() || !contact->IsTouching() ||
        contact->GetFixtureA()->IsSensor() || contact->GetFixtureB()->IsSensor())
        return;
    m_solver->Add(contact);
    flags |= ContactAccess::kInIsland;
    if (!BodyInIsland::Is(other))
        Push(other);
}

void IslandPass::TakeJoints(const b2Body *body) {
    for (const b2JointEdge *edge = body->GetJointList(); edge != nullptr; edge = edge->next) {
        if (edge->joint->*Named(JointInIsland()) || !edge->other->IsEnabled())
            continue;
        m_solver->Add(edge->joint);
        edge->joint->*Named(JointInIsland()) = true;
        if (!BodyInIsland::Is(edge->other))
            Push(edge->other);
    }
}

void IslandPass::SolveIsland() {
    for (uint32_t i = 0; i < m_solver->BodyCount(); ++i)
        if (m_solver->Body(i)->GetType() == b2_staticBody)
            BodyInIsland::Clear(m_solver->Body(i)); // it may be in other islands, too
    // (Their bodies that move are in this island, so that no other one reads these contacts.)
    for (uint32_t i = 0; i < m_solver->ContactCount(); ++i)
        ContactAccess::Flags(m_solver->Contact(i)) &= ~ContactAccess::kInIsland;
    const bool callsGame = IsOfGame(m_listener) && m_solver->ContactCount() > 0;
    if (callsGame && m_table != nullptr)
        m_table->deferred.BeforeGame();
    m_solver->Solve(m_world->GetGravity(), m_world->GetAllowSleeping());
    if (callsGame)
        AfterGame();
}

/// The listener's PostSolve was called, and may have woken bodies. If the pass began with the bodies that
/// were awake, nothing marks a sleeper's links as too few: none is followed from here on. Otherwise they
/// hold, unless the world has left its table.
void IslandPass::AfterGame() {
    m_isLinked = m_isLinked && !m_seedsAreAwake;
    m_seedsAreAwake = m_onlyAwake = false;
    if (m_table == nullptr || !LeaveIfNotWhole(m_table))
        return;
    m_table = nullptr;
    m_isLinked = false;
    for (b2Body *body = m_world->GetBodyList(); body != nullptr; body = body->GetNext())
        PutPlaceBack(body); // there may be a gear by now
}

// Behind the islands.

/// Boxes follow the bodies that were in islands, in Box2D's order.
void IslandPass::Synchronize() {
    if (m_table != nullptr)
        m_table->bodies.SetOnlyAwakeInIslands(m_onlyAwake);
    for (b2Body *body = m_onlyAwake ? nullptr : m_world->GetBodyList(); body != nullptr;
         body = body->GetNext()) {
        PutPlaceBack(body);
        MoveBoxes(body);
    }
    for (uint32_t i = 0; m_onlyAwake && i < m_table->bodies.AwakeCount(); ++i)
        MoveBoxes(m_table->bodies.Awake(i));
}

/// Of a body that is in no island: it slept, or PostSolve put it to sleep ahead of its island.
void IslandPass::PutPlaceBack(b2Body *body) {
    if (body->GetType() == b2_staticBody)
        return;
    int32 &place = FirstLinkOf(body);
    place &= ~kSlept;
    if ((place & kLinked) == 0)
        return;
    place &= ~kLinked;
    if (const auto link = static_cast<uint32_t>(place);
        link < m_linkCount && m_scratch.links[link].body == body)
        place = m_scratch.links[link].place;
}

void IslandPass::MoveBoxes(b2Body *body) {
    if (!BodyInIsland::Is(body) || body->GetType() == b2_staticBody)
        return;
    tree::SynchronizeBoxes(body);
    if (m_table != nullptr && !body->IsAwake())
        m_table->deferred.EnableOfSleeper(body);
}

} // namespace

void SolveIslands(b2World *world, const b2TimeStep &step, IslandSolver *solver, PairTable *table) {
    IslandPass(world, step, solver, table).Run();
}

} // namespace bmr
