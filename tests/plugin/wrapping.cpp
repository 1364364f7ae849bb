// SPDX-License-Identifier: MIT
// A b2World::Step of a game's own in front of Box2D's, as for a clock: in the program, or in a library that
// is preloaded.
#include <box2d/b2_world.h>
#include <dlfcn.h>

void b2World::Step(float timeStep, int32 velocityIterations, int32 positionIterations) {
    using Function = void (*)(b2World *, float, int32, int32);
    static const auto real = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "_ZN7b2World4StepEfii"));
    real(this, timeStep, velocityIterations, positionIterations);
}
