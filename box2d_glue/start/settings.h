// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_SETTINGS_H
#define BOOMERANG_GLUE_SETTINGS_H

#include <atomic>
#include <cstdint>

#include "base/compiler.h"
#include "boomerang/box2d_glue.h"
#include "boomerang/pair.h"
#include "start/hook_list.h"
#include "tell/counts.h"

namespace bmr {

/// The decisions of Install, constant from then on. Every member has its initial value at compile time:
/// Install may run before this file's statics would.
struct Settings {
    bool made = false; ///< has Install decided? (Contacts of big ConvexShapes do not wait for it.)
    Options options = {};
    bool everywhere = false; ///< BOOMERANG_EVERYWHERE
    /// Of Options::pairsBy: structure and hysteresis; the margin is each pair's own.
    bmr_pair_def pairDef = {};
    /// Directions for hulls of up to kMostCompassVertices vertices; NULL where not needed.
    const bmr_compass *compass = nullptr;
};

/// A function of Box2D's that has a hook.
#define BMR_NUMBER_HOOK(name, function, symbol, heard, result, parameters, renamed) name,
enum class HookOf : uint32_t { BMR_HOOKS(BMR_NUMBER_HOOK) Count };

namespace internal {
extern Settings settings;
/// The state that each hook reads first. Stored with release order when the settings are made.
enum class State : uint8_t {
    Nothing,  ///< so it is until the library has started, and in Mode::Off
    Watching, ///< Install finds out which hooks are called (reach.h)
    PassesRun ///< contacts and steps are ours
};
extern std::atomic<State> state;
void NoteReached(HookOf hook);
} // namespace internal
inline const Settings &GetSettings() {
    return internal::settings;
}

/// Do our passes run? Then this is a Box2D that the glue knows, and its objects may be looked into. A load
/// and a test. Where passes run, the settings are all there, also on a thread that steps nothing and calls
/// Box2D while another one starts the library.
inline bool PassesRun() {
    return internal::state.load(std::memory_order_acquire) == internal::State::PassesRun;
}

/// The same, for the hook of this function.
inline bool PassesRun(HookOf hook) {
    const internal::State state = internal::state.load(std::memory_order_acquire);
    if (state == internal::State::PassesRun)
        return true;
    if (state == internal::State::Watching)
        internal::NoteReached(hook);
    return false;
}

/// Is nothing installed, nor looked for? Then hooks have nothing to do but for big polygons. One load and a
/// test: the first line of hooks that are called many times a step.
inline bool NothingIsInstalled() {
    return BMR_RARELY(internal::state.load(std::memory_order_acquire) == internal::State::Nothing);
}

/// Is every answer to be compared with Box2D's?
inline bool Verifying() {
    return GetSettings().options.mode == Mode::Verify;
}

/// Is nothing left to Box2D because it would cost more here than it saves? So it is where answers are
/// counted, told of or compared, and where structures of hulls are asked for: a small world's, or one's that
/// moves too much, would not be.
inline bool WorksEverywhere() {
    const Options &options = GetSettings().options;
    return GetSettings().everywhere || options.statistics || options.mode == Mode::Verify ||
           options.pairsBy != BMR_STRUCTURE_COUNT;
}

/// Does a structure of the paper hold each pair of bodies (Options::pairsBy), where else each contact has a
/// line of its own?
inline bool PairsAreHulls() {
    return GetSettings().options.pairsBy != BMR_STRUCTURE_COUNT;
}

/// Takes the options over; called once, by Install. False without memory for the compass table.
bool MakeSettings(const Options &options);
/// From here on the hooks answer. The last thing that Install does.
void ActivateHooks();

/// Process-wide.
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
