// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_HOOKS_START_H
#define BOOMERANG_HOOKS_START_H

#include <atomic>

#include "start/install.h"

/// @file
/// How the plugin starts where the program does not call bmr::Install: at the program's first b2World::Step.
/// As a shared library it does so where it was preloaded, or where BOOMERANG is on or verify; compiled with
/// Box2D's sources it always does, unless BOOMERANG is off. (What is here is defined in interposed and in
/// renamed.)

namespace bmr {

namespace internal {
/// Set ahead of the first step, cleared when it has started.
extern std::atomic<bool> startsByItself;
void StartNow();

/// Of StartNow: calls `start()` once, also if other threads come meanwhile.
template <typename Start> void StartOnce(const Start &start) {
    if (IsInTrialStep()) // Install does, on this thread
        return;
    const HoldsProcessLock lock;
    if (!startsByItself.load(std::memory_order_relaxed))
        return;
    start();
    startsByItself.store(false, std::memory_order_release);
}
} // namespace internal

/// The first line of b2World::Step. A thread that comes while another one is starting waits for it.
inline void StartAtFirstStep() {
    if (internal::startsByItself.load(std::memory_order_acquire))
        internal::StartNow();
}

} // namespace bmr

#endif
