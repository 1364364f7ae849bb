// SPDX-License-Identifier: MIT
// The plugin starts at the first b2World::Step, unless the program has said by then what is to be, or
// BOOMERANG is off.
#include "start.h"

#include <mutex>

#include "boomerang/box2d.h"
#include "hooks/profile_clock.h"
#include "start/install.h"
#include "start/process_locks.h"
#include "start/reach.h"

namespace bmr {

std::atomic<bool> internal::startsByItself{true};

void internal::StartNow() {
    if (IsFindingReachedHooks()) // Install does, on this thread
        return;
    const std::lock_guard<std::mutex> lock(LockOf(ProcessLock::Starting));
    if (!startsByItself.load(std::memory_order_relaxed))
        return;
    hooks::StartProfileClock();
    if (!InstallWasCalled())
        InstallHere(Options());
    startsByItself.store(false, std::memory_order_release);
}

/// There is one Box2D in what was compiled together.
bool internal::MeetBox2D(const void *) {
    return true;
}

namespace {

// (Install may be called before the first step.)
[[maybe_unused]] const bool told = (SetWayOfHooks("compiled with Box2D"), true);

} // namespace

} // namespace bmr
