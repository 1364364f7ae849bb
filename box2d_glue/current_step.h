// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CURRENT_STEP_H
#define BOOMERANG_GLUE_CURRENT_STEP_H

#include <cstdint>

namespace bmr {

/// The number of the step of a world that this thread is in; 0 outside of steps, and where nobody tells of
/// them (the shared library does, in b2World::Step). No two steps of a process have the same.
inline uint64_t &CurrentStep() {
    static thread_local uint64_t step = 0;
    return step;
}

/// The number of a step that begins.
uint64_t NextStep();
/// Has any begun? Then the others will be told of, too.
bool StepsAreSeen();

} // namespace bmr

#endif
