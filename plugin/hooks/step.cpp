// SPDX-License-Identifier: MIT
// b2World::Step: starts the library if bmr::Install was not called, and marks the thread as stepping this
// world.
#include <box2d/b2_contact_manager.h>
#include <box2d/b2_world.h>

#include "passes/contact_access.h"
#include "passes/step.h"
#include "reach/stock.h"
#include "shapes/convex_draw.h"
#include "shapes/convex_geometry.h"
#include "start.h"
#include "start/current_step.h"
#include "start/settings.h"
#include "tell/exit_line.h"

using namespace bmr;

namespace {

BMR_NOINLINE void StepHere(b2World *world, float timeStep, int32 velocityIterations,
                           int32 positionIterations) {
    const StepUnderWay step(HasCodeOfGame(world->GetContactManager()));
    CurrentTimeStep() = timeStep;
    CountStep();
    if (StepIsOurs())
        RunStep(world, timeStep, velocityIterations, positionIterations);
    else
        stock::Step(world, timeStep, velocityIterations, positionIterations);
}

void StepAsAsked(b2World *world, float timeStep, int32 velocityIterations, int32 positionIterations) {
    if (AnyBigPolygon())
        NoteDrawnByBox2D(nullptr, nullptr); // shapes that were drawn before a step are drawn anew after it
    if (PassesRun(HookOf::Step))
        StepHere(world, timeStep, velocityIterations, positionIterations);
    else
        stock::Step(world, timeStep, velocityIterations, positionIterations);
}

BMR_COLD void StepTimed(b2World *world, float timeStep, int32 velocityIterations, int32 positionIterations) {
    const TimedStep timed;
    StepAsAsked(world, timeStep, velocityIterations, positionIterations);
    timed.End();
}

} // namespace

BMR_FOR_LOADERS("_ZN7b2World4StepEfii");

void b2World::Step(float timeStep, int32 velocityIterations, int32 positionIterations) {
    StartAtFirstStep();
    if (StepsAreTimed() && !IsFindingReach())
        StepTimed(this, timeStep, velocityIterations, positionIterations);
    else
        StepAsAsked(this, timeStep, velocityIterations, positionIterations);
}
