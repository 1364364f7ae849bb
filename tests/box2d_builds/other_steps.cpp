// SPDX-License-Identifier: MIT
// A plugin that changes one thing: every tenth step is longer by one unit in the last place.
#include <cmath>

#include <dlfcn.h>

extern "C" {

__attribute__((visibility("default"))) void
_ZN7b2World4StepEfii(void *world, float timeStep, int velocityIterations, int positionIterations);

void _ZN7b2World4StepEfii(void *world, float timeStep, int velocityIterations, int positionIterations) {
    using Step = void(void *, float, int, int);
    static Step *const real = reinterpret_cast<Step *>(dlsym(RTLD_NEXT, "_ZN7b2World4StepEfii"));
    static int steps = 0;
    real(world, ++steps % 10 == 0 ? std::nextafter(timeStep, 1.0f) : timeStep, velocityIterations,
         positionIterations);
}
}
