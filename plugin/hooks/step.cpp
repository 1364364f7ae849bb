// SPDX-License-Identifier: MIT
// b2World::Step: starts the library where nobody called bmr::Install, and marks the thread as stepping this
// world; the step itself is Box2D's.
#include <box2d/b2_contact_manager.h>
#include <box2d/b2_world.h>

#include "base/rounding_mode.h"
#include "hooks/stepping.h"
#include "passes/contact_access.h"
#include "reach/stock.h"
#include "shapes/convex_draw.h"
#include "shapes/convex_geometry.h"
#include "start.h"
#include "start/current_step.h"
#include "start/settings.h"
#include "tell/trial.h"

namespace bmr::hooks {

BMR_THREAD Stepping stepping = {};

namespace {

/// May a listener or a filter of the game's run in a step of this world? Of a Box2D that is another one
/// nothing is looked at.
bool GameMayRunIn(const b2World &world) {
    if (!AnyHookIsOn())
        return true;
    const b2ContactManager &manager = world.GetContactManager();
    return IsOfGame(manager.m_contactListener) || IsOfGame(manager.m_contactFilter);
}

} // namespace

/// Ends with the step, also by an exception of a listener's. The number of the thread's step, and whether the
/// game may run in it, are always those of the newest mark.
class StepMark : public InChain<StepMark> {
public:
    explicit StepMark(const b2World &world)
        : InChain(&stepping.mark), m_world(&world), m_step(NextStep()), m_gameMayRun(GameMayRunIn(world)) {
        CurrentStep() = m_step;
        GameMayRun() = m_gameMayRun;
        StepIsToNearest() = false;
        StepIsToNearest() = !m_gameMayRun && RoundsToNearest();
    }
    ~StepMark() {
        if (!IsNewest())
            return;
        StepIsToNearest() = false; // an older step goes on in code of the game's
        CurrentStep() = Older() != nullptr ? Older()->m_step : 0;
        GameMayRun() = Older() == nullptr || Older()->m_gameMayRun;
    }

    static bool IsTwiceOf(const b2World *world) {
        int marks = 0;
        for (const StepMark *mark = stepping.mark == nullptr ? nullptr : stepping.mark->Object();
             mark != nullptr; mark = mark->Older())
            marks += mark->m_world == world ? 1 : 0;
        return marks > 1;
    }

private:
    const b2World *m_world;
    uint64_t m_step;
    bool m_gameMayRun;
};

bool IsInOwnStep(const b2World *world) {
    return StepMark::IsTwiceOf(world);
}

namespace {

BMR_NOINLINE void StepHere(b2World *world, float timeStep, int32 velocityIterations,
                           int32 positionIterations) {
    const StepMark mark(*world);
    CurrentTimeStep() = timeStep;
    CountStep();
    if (AnyBigPolygon())
        NoteDrawnByBox2D(nullptr, nullptr); // what was drawn before a step is drawn anew after it
    stock::Step(world, timeStep, velocityIterations, positionIterations);
}

void StepAsAsked(b2World *world, float timeStep, int32 velocityIterations, int32 positionIterations) {
    if (NothingIsInstalled() && !AnyBigPolygon())
        stock::Step(world, timeStep, velocityIterations, positionIterations);
    else
        StepHere(world, timeStep, velocityIterations, positionIterations);
}

BMR_COLD void StepTried(b2World *world, float timeStep, int32 velocityIterations, int32 positionIterations) {
    TimedStep timed;
    StepAsAsked(world, timeStep, velocityIterations, positionIterations);
    timed.End();
}

} // namespace

} // namespace bmr::hooks

using namespace bmr;
using namespace bmr::hooks;

BMR_FOR_LOADERS("_ZN7b2World4StepEfii");

void b2World::Step(float timeStep, int32 velocityIterations, int32 positionIterations) {
    StartAtFirstStep();
    if (IsTried())
        StepTried(this, timeStep, velocityIterations, positionIterations);
    else
        StepAsAsked(this, timeStep, velocityIterations, positionIterations);
}
