// SPDX-License-Identifier: MIT
// b2World::Step: starts the library where nobody called bmr::Install, and marks the thread as stepping this
// world; the step itself is Box2D's.
#include <box2d/b2_world.h>

#include "current_step.h"
#include "real.h"
#include "settings.h"
#include "start.h"

namespace bmr::interpose {

__thread Stepping stepping = {nullptr, nullptr, 0};

namespace {

/// Ends with the step, also by an exception of a listener's; a listener may step another world.
class StepMark {
public:
    explicit StepMark(const b2World *world) : m_outer(stepping), m_outerStep(CurrentStep()) {
        stepping = {world, nullptr, 0};
        CurrentStep() = NextStep();
    }
    ~StepMark() {
        stepping = m_outer;
        CurrentStep() = m_outerStep;
    }
    StepMark(const StepMark &) = delete;
    StepMark &operator=(const StepMark &) = delete;

private:
    Stepping m_outer;
    uint64_t m_outerStep;
};

Real<void(b2World *, float, int32, int32)> realStep("_ZN7b2World4StepEfii");

} // namespace

void Step(b2World *world, float timeStep, int32 velocityIterations, int32 positionIterations)
    BMR_STANDS_FOR("_ZN7b2World4StepEfii");

void Step(b2World *world, float timeStep, int32 velocityIterations, int32 positionIterations) {
    StartAtFirstStep();
    const StepMark mark(world);
    Count(&Counts::steps);
    realStep.Get()(world, timeStep, velocityIterations, positionIterations);
}

} // namespace bmr::interpose
