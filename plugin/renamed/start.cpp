// SPDX-License-Identifier: MIT
// The plugin starts at the first b2World::Step, unless the program has said by then what is to be, or
// BOOMERANG is off.
#include "hooks/start.h"

#include "boomerang/box2d.h"
#include "debug/statistics.h"
#include "start/install.h"

namespace bmr {

std::atomic<bool> internal::startsByItself{true};

void internal::StartNow() {
    StartOnce([] {
        ReadVerbosity();
        if (!InstallWasCalled())
            Install();
    });
}

/// There is one Box2D in what was compiled together.
bool internal::MeetBox2D(const void *) {
    return true;
}

namespace {

// (Install may be called before the first step.)
[[maybe_unused]] const bool wayIsSet = (SetWay("compiled with Box2D", nullptr), true);

} // namespace

} // namespace bmr
