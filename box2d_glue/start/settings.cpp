// SPDX-License-Identifier: MIT
#include "start/settings.h"

#include <cstdio>
#include <cstdlib>

#include "base/memory.h"
#include "debug/exit_line.h"
#include "debug/statistics.h"
#include "glue/proofs/hull_pair.h"
#include "glue/proofs/thresholds.h"

namespace bmr {

Settings internal::settings;
std::atomic<internal::State> internal::state{State::Nothing};

Counts &GetCounts() {
    static Counts counts;
    return counts;
}

void MakeSettings(const Options &options) {
    Settings made;
    made.made = true;
    made.options = options;
    made.options.statistics =
        options.statistics || options.onEvent != nullptr || AnswersAreObserved() || CountsAreWanted();
    made.pairDef = bmr_default_pair_def();
    made.everywhere = EverywhereOfEnvironment();
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

void ActivateHooks() {
    internal::state = internal::State::PassesRun;
}

namespace {

/// Variables, a bit each.
enum Variable : unsigned { kMode = 1, kStructure = 2, kVerbose = 4, kEverywhere = 8 };

/// One line for a value that is not understood, once for a process: the beginning of it. True where it is to
/// be ended by what is known.
bool BeginComplaint(Variable variable, const char *name, std::string_view value, Complaints complaints) {
    static std::atomic<unsigned> complained{0};
    if (complaints == Complaints::Held || (complained.fetch_or(variable) & variable) != 0)
        return false;
    std::fprintf(stderr, "boomerang: %s=%.*s is not understood, so it does nothing; known: ", name,
                 static_cast<int>(value.size()), value.data());
    return true;
}

/// The place of the value among two words, or nothing where it is neither.
std::optional<bool> ChoiceOfEnvironment(Variable variable, const char *name, const char *no, const char *yes,
                                        Complaints complaints = Complaints::Said) {
    const std::string_view value = ReadEnvironment(name);
    if (value == no || value == yes)
        return value == yes;
    if (!value.empty() && BeginComplaint(variable, name, value, complaints))
        std::fprintf(stderr, "%s, %s\n", no, yes);
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
    if (!value.empty() && BeginComplaint(kMode, "BOOMERANG", value, complaints))
        std::fprintf(stderr, "on, off, verify\n");
    return std::nullopt;
}

std::optional<bmr_structure> StructureOfEnvironment() {
    const std::string_view value = ReadEnvironment("BOOMERANG_PAIRS_BY");
    if (value.empty())
        return std::nullopt;
    for (int i = 0; i < BMR_STRUCTURE_COUNT; ++i)
        if (value == bmr_structure_name(static_cast<bmr_structure>(i)))
            return static_cast<bmr_structure>(i);
    if (!BeginComplaint(kStructure, "BOOMERANG_PAIRS_BY", value, Complaints::Said))
        return std::nullopt;
    for (int i = 0; i < BMR_STRUCTURE_COUNT; ++i)
        std::fprintf(stderr, "%s%s", i == 0 ? "" : ", ", bmr_structure_name(static_cast<bmr_structure>(i)));
    std::fprintf(stderr, "\n");
    return std::nullopt;
}

bool EverywhereOfEnvironment() {
    return ChoiceOfEnvironment(kEverywhere, "BOOMERANG_EVERYWHERE", "off", "on").value_or(false);
}

bool IsVerbose() {
    return ChoiceOfEnvironment(kVerbose, "BOOMERANG_VERBOSE", "0", "1", Complaints::Held).value_or(false);
}

Options WithEnvironment(const Options &options) {
    Options made = options;
    made.mode = ModeOfEnvironment().value_or(options.mode);
    if (const auto structure = StructureOfEnvironment())
        made.pairsBy = *structure;
    if (const auto verbose = ChoiceOfEnvironment(kVerbose, "BOOMERANG_VERBOSE", "0", "1"))
        made.verbosity = *verbose;
    return made;
}

} // namespace bmr
