// SPDX-License-Identifier: MIT
#include "tell/event.h"

#include "start/settings.h"

namespace bmr {

void TellOfEvent(const b2Body *bodyA, const b2Body *bodyB, const bmr_event &event) {
    const Options &options = GetSettings().options;
    GetCounts().kineticEvents[event.kind].fetch_add(1, std::memory_order_relaxed);
    if (options.onEvent != nullptr)
        options.onEvent(options.eventContext, bodyA, bodyB, event);
}

} // namespace bmr
