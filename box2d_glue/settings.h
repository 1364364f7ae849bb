// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_SETTINGS_H
#define BOOMERANG_GLUE_SETTINGS_H

#include <atomic>
#include <cstdint>

#include "boomerang/box2d_glue.h"
#include "boomerang/pair.h"

namespace bmr {

/// What Install decided, constant from then on.
struct Settings {
    Options options;
    bmr_pair_def pairDef; ///< structure and hysteresis; the margin is each pair's own
    const bmr_compass
        *compass;      ///< directions for hulls of up to kMostHullVertices vertices; NULL where not needed
    bool sameRounding; ///< Box2D here rounds as core/exact32 does: remembered edges need no margin
};

namespace internal {
extern Settings settings;
}
inline const Settings &GetSettings() {
    return internal::settings;
}

/// Do contacts remember edges?
inline bool EdgesAreOn() {
    return GetSettings().options.prefilter && GetSettings().sameRounding;
}

/// Takes the options over; called once, by Install. False without memory for the compass table.
bool MakeSettings(const Options &options);

/// Process-wide counts, written only where Options::statistics asks for them.
struct Counts {
    std::atomic<uint64_t> evaluations{0}, edgeChecks{0}, edgeSearches{0}, verdictsReused{0}, provedApart{0},
        handedOver{0}, handedOverTouching{0}, pairs{0}, hulls{0}, kineticChecks{0}, kineticLevels{0};
    std::atomic<uint64_t> kineticEvents[BMR_EVENT_KIND_COUNT] = {};
};
Counts &GetCounts();

inline void Count(std::atomic<uint64_t> Counts::*counter) {
    if (GetSettings().options.statistics)
        (GetCounts().*counter).fetch_add(1, std::memory_order_relaxed);
}

} // namespace bmr

#endif
