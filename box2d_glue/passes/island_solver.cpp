// SPDX-License-Identifier: MIT
#include "passes/island_solver.h"

#include <chrono>
#include <new>

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_joint.h>
#include <box2d/b2_world_callbacks.h>

#include "base/private_members.h"

namespace bmr {

namespace {

/// Reads the clock for b2Profile. An island that has neither contacts nor joints is not timed: it is solved
/// faster than the clock is read.
class Timer {
public:
    explicit Timer(bool runs) : m_runs(runs) {
        if (m_runs)
            m_start = std::chrono::steady_clock::now();
    }
    float GetMilliseconds() const {
        return m_runs ? std::chrono::duration<float, std::milli>(std::chrono::steady_clock::now() - m_start)
                            .count()
                      : 0.0f;
    }

private:
    bool m_runs;
    std::chrono::steady_clock::time_point m_start;
};

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

} // namespace

void IslandSolver::SolveBy(IslandsBy solvedBy, b2World *world) {
    m_allocator = solvedBy == IslandsBy::Box2D ? &(world->*Named(StackAllocator())) : nullptr;
}

bool IslandSolver::Reserve(uint32_t bodies, uint32_t contacts, uint32_t joints) {
    if (!m_room.stack.Reserve(bodies) || !m_bodies.Reserve(bodies) || !m_contacts.Reserve(contacts) ||
        !m_joints.Reserve(joints))
        return false;
    return m_allocator != nullptr ||
           (m_positions.Reserve(bodies) && m_velocities.Reserve(bodies) &&
            m_solver.Reserve(bodies, contacts) && m_orderedVelocities.Reserve(bodies, contacts) &&
            m_orderedPositions.Reserve(bodies, contacts));
}

void IslandSolver::Begin(const b2TimeStep &step, b2ContactListener *listener) {
    Clear();
    m_step = step;
    m_listener = listener;
    m_profile = {};
}

void IslandSolver::Add(b2Body *body) {
    body->*Named(IslandIndex()) = static_cast<int32>(m_bodyCount);
    m_bodies[m_bodyCount++] = body;
}

void IslandSolver::Solve(const b2Vec2 &gravity, bool allowSleep) {
    if (m_allocator != nullptr) {
        TheStockSolver().solve(Parts(), m_step, gravity, allowSleep, m_listener, &m_profile);
        Clear();
        return;
    }
    const Timer timer(m_contactCount + m_jointCount > 0);
    const b2SolverData data = {m_step, m_positions.Data(), m_velocities.Data()};
    Prepare(gravity, data);
    for (uint32_t i = 0; i < m_jointCount; ++i)
        (m_joints[i]->*Named(InitVelocityConstraints()))(data);
    const float initialized = timer.GetMilliseconds();
    if (!MayReorder() ||
        !m_orderedVelocities.Order(m_solver.VelocityConstraints(), m_contactCount, data.velocities,
                                   m_bodyCount, m_step.velocityIterations)) {
        SolveVelocities(data);
    } else if (!m_orderedVelocities.Solve(&m_solver, data.velocities)) {
        Prepare(gravity, data);
        SolveVelocities(data);
    }
    m_solver.StoreImpulses();
    IntegratePositions();
    const float solved = timer.GetMilliseconds();
    const bool positionsAreSolved = SolvePositions(data);
    StoreBodies();
    m_profile.solveInit += initialized;
    m_profile.solveVelocity += solved - initialized;
    m_profile.solvePosition += timer.GetMilliseconds() - solved;
    Report();
    if (allowSleep)
        Sleep(positionsAreSolved);
    Clear();
}

void IslandSolver::SolveToi() {
    if (m_allocator != nullptr) {
        TheStockSolver().solveToi(Parts(), m_step, m_listener);
        Clear();
        return;
    }
    for (uint32_t i = 0; i < m_bodyCount; ++i) {
        const b2Body &body = *m_bodies[i];
        m_positions[i] = {SweepOf(body).c, SweepOf(body).a};
        m_velocities[i] = {body.GetLinearVelocity(), body.GetAngularVelocity()};
    }
    const b2SolverData data = {m_step, m_positions.Data(), m_velocities.Data()};
    m_solver.Begin(m_step, m_contacts.Data(), m_contactCount, data, m_bodyCount);
    for (int32 i = 0; i < m_step.positionIterations; ++i)
        if (m_solver.SolveToiPositions())
            break;
    for (uint32_t i = 0; i < 2; ++i) { // where the two go on from
        b2Sweep &sweep = m_bodies[i]->*Named(SweepMember());
        sweep.c0 = m_positions[i].c;
        sweep.a0 = m_positions[i].a;
    }
    m_solver.InitializeVelocities();
    for (int32 i = 0; i < m_step.velocityIterations; ++i)
        m_solver.SolveVelocities();
    IntegratePositions();
    StoreBodies();
    Report();
    Clear();
}

void IslandSolver::Finish(b2Profile *profile) {
    if (profile == nullptr)
        return;
    profile->solveInit += m_profile.solveInit;
    profile->solveVelocity += m_profile.solveVelocity;
    profile->solvePosition += m_profile.solvePosition;
}

/// The state ahead of the velocity iterations, but for joints.
void IslandSolver::Prepare(const b2Vec2 &gravity, const b2SolverData &data) {
    IntegrateVelocities(gravity);
    m_solver.Begin(m_step, m_contacts.Data(), m_contactCount, data, m_bodyCount);
    m_solver.InitializeVelocities();
    if (m_step.warmStarting)
        m_solver.WarmStart();
}

bool IslandSolver::MayReorder() const {
    return m_jointCount == 0 && m_solver.SolvesBlocks();
}

void IslandSolver::SolveVelocities(const b2SolverData &data) {
    for (int32 i = 0; i < m_step.velocityIterations; ++i) {
        for (uint32_t j = 0; j < m_jointCount; ++j)
            (m_joints[j]->*Named(SolveVelocityConstraints()))(data);
        m_solver.SolveVelocities();
    }
}

IslandParts IslandSolver::Parts() const {
    return {m_allocator, m_bodies.Data(), m_contacts.Data(), m_joints.Data(),
            m_bodyCount, m_contactCount,  m_jointCount};
}

/// Forces and damping, as far as the body has a mass. The sweep begins where the body is.
void IslandSolver::IntegrateVelocities(const b2Vec2 &gravity) {
    const float h = m_step.dt;
    for (uint32_t i = 0; i < m_bodyCount; ++i) {
        b2Body *const body = m_bodies[i];
        b2Sweep &sweep = body->*Named(SweepMember());
        b2Vec2 v = body->GetLinearVelocity();
        float w = body->GetAngularVelocity();
        sweep.c0 = sweep.c;
        sweep.a0 = sweep.a;
        if (body->GetType() == b2_dynamicBody) {
            v += h * body->*Named(InverseMass()) *
                 (body->GetGravityScale() * body->GetMass() * gravity + body->*Named(Force()));
            w += h * body->*Named(InverseInertia()) * body->*Named(Torque());
            v *= 1.0f / (1.0f + h * body->GetLinearDamping());
            w *= 1.0f / (1.0f + h * body->GetAngularDamping());
        }
        m_positions[i] = {sweep.c, sweep.a};
        m_velocities[i] = {v, w};
    }
}

void IslandSolver::IntegratePositions() {
    for (uint32_t i = 0; i < m_bodyCount; ++i)
        Integrate(m_step.dt, &m_positions[i], &m_velocities[i]);
}

bool IslandSolver::SolvePositions(const b2SolverData &data) {
    bool isSolved = false;
    if (m_jointCount == 0 && m_orderedPositions.Solve(&m_solver, m_contactCount, data.positions, m_bodyCount,
                                                      m_step.positionIterations, &isSolved))
        return isSolved;
    for (int32 i = 0; i < m_step.positionIterations; ++i) {
        bool solved = m_solver.SolvePositions();
        for (uint32_t j = 0; j < m_jointCount; ++j) {
            const bool jointIsSolved = (m_joints[j]->*Named(SolvePositionConstraints()))(data);
            solved = solved && jointIsSolved;
        }
        if (solved)
            return true;
    }
    return false;
}

void IslandSolver::StoreBodies() {
    for (uint32_t i = 0; i < m_bodyCount; ++i) {
        b2Body *const body = m_bodies[i];
        Store(m_positions[i], m_velocities[i], body);
        body->*Named(TransformMember()) = m_solver.PoseOf(static_cast<int32>(i), body->GetLocalCenter());
    }
}

void IslandSolver::Report() {
    for (uint32_t i = 0; m_listener != nullptr && i < m_contactCount; ++i) {
        b2ContactImpulse impulse;
        m_solver.GetImpulse(i, &impulse);
        m_listener->PostSolve(m_contacts[i], &impulse);
    }
}

/// Puts the island to sleep once all of it has been slow for long enough. Reads what a listener left.
void IslandSolver::Sleep(bool positionsAreSolved) {
    constexpr float kSlow = b2_linearSleepTolerance * b2_linearSleepTolerance;
    constexpr float kSlowTurn = b2_angularSleepTolerance * b2_angularSleepTolerance;
    float shortest = b2_maxFloat;
    for (uint32_t i = 0; i < m_bodyCount; ++i) {
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
    if (!(shortest >= b2_timeToSleep) || !positionsAreSolved)
        return;
    for (uint32_t i = 0; i < m_bodyCount; ++i)
        m_bodies[i]->SetAwake(false);
}

IslandSolvers::~IslandSolvers() {
    while (m_first != nullptr) {
        IslandSolver *const next = m_first->m_next;
        delete m_first;
        m_first = next;
    }
}

IslandSolver *IslandSolvers::Take() {
    IslandSolver **place = &m_first;
    while (*place != nullptr && (*place)->m_isTaken)
        place = &(*place)->m_next;
    if (*place == nullptr)
        *place = new (std::nothrow) IslandSolver;
    if (*place != nullptr)
        (*place)->m_isTaken = true;
    return *place;
}

} // namespace bmr
