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

/// May code of the game's own run in the middle of this thread's step? Not where the world's listener and
/// filter are the ones that Box2D begins with. True outside of steps that are announced.
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
