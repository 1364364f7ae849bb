// SPDX-License-Identifier: MIT
#include "hooks/start.h"

#include <cstdio>
#include <cstdlib>

#include "boomerang/box2d.h"
#include "debug/exit_line.h"
#include "interposed/loader.h"
#include "start/install.h"
#include "start/recognise.h"
#include "start/settings.h"

static_assert(sizeof(bmr_pair) == 64, "a pair is one cache line"); // as its header promises

namespace bmr {

std::atomic<bool> internal::startsByItself{false};

namespace {

long loadedIn;
/// Preloaded, or asked for by the environment. Otherwise the program calls bmr::Install.
bool startsAtFirstStep = false;

/// At the end of the process that loaded the library, where nothing else was said.
void SayWhyNotUsed() {
    const bool came = StepsAreSeen() && !internal::startsByItself;
    if (ThisProcess() != loadedIn || IsAnnounced())
        return;
    const char *why = nullptr;
    if (startsAtFirstStep)
        why = came ? nullptr : WhyNoStepIsSeen();
    else if (!InstallWasCalled())
        why = "nothing called bmr::Install(). Call it before the first step, or set BOOMERANG=on";
    if (why != nullptr)
        std::fprintf(stderr, "boomerang: not used: %s\n", why);
}

void SayAtExitIfNotUsed() {
    if (!IsVerbose())
        return;
    loadedIn = ThisProcess();
    std::atexit(SayWhyNotUsed);
}

/// Runs when the library is loaded, possibly before other libraries' and the program's own constructors: it
/// looks at the environment and at what else is loaded. No Box2D is needed yet, so values that are not
/// understood are not reported here; Install reports them.
__attribute__((constructor)) void Loaded() {
    SetLibraryCheck(WhyLibraryIsUnknown);
    if (AnotherIsCompiledIn()) {
        if (ModeOfEnvironment(Complaints::Held) != Mode::Off)
            Refuse(WhyLibraryIsUnknown());
        return;
    }
    ReadVerbosity();
    if (StepsAreSeen())
        SetWay("ahead of Box2D", nullptr);
    else
        SetWay("not ahead of Box2D", WhyNoStepIsSeen());
    const std::optional<Mode> asked = ModeOfEnvironment(Complaints::Held);
    if (asked == Mode::Off)
        return;
    if (!asked && !IsPreloaded()) {
        ModeOfEnvironment(); // for what it says of a word that was meant to switch it on
        SayAtExitIfNotUsed();
        return;
    }
    startsAtFirstStep = true;
    SayAtExitIfNotUsed();
    if (StepsAreSeen())
        internal::startsByItself = true;
    else if (asked && !ProgramStepsFirst())
        Refuse(WhyNoStepIsSeen());
}

} // namespace

void internal::StartNow() {
    StartOnce([] {
        if (AnyBox2DBehind())
            Install(); // says itself why not; false where the program has called it before
        else if (IsVerbose() && ClaimAnnouncement())
            std::fprintf(stderr, "boomerang: not used: %s\n", WhyModuleIsLeftAlone());
    });
}

} // namespace bmr
