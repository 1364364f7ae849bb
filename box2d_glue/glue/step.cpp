// SPDX-License-Identifier: MIT
#include "glue/passes.h"

#include <chrono>

#include "base/memory.h"
#include "base/private_members.h"
#include "base/rounding_mode.h"
#include "glue/impacts.h"
#include "glue/islands.h"
#include "glue/pairs/pair_table.h"
#include "glue/pairs/pair_tables.h"
#include "solver/island_solver.h"
#include "start/current_step.h"
#include "start/settings.h"

namespace bmr {

namespace {

using Clock = std::chrono::steady_clock;

float Milliseconds(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<float, std::milli>(to - from).count();
}

/// Takes the time of one pass after another, for b2Profile.
class Laps {
public:
    float Next() {
        const Clock::time_point last = m_last;
        m_last = Clock::now();
        return Milliseconds(last, m_last);
    }
    float Whole() const { return Milliseconds(m_first, Clock::now()); }

private:
    const Clock::time_point m_first = Clock::now();
    Clock::time_point m_last = m_first;
};

/// A solver for one pass.
class TakenSolver {
public:
    TakenSolver(uint32_t bodies, uint32_t contacts, uint32_t joints)
        : m_solver(PerThread<IslandSolvers>()->Take()) {
        m_solver->Reserve(bodies, contacts, joints);
    }
    ~TakenSolver() { IslandSolvers::GiveBack(m_solver); }
    TakenSolver(const TakenSolver &) = delete;
    TakenSolver &operator=(const TakenSolver &) = delete;
    IslandSolver *Get() const { return m_solver; }

private:
    IslandSolver *m_solver;
};

void Solve(b2World *world, const b2TimeStep &step) {
    const TakenSolver solver(static_cast<uint32_t>(world->GetBodyCount()),
                             static_cast<uint32_t>(world->GetContactCount()),
                             static_cast<uint32_t>(world->GetJointCount()));
    IslandPass(world, step, solver.Get()).Run();
}

void SolveTOI(b2World *world, const b2TimeStep &step) {
    const TakenSolver solver(2 * b2_maxTOIContacts, b2_maxTOIContacts, 0);
    ImpactPass(world, step, solver.Get()).Run();
}

void ClearForces(b2World *world) {
    const auto clear = [](b2Body *body) {
        (body->*Named(Force())).SetZero();
        body->*Named(Torque()) = 0.0f;
    };
    Ledger *const ledger = FindLedger(&world->GetContactManager());
    // Code of the game may have woken bodies, and have pushed them, since the list was made.
    if (ledger != nullptr && ledger->GetBodies().AreAlone(CurrentStep()) && !GameRan()) {
        for (uint32_t i = 0; i < ledger->GetBodies().AwakeCount(); ++i)
            clear(ledger->GetBodies().Awake(i));
        return;
    }
    for (b2Body *body = world->GetBodyList(); body != nullptr; body = body->GetNext())
        clear(body);
}

} // namespace

bool StepIsOurs(const b2World &world) {
    const b2ContactManager &manager = world.GetContactManager();
    const bool isOurs = RoundsToNearest() && PerThread<IslandSolvers>() != nullptr;
    const Ledger *const ledger = FindLedger(&manager);
    if (ledger != nullptr && (!isOurs || world.IsLocked() || ledger->IsInPass()))
        LeaveTable(&manager);
    return isOurs;
}

void RunStep(b2World *world, float seconds, int32 velocityIterations, int32 positionIterations) {
    Laps laps;
    b2Profile &profile = world->*Named(Profile());
    auto &manager = const_cast<b2ContactManager &>(world->GetContactManager());
    if (world->*Named(NewContacts())) {
        manager.FindNewContacts();
        world->*Named(NewContacts()) = false;
        laps.Next();
    }
    world->*Named(Locked()) = true;
    const bool advances = seconds > 0.0f;
    b2TimeStep step;
    step.dt = seconds;
    step.inv_dt = advances ? 1.0f / seconds : 0.0f;
    step.dtRatio = world->*Named(InverseStep()) * seconds;
    step.velocityIterations = velocityIterations;
    step.positionIterations = positionIterations;
    step.warmStarting = world->GetWarmStarting();

    Collide(&manager);
    profile.collide = laps.Next();
    if (advances && world->*Named(StepComplete())) {
        Solve(world, step);
        profile.solve = laps.Next();
    }
    if (advances && world->GetContinuousPhysics()) {
        SolveTOI(world, step);
        profile.solveTOI = laps.Next();
    }
    if (advances)
        world->*Named(InverseStep()) = step.inv_dt;
    if (world->GetAutoClearForces())
        ClearForces(world);
    world->*Named(Locked()) = false;
    profile.step = laps.Whole();
}

} // namespace bmr
