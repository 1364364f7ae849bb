// SPDX-License-Identifier: MIT
#include "solver/island_solver.h"

#include <cmath>

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_joint.h>
#include <box2d/b2_world_callbacks.h>

#include "base/private_members.h"
#include "base/rounding_mode.h"

namespace bmr {

namespace {

/// How far a body goes in a step: no farther than Box2D lets it.
void Integrate(float h, b2Position *position, b2Velocity *velocity) {
    const b2Vec2 translation = h * velocity->v;
    if (b2Dot(translation, translation) > b2_maxTranslationSquared)
        velocity->v *= b2_maxTranslation / translation.Length();
    const float rotation = h * velocity->w;
    if (rotation * rotation > b2_maxRotationSquared)
        velocity->w *= b2_maxRotation / b2Abs(rotation);
    position->c += h * velocity->v;
    position->a += h * velocity->w;
}

void Store(const b2Position &position, const b2Velocity &velocity, b2Body *body) {
    b2Sweep &sweep = body->*Named(SweepMember());
    sweep.c = position.c;
    sweep.a = position.a;
    body->*Named(LinearVelocity()) = velocity.v;
    body->*Named(AngularVelocity()) = velocity.w;
}

constexpr uint32_t kEnough = 512; // contacts and joints; what waits stays in the processor's second cache

/// Does nothing that is solved move the static body, not by a bit? (Box2D moves it once for each island.)
bool StaysAsItIs(const b2Body &body) {
    const b2Sweep &sweep = SweepOf(body);
    const auto isZero = [](float x) { return x == 0.0f && !std::signbit(x); };
    const float at[] = {sweep.c.x, sweep.c.y, sweep.a};
    return isZero(body.GetLinearVelocity().x) && isZero(body.GetLinearVelocity().y) &&
           isZero(body.GetAngularVelocity()) && CarriesNoOrder(0.0f, 0.0f, at);
}

} // namespace

void IslandSolver::Begin(const b2TimeStep &step, b2ContactListener *listener, bool mayWait) {
    Clear();
    m_step = step;
    m_mayReorder = !TrapsAreSet(); // lanes compute what Box2D would leave out
    m_listener = listener;
    m_mayWait = mayWait;
    m_profile = {};
}

void IslandSolver::Clear() {
    m_bodyCount = m_contactCount = m_jointCount = m_islandCount = 0;
    m_waiting = {};
}

/// Room for the island, and for those that wait. What is there stays.
void IslandSolver::Reserve() {
    m_reserved = 2 * Most();
    m_positions.Reserve(m_reserved);
    m_velocities.Reserve(m_reserved);
    m_solver.Reserve(m_reserved, m_reserved);
    m_orderedVelocities.Reserve(m_reserved, m_reserved);
    m_orderedPositions.Reserve(m_reserved, m_reserved);
}

void IslandSolver::Solve(const b2Vec2 &gravity, bool allowSleep) {
    m_gravity = gravity;
    m_allowSleep = allowSleep;
    Island island = {m_waiting.endBody,
                     m_bodyCount,
                     m_waiting.endContact,
                     m_contactCount,
                     m_waiting.endJoint,
                     m_jointCount,
                     false,
                     false};
    m_mayReorder = m_mayReorder && (m_listener == nullptr || (RoundsToNearest() && IsWhole(island)));
    if (Most() > m_reserved)
        Reserve();
    m_solver.Begin(m_step, m_contacts.Data(), Data());
    m_solver.Read(island);
    m_jointSolver.Begin(m_joints.Data(), Data());
    if (MayWait(island)) {
        m_islands.Reserve(m_islandCount + 1);
        m_islands[m_islandCount++] = island;
        m_waiting.endBody = m_bodyCount;
        m_waiting.endContact = m_contactCount;
        m_waiting.endJoint = m_jointCount;
        if (m_contactCount + m_jointCount >= kEnough) {
            SolveWaiting();
            Clear();
        }
        return;
    }
    if (ContactCount() + JointCount() > 0) // it may share static bodies with those that came before
        SolveWaiting();
    SolveTogether(&island, 1);
    m_bodyCount = m_waiting.endBody;
    m_contactCount = m_waiting.endContact;
    m_jointCount = m_waiting.endJoint;
    if (m_islandCount == 0)
        Clear();
}

/// Is every body of a contact or a joint in the island? PostSolve may enable a contact, or step the world, so
/// that a body of an earlier island meets one of this. Box2D does not add it: it is solved at the place that
/// it had, which may be another body's here.
bool IslandSolver::IsWhole(const Island &island) const {
    const auto isIn = [&](b2Body *body) {
        const auto place = static_cast<uint32_t>(body->*Named(IslandIndex()));
        return place < island.endBody && m_bodies[place] == body;
    };
    bool isWhole = true;
    for (uint32_t i = island.firstContact; i < island.endContact; ++i)
        isWhole = isWhole && isIn(m_contacts[i]->GetFixtureA()->GetBody()) &&
                  isIn(m_contacts[i]->GetFixtureB()->GetBody());
    for (uint32_t i = island.firstJoint; i < island.endJoint; ++i)
        isWhole = isWhole && isIn(m_joints[i]->GetBodyA()) && isIn(m_joints[i]->GetBodyB());
    return isWhole;
}

bool IslandSolver::MayWait(const Island &island) const {
    bool mayWait = m_mayWait && ContactCount() + JointCount() > 0 && m_step.dt < b2_maxFloat;
    for (uint32_t i = island.firstBody; i < island.endBody && mayWait; ++i)
        mayWait = m_bodies[i]->GetType() != b2_staticBody || StaysAsItIs(*m_bodies[i]);
    return mayWait;
}

void IslandSolver::SolveWaiting() {
    if (m_islandCount > 0 && !SolveTogether(m_islands.Data(), m_islandCount))
        for (uint32_t i = 0; i < m_islandCount; ++i)
            SolveTogether(&m_islands[i], 1);
    m_islandCount = 0;
}

/// Returns false, and has changed nothing, if something of several islands became NaN: a static body may hand
/// it on from one to the next.
bool IslandSolver::SolveTogether(Island *islands, uint32_t count) {
    const Island &last = islands[count - 1];
    Island all = islands[0];
    all.endBody = last.endBody;
    all.endContact = last.endContact;
    all.endJoint = last.endJoint;
    const bool isBound = all.firstContact < all.endContact || all.firstJoint < all.endJoint;
    // An island that has neither contacts nor joints is not timed: it is solved faster than the clock is
    // read.
    if (isBound)
        m_timer.Reset();
    const auto milliseconds = [&] { return isBound ? m_timer.GetMilliseconds() : 0.0f; };
    Prepare(all);
    const float initialized = milliseconds();
    if (isBound)
        SolveVelocities(all);
    IntegratePositions(all);
    const float solved = milliseconds();
    if (isBound)
        SolvePositions(islands, count);
    else
        islands->isSolved = m_step.positionIterations > 0;
    if (count > 1 && (HasNan(&m_positions[0].c.x, all) || HasNan(&m_velocities[0].v.x, all))) {
        m_jointSolver.PutBack(all);
        return false;
    }
    m_solver.StoreImpulses(all);
    for (uint32_t i = 0; i < count; ++i) {
        StoreBodies(islands[i]);
        StorePlaces(islands[i]);
    }
    m_profile.solveInit += initialized;
    m_profile.solveVelocity += solved - initialized;
    m_profile.solvePosition += milliseconds() - solved;
    Report(all);
    for (uint32_t i = 0; i < count && m_allowSleep; ++i)
        Sleep(islands[i]);
    return true;
}

void IslandSolver::Finish(b2Profile *profile) {
    SolveWaiting();
    Clear();
    if (profile == nullptr)
        return;
    profile->solveInit += m_profile.solveInit;
    profile->solveVelocity += m_profile.solveVelocity;
    profile->solvePosition += m_profile.solvePosition;
}

/// The state ahead of the velocity iterations.
void IslandSolver::Prepare(const Island &island) {
    IntegrateVelocities(island);
    m_solver.PlaceBodies(island);
    m_solver.InitializeVelocities(island);
    if (m_step.warmStarting)
        m_solver.WarmStart(island);
    m_jointSolver.InitializeVelocities(island);
}

void IslandSolver::SolveVelocities(const Island &island) {
    if (m_mayReorder && m_solver.SolvesBlocks() &&
        m_orderedVelocities.Order(m_solver.VelocityConstraints(), m_jointSolver, island, m_velocities.Data(),
                                  m_step.velocityIterations)) {
        if (m_orderedVelocities.Solve(&m_solver, m_jointSolver, island, m_velocities.Data()))
            return;
        m_jointSolver.PutBack(island);
        Prepare(island);
    }
    for (int32 i = 0; i < m_step.velocityIterations; ++i) {
        m_jointSolver.SolveVelocities(island);
        m_solver.SolveVelocities(island);
    }
}

void IslandSolver::SolvePositions(Island *islands, uint32_t count) {
    if (m_mayReorder)
        m_orderedPositions.Solve(&m_solver, islands, count, m_positions.Data(), m_step.positionIterations);
    for (uint32_t i = 0; i < count; ++i)
        if (!islands[i].isDone)
            islands[i].isSolved = SolvePositions(islands[i]);
}

bool IslandSolver::SolvePositions(const Island &island) {
    for (int32 i = 0; i < m_step.positionIterations; ++i) {
        const bool contactsAreSolved = m_solver.SolvePositions(island);
        if (m_jointSolver.SolvePositions(island) && contactsAreSolved)
            return true;
    }
    return false;
}

/// Forces and damping, as far as the body has a mass. The sweep begins where the body is.
void IslandSolver::IntegrateVelocities(const Island &island) {
    const float h = m_step.dt;
    for (uint32_t i = island.firstBody; i < island.endBody; ++i) {
        b2Body *const body = m_bodies[i];
        body->*Named(IslandIndex()) = static_cast<int32>(i); // a static body may have several places
        b2Sweep &sweep = body->*Named(SweepMember());
        b2Vec2 v = body->GetLinearVelocity();
        float w = body->GetAngularVelocity();
        sweep.c0 = sweep.c;
        sweep.a0 = sweep.a;
        if (body->GetType() == b2_dynamicBody) {
            v += h * body->*Named(InverseMass()) *
                 (body->GetGravityScale() * body->GetMass() * m_gravity + body->*Named(Force()));
            w += h * body->*Named(InverseInertia()) * body->*Named(Torque());
            v *= 1.0f / (1.0f + h * body->GetLinearDamping());
            w *= 1.0f / (1.0f + h * body->GetAngularDamping());
        }
        m_positions[i] = {sweep.c, sweep.a};
        m_velocities[i] = {v, w};
    }
}

void IslandSolver::IntegratePositions(const Island &island) {
    for (uint32_t i = island.firstBody; i < island.endBody; ++i)
        Integrate(m_step.dt, &m_positions[i], &m_velocities[i]);
}

void IslandSolver::StoreBodies(const Island &island) {
    for (uint32_t i = island.firstBody; i < island.endBody; ++i) {
        b2Body *const body = m_bodies[i];
        Store(m_positions[i], m_velocities[i], body);
        body->*Named(TransformMember()) = m_solver.PoseOf(static_cast<int32>(i), body->GetLocalCenter());
    }
}

/// Each body's place in Box2D's island.
void IslandSolver::StorePlaces(const Island &island) {
    for (uint32_t i = island.firstBody; i < island.endBody; ++i)
        m_bodies[i]->*Named(IslandIndex()) = static_cast<int32>(i - island.firstBody);
}

void IslandSolver::Report(const Island &island) {
    for (uint32_t i = island.firstContact; m_listener != nullptr && i < island.endContact; ++i) {
        b2ContactImpulse impulse;
        m_solver.GetImpulse(i, &impulse);
        m_listener->PostSolve(m_contacts[i], &impulse);
        AskRoundingAgain();
    }
}

/// Puts the island to sleep once all of it has been slow for long enough. Reads what a listener left.
void IslandSolver::Sleep(const Island &island) {
    constexpr float kSlow = b2_linearSleepTolerance * b2_linearSleepTolerance;
    constexpr float kSlowTurn = b2_angularSleepTolerance * b2_angularSleepTolerance;
    float shortest = b2_maxFloat;
    for (uint32_t i = island.firstBody; i < island.endBody; ++i) {
        b2Body *const body = m_bodies[i];
        float &sleepTime = body->*Named(SleepTime());
        const b2Vec2 &v = body->GetLinearVelocity();
        const float w = body->GetAngularVelocity();
        if (body->GetType() == b2_staticBody)
            continue;
        if (!body->IsSleepingAllowed() || w * w > kSlowTurn || b2Dot(v, v) > kSlow) {
            sleepTime = 0.0f;
            shortest = 0.0f;
        } else {
            sleepTime += m_step.dt;
            shortest = b2Min(shortest, sleepTime);
        }
    }
    if (!(shortest >= b2_timeToSleep) || !island.isSolved)
        return;
    for (uint32_t i = island.firstBody; i < island.endBody; ++i)
        m_bodies[i]->SetAwake(false);
}

// b2Island::SolveTOI: the island of an impact.

void IslandSolver::SolveToi() {
    const int32 first = m_bodies[0]->*Named(IslandIndex()), second = m_bodies[1]->*Named(IslandIndex());
    const Island island = {0, m_bodyCount, 0, m_contactCount, 0, 0, false, false};
    if (!IsWhole(island)) // a step inside this one has numbered bodies anew
        return Clear();
    if (Most() > m_reserved)
        Reserve();
    for (uint32_t i = 0; i < m_bodyCount; ++i) {
        const b2Body &body = *m_bodies[i];
        m_positions[i] = {SweepOf(body).c, SweepOf(body).a};
        m_velocities[i] = {body.GetLinearVelocity(), body.GetAngularVelocity()};
    }
    m_solver.Begin(m_step, m_contacts.Data(), Data());
    m_solver.Read(island);
    m_solver.PlaceBodies(island);
    for (int32 i = 0; i < m_step.positionIterations; ++i)
        if (m_solver.SolveToiPositions(island, first, second))
            break;
    // The sweeps of the two that meet go on from here.
    for (const uint32_t i : {static_cast<uint32_t>(first), static_cast<uint32_t>(second)}) {
        b2Sweep &sweep = m_bodies[i]->*Named(SweepMember());
        sweep.c0 = m_positions[i].c;
        sweep.a0 = m_positions[i].a;
    }
    m_solver.InitializeVelocities(island);
    for (int32 i = 0; i < m_step.velocityIterations; ++i)
        m_solver.SolveVelocities(island);
    IntegratePositions(island);
    StoreBodies(island);
    Report(island);
    Clear();
}

} // namespace bmr
