// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_SETTINGS_H
#define BOOMERANG_GLUE_SETTINGS_H

#include <atomic>
#include <cstdint>
#include <optional>
#include <string_view>

#include "base/compiler.h"
#include "boomerang/box2d_glue.h"
#include "boomerang/pair.h"
#include "debug/statistics.h"
#include "start/hook_list.h"

namespace bmr {

/// The decisions of Install, constant from then on. Every member has its initial value at compile time:
/// Install may run before this file's statics would.
struct Settings {
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
    Watching, ///< Install finds out which hooks are called (recognise.cpp)
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

/// Is every answer to be compared with Box2D's?
inline bool Verifying() {
    return GetSettings().options.mode == Mode::Verify;
}

/// Is nothing left to Box2D because it would cost more here than it saves? So it is where answers are
/// counted, reported or compared, and where structures of hulls are asked for: a small world's, or one's that
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

/// Takes the options over; called once, by Install.
void MakeSettings(const Options &options);

/// Process-wide.
Counts &GetCounts();

inline void Count(std::atomic<uint64_t> Counts::*counter) {
    if (GetSettings().options.statistics)
        (GetCounts().*counter).fetch_add(1, std::memory_order_relaxed);
}

// What the environment says.
//
// The environment variables that set the plugin without rebuilding the program:
//
//     BOOMERANG=on|off|verify    or 1|0, for the first two
//     BOOMERANG_VERBOSE=0|1
//     BOOMERANG_STEPS=N          the line at exit is of the first N steps (debug/statistics.h)
//
// They win over the options that the program passes. A value that is not understood is ignored, and one line
// on stderr says so, once for a process. Nothing is read in programs that run with another user's rights
// (setuid).
//
// Three more are for the project's own tests and its testbed; pages for games do not have them:
//
//     BOOMERANG_PAIRS_BY=free-direction|...        Options::pairsBy, by bmr_structure_name
//     BOOMERANG_COUNTS=FILE                        what was counted, when the process ends
//     BOOMERANG_EVERYWHERE=on                      budgets of motion also where they cost more than they
//     save

/// The value, empty where there is none; it ends with a zero. Empty in programs that run with another user's
/// rights.
std::string_view ReadEnvironment(const char *name);

/// The word of Options::mode.
const char *NameOf(Mode mode);

/// Is it said that a value is not understood? It is not by code that only reads the environment early.
enum class Complaints : uint8_t { Said, Held };

/// BOOMERANG, if it is there and understood.
std::optional<Mode> ModeOfEnvironment(Complaints complaints = Complaints::Said);

/// BOOMERANG_VERBOSE=1? Complaints are held.
bool IsVerbose();

/// `options`, outweighed by the environment.
Options WithEnvironment(const Options &options);

} // namespace bmr

#endif
