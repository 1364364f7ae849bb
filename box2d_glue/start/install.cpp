// SPDX-License-Identifier: MIT
#include "start/install.h"

#include <atomic>
#include <cstdio>
#include <cstring>

#if defined(_WIN32) // which does not fork
#    include <process.h>
#else
#    include <unistd.h>
#endif

#include "base/rounding_mode.h"
#include "boomerang/box2d_glue.h"
#include "debug/exit_line.h"
#include "debug/verify.h"
#include "glue/contacts/contact_register.h"
#include "start/recognise.h"
#include "start/settings.h"

namespace bmr {

namespace {

std::atomic<const char *> theWay{"not ahead of Box2D"}, notAhead{nullptr};
std::atomic<bool> announced{false};
std::recursive_mutex processLock;
std::atomic<const void *> tableOfRecorders{nullptr};
int recorders = 0; ///< alive, of this table
bool called = false;
bool installed = false;
const char *refusedWhy = nullptr;

/// Why Box2D's arithmetic is not the one that ours repeats, in a few words; nullptr where it is.
const char *WhyRoundingIsAnother() {
    if (!Box2DRoundsAsExact32())
        return "this Box2D fuses products (as compilers do for ARM64, and with -march=haswell), or has "
               "fast-math. Compile it with -ffp-contract=off and without, or use boomerang_accelerate()";
    return Box2DCollidesEdgesAsExact32() ? nullptr : "edges collide by other rules in this Box2D";
}

void Announce(const Options &options) {
    std::fprintf(stderr, "boomerang: %s; %s %s\n", NameOf(options.mode), TheWay(), VersionOfBox2D());
}

} // namespace

void SetWay(const char *way, const char *whyNotAhead) {
    theWay.store(way, std::memory_order_relaxed);
    notAhead.store(whyNotAhead, std::memory_order_relaxed);
}

const char *TheWay() {
    return theWay.load(std::memory_order_relaxed);
}

bool Refuse(const char *why) {
    const HoldsProcessLock lock;
    refusedWhy = why;
    ClaimAnnouncement();
    std::fprintf(stderr, "boomerang: not at work, Box2D runs as it is: %s\n", why);
    return false;
}

bool Install(const Options &given) {
    const HoldsProcessLock lock;
    called = true;
    if (installed || refusedWhy != nullptr)
        return false;
    const NearestRounding nearest; // Box2D is tried out in the mode in which it will be asked
    const Options options = WithEnvironment(given);
    ReadVerbosity();
    if (options.verbosity > 0)
        TimeSteps();
    if (options.mode == Mode::Off)
        return false;
    if (static_cast<unsigned>(options.pairsBy) > BMR_STRUCTURE_COUNT)
        return Refuse("Options::pairsBy is none of the structures of boomerang/pair.h");
    if (const char *why = notAhead.load(std::memory_order_relaxed))
        return Refuse(why);
    if (const char *why = WhyThisBox2DIsUnknown())
        return Refuse(why);
    if (const char *why = WhyRoundingIsAnother())
        return Refuse(why);
    if (const char *why = WhichHookIsNotCalled())
        return Refuse(why);
    MakeSettings(options);
    RegisterPolygonContacts();
    RegisterEdgeContacts();
    ActivateHooks();
    installed = true;
    if (options.mode == Mode::Verify)
        SayVerifiedAtExit();
    if (options.verbosity > 0 && ClaimAnnouncement())
        Announce(options);
    return true;
}

const char *WhyRefused() {
    const HoldsProcessLock lock;
    return refusedWhy;
}

bool InstallWasCalled() {
    const HoldsProcessLock lock;
    return called;
}

bool IsInstalled() {
    const HoldsProcessLock lock;
    return installed;
}

long ThisProcess() {
#if defined(_WIN32)
    return _getpid();
#else
    return getpid();
#endif
}

bool ClaimAnnouncement() {
    return !announced.exchange(true);
}

bool IsAnnounced() {
    return announced.load();
}

HoldsProcessLock::HoldsProcessLock() : m_held(processLock) {}

namespace internal {

void TrustListener(const void *table, int change) {
    const HoldsProcessLock lock;
    const void *const known = tableOfRecorders.load(std::memory_order_relaxed);
    if (known != nullptr && known != table)
        return;
    recorders += change;
    tableOfRecorders.store(recorders > 0 ? table : nullptr, std::memory_order_relaxed);
}

} // namespace internal

bool IsRecorder(const b2ContactListener &listener) {
    const void *table;
    std::memcpy(&table, static_cast<const void *>(&listener), sizeof table);
    return table == tableOfRecorders.load(std::memory_order_relaxed);
}

} // namespace bmr
