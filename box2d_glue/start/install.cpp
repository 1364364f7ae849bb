// SPDX-License-Identifier: MIT
#include "start/install.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "base/memory.h"
#include "base/rounding_mode.h"
#include "boomerang/box2d_glue.h"
#include "debug/statistics.h"
#include "debug/verify.h"
#include "glue/contacts/solid_contact.h"
#include "glue/proofs/hull_pair.h"
#include "glue/proofs/thresholds.h"
#include "start/settings.h"

namespace bmr {

Settings internal::settings;
std::atomic<internal::State> internal::state{State::Nothing};

Counts &GetCounts() {
    static Counts counts;
    return counts;
}

namespace {

std::atomic<const char *> theWay{"not ahead of Box2D"}, notAhead{nullptr};
std::atomic<bool> announced{false};
std::recursive_mutex processLock;
bool called = false;
bool installed = false;
bool refused = false;

/// Why Box2D's arithmetic is not the one that ours repeats, in a few words; nullptr where it is.
const char *WhyRoundingIsAnother() {
    if (!Box2DRoundsAsExact32())
        return "this Box2D fuses products (as compilers do for ARM64, and with -march=haswell), or has "
               "fast-math. Compile it with -ffp-contract=off -mno-fma and without, or use "
               "boomerang_accelerate()";
    return Box2DCollidesEdgesAsExact32() ? nullptr : "edges collide by other rules in this Box2D";
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
    refused = true;
    ClaimAnnouncement();
    std::fprintf(stderr, "boomerang: not at work, Box2D runs as it is: %s\n", why);
    return false;
}

void MakeSettings(const Options &options) {
    Settings made;
    made.options = options;
    made.options.statistics =
        options.statistics || options.onEvent != nullptr || AnswersAreObserved() || CountsAreWanted();
    made.pairDef = bmr_default_pair_def();
    made.everywhere = ReadEnvironment("BOOMERANG_EVERYWHERE") == "on";
    made.pairDef.structure =
        made.options.pairsBy == BMR_STRUCTURE_COUNT ? BMR_FREE_DIRECTION : made.options.pairsBy;
    made.pairDef.hysteresis = kHysteresis;
    made.compass = nullptr;
    if (made.options.pairsBy == BMR_LAZY_COMPASS) {
        bmr_compass *compass = nullptr;
        if (bmr_compass_create(kMostCompassVertices, nullptr, &compass) != BMR_OK)
            EndWithoutMemory();
        made.compass = compass; // for as long as the process lives: hulls of every world point to it
    }
    internal::settings = made;
}

bool Install(const Options &given) {
    const HoldsProcessLock lock;
    called = true;
    if (installed || refused)
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
    internal::state = internal::State::PassesRun;
    installed = true;
    if (options.mode == Mode::Verify)
        CallAtEnd(SayVerified);
    if (options.verbosity > 0 && ClaimAnnouncement())
        std::fprintf(stderr, "boomerang: %s; %s %s\n", NameOf(options.mode), TheWay(), VersionOfBox2D());
    return true;
}

bool InstallWasCalled() {
    const HoldsProcessLock lock;
    return called;
}

bool IsInstalled() {
    const HoldsProcessLock lock;
    return installed;
}

bool ClaimAnnouncement() {
    return !announced.exchange(true);
}

bool IsAnnounced() {
    return announced.load();
}

HoldsProcessLock::HoldsProcessLock() : m_held(processLock) {}

// What the environment says.

namespace {

/// Variables, a bit each.
enum Variable : unsigned { kMode = 1, kStructure = 2, kVerbose = 4 };

/// One line for a value that is not understood, once for a process.
void Complain(Variable variable, const char *name, std::string_view value, const char *known,
              Complaints complaints = Complaints::Said) {
    static std::atomic<unsigned> complained{0};
    if (!value.empty() && complaints == Complaints::Said && (complained.fetch_or(variable) & variable) == 0)
        std::fprintf(stderr, "boomerang: %s=%.*s is not understood, so it does nothing; known: %s\n", name,
                     static_cast<int>(value.size()), value.data(), known);
}

std::optional<bool> VerbosityOfEnvironment(Complaints complaints) {
    const std::string_view value = ReadEnvironment("BOOMERANG_VERBOSE");
    if (value == "0" || value == "1")
        return value == "1";
    Complain(kVerbose, "BOOMERANG_VERBOSE", value, "0, 1", complaints);
    return std::nullopt;
}

std::optional<bmr_structure> StructureOfEnvironment() {
    const std::string_view value = ReadEnvironment("BOOMERANG_PAIRS_BY");
    for (int i = 0; i < BMR_STRUCTURE_COUNT; ++i)
        if (value == bmr_structure_name(static_cast<bmr_structure>(i)))
            return static_cast<bmr_structure>(i);
    Complain(kStructure, "BOOMERANG_PAIRS_BY", value, "bmr_structure_name of boomerang/pair.h");
    return std::nullopt;
}

} // namespace

std::string_view ReadEnvironment(const char *name) {
#if defined(__GLIBC__)
    const char *value = secure_getenv(name);
#else
    const char *value = std::getenv(name);
#endif
    return value != nullptr ? value : "";
}

const char *NameOf(Mode mode) {
    switch (mode) {
    case Mode::Off:
        return "off";
    case Mode::Verify:
        return "verify";
    case Mode::On:
        break;
    }
    return "on";
}

std::optional<Mode> ModeOfEnvironment(Complaints complaints) {
    const std::string_view value = ReadEnvironment("BOOMERANG");
    if (value == "0" || value == "1")
        return value == "1" ? Mode::On : Mode::Off;
    for (const Mode mode : {Mode::On, Mode::Off, Mode::Verify})
        if (value == NameOf(mode))
            return mode;
    Complain(kMode, "BOOMERANG", value, "on, off, verify", complaints);
    return std::nullopt;
}

bool IsVerbose() {
    return VerbosityOfEnvironment(Complaints::Held).value_or(false);
}

Options WithEnvironment(const Options &options) {
    Options made = options;
    made.mode = ModeOfEnvironment().value_or(options.mode);
    if (const auto structure = StructureOfEnvironment())
        made.pairsBy = *structure;
    if (const auto verbose = VerbosityOfEnvironment(Complaints::Said))
        made.verbosity = *verbose;
    return made;
}

} // namespace bmr
