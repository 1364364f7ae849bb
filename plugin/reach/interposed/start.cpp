// SPDX-License-Identifier: MIT
#include "start.h"

#include <cstdio>
#include <cstdlib>

#include "boomerang/box2d.h"
#include "hooks/profile_clock.h"
#include "reach/interposed/library_check.h"
#include "start/environment.h"
#include "start/reach.h"
#include "start/recognise.h"
#include "start/this_process.h"
#include "tell/trial.h"

namespace bmr {

std::atomic<bool> internal::startsByItself{false};

namespace {

// When the library is loaded nobody has asked for a Box2D yet, so nothing is said then of values that are not
// understood; Install says it.
std::optional<Mode> ModeWithoutComplaint() {
    const HeldComplaints held;
    return ModeOfEnvironment();
}
bool IsVerbose() {
    const HeldComplaints held;
    return WithEnvironment(Options()).verbosity > 0;
}

long loadedIn;

/// For the program and all that it has forked, where nothing else was said. (What it executes loads the
/// library anew, and speaks for itself.)
void SayNobodyCame() {
    const bool came = StepsComeByHere() && !internal::startsByItself;
    if (!came && ThisProcess() == loadedIn && !IsAnnounced())
        std::fputs(
            "boomerang: never at work: no b2World::Step came by (has the program its own Box2D inside?)\n",
            stderr);
}

void SayAtExitIfNobodyComes() {
    if (!IsVerbose())
        return;
    loadedIn = ThisProcess();
    ShareAnnouncement();
    std::atexit(SayNobodyCame);
}

/// Runs when the library is loaded, possibly before other libraries' and the program's own constructors: it
/// looks at the environment and at what else is loaded.
__attribute__((constructor)) void Loaded() {
    OpenTrial();
    SetLibraryCheck(WhyLibraryIsUnknown);
    SetWayOfHooks(StepsComeByHere() ? "ahead of Box2D" : "behind Box2D");
    const std::optional<Mode> asked = ModeWithoutComplaint();
    if (asked == Mode::Off)
        return;
    hooks::StartProfileClock();
    if (!asked && !IsPreloaded()) {
        ModeOfEnvironment(); // for what it says of a word that was meant to switch it on
        return;
    }
    if (!StepsComeByHere()) {
        // Linked behind Box2D, say. What was asked for by name is done as far as it goes: contacts alone. Not
        // where the program itself shows its Box2D (-rdynamic): that one is initialised later than this runs.
        SayAtExitIfNobodyComes();
        if (asked && InitialiseBox2D())
            Install();
        return;
    }
    internal::startsByItself = true;
    SayAtExitIfNobodyComes();
}

} // namespace

void internal::StartNow() {
    StartOnce([] {
        if (AnyBox2DBehind())
            Install(); // says itself why not; false where the program has called it before
        else if (WithEnvironment(Options()).verbosity > 0 && ClaimAnnouncement())
            std::fputs("boomerang: never at work: the Box2D of this process is a module's own (dlopen)\n",
                       stderr);
    });
}

} // namespace bmr
