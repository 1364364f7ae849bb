// SPDX-License-Identifier: MIT
#include "start/settings.h"

#include "proofs/hull.h"
#include "proofs/thresholds.h"
#include "start/environment.h"
#include "tell/event.h"
#include "tell/exit_line.h"

namespace bmr {

Settings internal::settings;
std::atomic<internal::State> internal::state{State::Nothing};

Counts &GetCounts() {
    static Counts counts;
    return counts;
}

bool MakeSettings(const Options &options) {
    Settings made;
    made.made = true;
    made.options = options;
    made.options.statistics =
        options.statistics || options.onEvent != nullptr || AnswersAreObserved() || CountsAreWanted();
    made.pairDef = bmr_default_pair_def();
    made.everywhere = EverywhereOfEnvironment();
    made.pairDef.structure =
        made.options.pairsBy == BMR_STRUCTURE_COUNT ? BMR_FREE_DIRECTION : made.options.pairsBy;
    made.pairDef.hysteresis = kHysteresis;
    made.compass = nullptr;
    if (made.options.pairsBy == BMR_LAZY_COMPASS) {
        bmr_compass *compass = nullptr;
        if (bmr_compass_create(kMostCompassVertices, nullptr, &compass) != BMR_OK)
            return false;
        made.compass = compass; // for as long as the process lives: hulls of every world point to it
    }
    internal::settings = made;
    return true;
}

void ActivateHooks() {
    internal::state = internal::State::PassesRun;
}

} // namespace bmr
