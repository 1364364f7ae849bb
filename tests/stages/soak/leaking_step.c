// SPDX-License-Identifier: MIT
//
// The control of run_soak.sh, preloaded: each step of a world loses some memory, and touches it.
#define _GNU_SOURCE
#include <stdlib.h>
#include <string.h>

#include <dlfcn.h>

// b2World::Step(float, int32, int32)
void _ZN7b2World4StepEfii(void *world, float time, int velocity_iterations, int position_iterations);

void _ZN7b2World4StepEfii(void *world, float time, int velocity_iterations, int position_iterations) {
    static const size_t lost = 1024; // 1000 steps lose 1 MB
    static void (*real)(void *, float, int, int);
    if (real == NULL)
        *(void **)&real = dlsym(RTLD_NEXT, "_ZN7b2World4StepEfii");
    void *volatile memory = malloc(lost);
    if (memory != NULL)
        memset(memory, 1, lost);
    real(world, time, velocity_iterations, position_iterations);
}
