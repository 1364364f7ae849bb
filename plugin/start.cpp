// SPDX-License-Identifier: MIT
#include "start.h"

#include <cstdio>
#include <cstdlib>
#include <mutex>

#include "boomerang/box2d.h"
#include "environment.h"
#include "library_check.h"
#include "recognise.h"
#include "this_process.h"

namespace bmr {

std::atomic<bool> internal::startsByItself{false};

namespace {

std::mutex starting;

long loadedIn;

/// For the program and all that it has forked. (What it executes loads the library anew, and speaks for
/// itself.)
void SayNobodyCame() {
    if (internal::startsByItself && ThisProcess() == loadedIn && !IsAnnounced())
        std::fputs(
            "boomerang: never at work: no b2World::Step came by (has the program its own Box2D inside?)\n",
            stderr);
}

/// Runs when the library is loaded, possibly before other libraries' and the program's own constructors: it
/// looks at the environment and at what else is loaded.
__attribute__((constructor)) void Loaded() {
    SetLibraryCheck(WhyLibraryIsUnknown);
    const std::optional<Mode> asked = ModeOfEnvironment();
    if (asked == Mode::Off || (!asked && !IsPreloaded()))
        return;
    if (!StepsComeByHere()) {
        // Linked behind Box2D, say. What was asked for by name is done as far as it goes: contacts alone.
        if (asked)
            Install();
        return;
    }
    internal::startsByItself = true;
    if (WithEnvironment(Options()).verbosity > 0) {
        loadedIn = ThisProcess();
        ShareAnnouncement();
        std::atexit(SayNobodyCame);
    }
}

} // namespace

void internal::StartNow() {
    const std::lock_guard<std::mutex> lock(starting);
    if (!startsByItself.load(std::memory_order_relaxed))
        return;
    Install(); // says itself why not; false where the program has called it before
    startsByItself.store(false, std::memory_order_release);
}

} // namespace bmr
