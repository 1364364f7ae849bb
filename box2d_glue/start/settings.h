// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_SETTINGS_H
#define BOOMERANG_GLUE_SETTINGS_H

#include <atomic>
#include <cstdint>

#include "base/compiler.h"
#include "boomerang/box2d_glue.h"
#include "boomerang/pair.h"
#include "start/rounding_probe.h"

namespace bmr {

/// What Install decided, constant from then on.
/// Every member has its initial value at compile time: Install may run before this file's statics would.
struct Settings {
    bool made = false; ///< has Install decided? (Contacts of big ConvexShapes do not wait for it.)
    Options options = {};
    /// Do contacts remember edges, which are asked ahead of a structure of hulls? Not where
    /// BOOMERANG_PAIRS_BY has every pair held by a structure of the paper.
    bool remembersEdges = true;
    bool everywhere = false;   ///< BOOMERANG_EVERYWHERE
    bmr_pair_def pairDef = {}; ///< structure and hysteresis; the margin is each pair's own
    /// Directions for hulls of up to kMostHullVertices vertices; NULL where not needed.
    const bmr_compass *compass = nullptr;
    /// The hooks that Box2D's calls come by, where anybody is told of them; all where nobody is.
    uint32_t reached = kAllHooks;
    bool sameRounding = false;  ///< Box2D here rounds as core/exact32 does: its bits can be computed here
    bool solvesIslands = false; ///< those of its solver, too
    CollideByFace collideByFace = nullptr; ///< where it does not: Box2D's own points of a known face
};

namespace internal {
extern Settings settings;
/// Options::hooks once installed; none before, and none in mode Off. kWatching while it is found out which
/// hooks are reached (reach.h).
extern std::atomic<uint32_t> activeHooks;
constexpr uint32_t kWatching = 1u << 31;
/// Set with them, also where Options::hooks is none: steps are counted, contacts may be ours.
constexpr uint32_t kInstalled = 1u << 30;
static_assert((kAllHooks & (kWatching | kInstalled)) == 0);
void NoteReached(Hook hook);
} // namespace internal
inline const Settings &GetSettings() {
    return internal::settings;
}

/// Is this function answered here? A load and a test, for the first line of a hook. Where it is, the settings
/// are all there, also on a thread that steps nothing and calls Box2D while another one starts the library.
inline bool HookIsOn(Hook hook) {
    const uint32_t active = internal::activeHooks.load(std::memory_order_acquire);
    if ((active & Bit(hook)) != 0)
        return true;
    if ((active & internal::kWatching) != 0)
        internal::NoteReached(hook);
    return false;
}

/// Is any function answered here? Then this is a Box2D that the glue knows, and its objects may be looked
/// into.
inline bool AnyHookIsOn() {
    return (internal::activeHooks.load(std::memory_order_acquire) & kAllHooks) != 0;
}

/// Is nothing installed, nor looked for? Then hooks have nothing to do but for big polygons. One load and a
/// test: the first line of hooks that are called many times a step. So it is until the library has started,
/// and in Mode::Off.
inline bool NothingIsInstalled() {
    return BMR_RARELY(internal::activeHooks.load(std::memory_order_acquire) == 0);
}

/// The hooks that answer nothing where Box2D rounds otherwise than core/exact32: theirs are the bits of its
/// operations. (But for manifolds, where Box2D's own source makes their points.)
constexpr uint32_t kHooksOfSameRounding =
    Bit(Hook::TouchingManifold) | Bit(Hook::FixtureBoxes) | Bit(Hook::TreeUpdates);
inline uint32_t HooksOffForRounding(const Settings &settings) {
    const uint32_t off = settings.sameRounding ? kNoHooks
                         : settings.collideByFace != nullptr
                             ? kHooksOfSameRounding & ~Bit(Hook::TouchingManifold)
                             : kHooksOfSameRounding;
    return settings.options.hooks & settings.reached & off;
}

/// Is every answer to be compared with Box2D's?
inline bool Verifying() {
    return GetSettings().options.mode == Mode::Verify;
}

/// Is nothing left to Box2D because it would cost more here than it saves? So it is where answers are
/// counted, told of or compared: a small world's, or one's that moves too much, would not be.
inline bool WorksEverywhere() {
    const Options &options = GetSettings().options;
    return GetSettings().everywhere || options.statistics || options.mode == Mode::Verify;
}

inline bool EdgesAreOn() {
    return GetSettings().remembersEdges;
}

/// Takes the options over; called once, by Install. False without memory for the compass table.
bool MakeSettings(const Options &options, uint32_t reached = kAllHooks);
/// From here on the hooks answer. The last thing that Install does.
void ActivateHooks();

/// Process-wide counts, written only where Options::statistics asks for them; what Mode::Verify tells
/// (verified, differences, steps) in that mode too.
struct Counts {
    std::atomic<uint64_t> evaluations{0}, edgeChecks{0}, edgeSearches{0}, verdictsReused{0}, provedApart{0},
        handedOver{0}, handedOverTouching{0}, touchingAnswered{0}, toiQueries{0}, toiAnswered{0},
        overlapQueries{0}, overlapsAnswered{0}, verified{0}, differences{0}, steps{0}, pairs{0}, hulls{0},
        kineticChecks{0}, kineticSteps{0}, pairsWatched{0}, looks{0}, renewals{0};
    std::atomic<uint64_t> kineticEvents[BMR_EVENT_KIND_COUNT] = {};
};
Counts &GetCounts();

inline void Count(std::atomic<uint64_t> Counts::*counter) {
    if (GetSettings().options.statistics)
        (GetCounts().*counter).fetch_add(1, std::memory_order_relaxed);
}

inline void CountStep() {
    if (GetSettings().options.statistics || Verifying())
        GetCounts().steps.fetch_add(1, std::memory_order_relaxed);
}

} // namespace bmr

#endif
