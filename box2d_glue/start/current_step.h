// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CURRENT_STEP_H
#define BOOMERANG_GLUE_CURRENT_STEP_H

#include <cstdint>

namespace bmr {

/// The number of the step that began last on this thread, until it ends. 0 between steps, in programs without
/// the shared library, and in the rest of a step after another step was made inside it. No two steps of a
/// process have the same number.
inline uint64_t &CurrentStep() {
    static thread_local uint64_t step = 0;
    return step;
}

/// The same number, and it stays when the step ends. It tells whether a step has begun since it was read.
inline uint64_t &LatestStep() {
    static thread_local uint64_t step = 0;
    return step;
}

/// Did code of the game, a listener or a filter of its own, run in this thread's step? What was read of the
/// world before may then be another by now. False as a step begins, unless the game makes it in the midst of
/// another one; a pass that calls the game sets it. True where CurrentStep is 0.
inline bool &GameRan() {
    static thread_local bool ran = true;
    return ran;
}

/// The length in time of the step that began last on this thread. For guesses of how far bodies will move.
inline float &CurrentTimeStep() {
    static thread_local float seconds = 0.0f;
    return seconds;
}

/// The number of a step that begins.
uint64_t NextStep();

/// b2World::Step on this thread, until it ends, also by an exception of a listener's. A listener may step
/// another world, or its own. Steps may also be interleaved, each on a stack of its own: the later one need
/// not end first.
class StepUnderWay {
public:
    StepUnderWay();
    ~StepUnderWay();
    StepUnderWay(const StepUnderWay &) = delete;
    StepUnderWay &operator=(const StepUnderWay &) = delete;

    /// Did the last one begin inside another step?
    static bool IsInner();
};

} // namespace bmr

#endif
