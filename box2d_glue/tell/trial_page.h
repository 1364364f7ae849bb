// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_TRIAL_PAGE_H
#define BOOMERANG_GLUE_TRIAL_PAGE_H

#include <atomic>
#include <cstdint>

#include "tell/counts.h"

/// @file
/// By this file the library tells `boomerang try`, and the tests, about a running game: both map it. Whoever
/// tries the game makes it, all zeros but for the first three fields, and names it in the environment
/// (kTrialVariable). Its contents stay when the game crashes, or is ended.

namespace bmr {

constexpr const char *kTrialVariable = "BOOMERANG_TRIAL";

struct TrialPage {
    static constexpr uint32_t kMagic = 0x52545245; ///< of this layout; another layout gets another number
    static constexpr uint32_t kMostSteps = 1u << 18;
    static constexpr int kMostWords = 512, kMostNames = 16384;

    // Of the program.
    uint32_t magic;
    uint32_t size;                ///< of this struct
    uint32_t counts;              ///< 1: Options::statistics is on
    std::atomic<uint32_t> wanted; ///< counts up: what is told is wanted anew, at the end of the next step

    // Of the library.
    std::atomic<int64_t> loadedIn;  ///< the process that loaded it last; 0: none did
    std::atomic<int64_t> steppedIn; ///< the process whose steps are told, the first that took one; 0: none
    std::atomic<uint32_t> steps;    ///< that have ended; nested ones are part of the outer one
    std::atomic<uint32_t> told;     ///< the value of `wanted` that was answered last
    std::atomic<bool> listed;       ///< `files` is being written, or has been
    Counted counted;                ///< what was told last
    char way[kMostWords];           ///< how calls reach the hooks, the version of Box2D, how it rounds
    char noPass[kMostWords];        ///< empty, or why contacts alone are ours
    char whyNot[kMostWords];        ///< empty, or why the library leaves this Box2D alone
    char noStep[kMostWords];        ///< empty, or why it sees no step of it
    char files[kMostNames]; ///< what was loaded at the end of the first step, or of the process; a line each
    float microseconds[kMostSteps]; ///< of each step, in the order in which they ended
};

} // namespace bmr

#endif
