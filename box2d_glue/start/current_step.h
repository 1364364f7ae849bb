// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CURRENT_STEP_H
#define BOOMERANG_GLUE_CURRENT_STEP_H

#include <cstdint>

namespace bmr {

/// The number of the step that this thread is in. The shared library sets it in b2World::Step. 0 between
/// steps, and in programs without the shared library. No two steps of a process have the same number.
inline uint64_t &CurrentStep() {
    static thread_local uint64_t step = 0;
    return step;
}

/// True if code of the game may run in the middle of this thread's step: a listener or a filter of its own.
/// False while a world steps whose listener and filter are those that Box2D installs by itself. True, too,
/// when no step was announced on this thread.
inline bool &GameMayRun() {
    static thread_local bool mayRun = true;
    return mayRun;
}

/// The length in time of the step that began last on this thread. For guesses of how far bodies will move.
inline float &CurrentTimeStep() {
    static thread_local float seconds = 0.0f;
    return seconds;
}

/// The number of a step that begins.
uint64_t NextStep();

} // namespace bmr

#endif
