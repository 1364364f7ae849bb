// SPDX-License-Identifier: MIT
#include "glue/passes.h"

#include <box2d/b2_contact_manager.h>
#include <box2d/b2_time_step.h>
#include <box2d/b2_timer.h>
#include <box2d/b2_world.h>

#include "base/private_members.h"
#include "base/rounding_mode.h"
#include "glue/pairs/pair_tables.h"
#include "solver/island_solver.h"

namespace bmr {

namespace {

/// One step of the thread's: its solver is taken, and RoundsToNearest need not ask.
class StepOfThread {
public:
    StepOfThread() : m_solver(IslandSolver::OfThread()) { m_solver->isTaken = StepIsToNearest() = true; }
    ~StepOfThread() { m_solver->isTaken = StepIsToNearest() = false; }
    StepOfThread(const StepOfThread &) = delete;
    StepOfThread &operator=(const StepOfThread &) = delete;
    IslandSolver *Solver() const { return m_solver; }

private:
    IslandSolver *m_solver;
};

void ClearForces(b2World *world, PairTable *table) {
    const auto clear = [](b2Body *body) {
        (body->*Named(Force())).SetZero();
        body->*Named(Torque()) = 0.0f;
    };
    // Code of the game may have woken bodies, and have pushed them, since the list was made.
    if (table != nullptr && !table->WasLeft() && table->bodies.OnlyAwakeInIslands() &&
        !table->deferred.GameRan()) {
        for (uint32_t i = 0; i < table->bodies.AwakeCount(); ++i)
            clear(table->bodies.Awake(i));
        return;
    }
    for (b2Body *body = world->GetBodyList(); body != nullptr; body = body->GetNext())
        clear(body);
}

/// The table that the step goes by. None where Box2D's list costs less; in a step that goes on with the
/// impacts of the one before (sub-stepping); and where another thread is in a step of this world.
PairTable *TableOfStep(b2World *world, b2ContactManager *manager, float seconds) {
    PairTable *const table = PairTableForStep(manager);
    if (table == nullptr)
        return nullptr;
    if (!world->IsLocked() && world->*Named(StepComplete()) && table->cost.CountStep() && table->Follow()) {
        table->seconds = seconds;
        return table;
    }
    table->Interrupt();
    return nullptr;
}

} // namespace

bool ClaimStep(const b2World &world) {
    const b2ContactManager &manager = world.GetContactManager();
    const IslandSolver *const solver = IslandSolver::OfThread();
    const bool isOurs = RoundsToNearest() && solver != nullptr && !solver->isTaken;
    const PairTable *const table = FindPairTable(&manager);
    if (table != nullptr && (!isOurs || world.IsLocked() || table->IsHeld()))
        LeaveTable(&manager);
    return isOurs;
}

void RunStep(b2World *world, float seconds, int32 velocityIterations, int32 positionIterations) {
    const StepOfThread thread;
    const b2Timer whole;
    b2Timer lap; // of one pass after another
    const auto next = [&lap] {
        const float milliseconds = lap.GetMilliseconds();
        lap.Reset();
        return milliseconds;
    };
    b2Profile &profile = world->*Named(Profile());
    auto &manager = const_cast<b2ContactManager &>(world->GetContactManager());
    if (world->*Named(NewContacts())) {
        FindNewContacts(&manager);
        world->*Named(NewContacts()) = false;
        next();
    }
    PairTable *const table = TableOfStep(world, &manager, seconds);
    PairTable::Hold hold(table);
    world->*Named(Locked()) = true;
    const bool advances = seconds > 0.0f;
    b2TimeStep step;
    step.dt = seconds;
    step.inv_dt = advances ? 1.0f / seconds : 0.0f;
    step.dtRatio = world->*Named(InverseStep()) * seconds;
    step.velocityIterations = velocityIterations;
    step.positionIterations = positionIterations;
    step.warmStarting = world->GetWarmStarting();

    Collide(&manager, table);
    profile.collide = next();
    if (advances && world->*Named(StepComplete())) {
        SolveIslands(world, step, thread.Solver(), table);
        profile.solve = next();
    }
    if (advances && world->GetContinuousPhysics()) {
        SolveImpacts(world, step, thread.Solver(), table);
        profile.solveTOI = next();
    }
    if (advances)
        world->*Named(InverseStep()) = step.inv_dt;
    if (world->GetAutoClearForces())
        ClearForces(world, table);
    world->*Named(Locked()) = false;
    hold.Complete();
    profile.step = whole.GetMilliseconds();
}

} // namespace bmr
