// SPDX-License-Identifier: MIT
#include "start/settings.h"

#include <algorithm>
#include <cstdarg>
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

/// Variables that have been complained about, a bit each.
enum Variable : unsigned { kMode = 1, kStructure = 2, kVerbose = 4, kEverywhere = 8 };

thread_local bool complaintsHeld = false;

/// One line, made of pieces as it is said: no memory is asked for, and none can be missing, in the middle of
/// a game's step.
class Complaint {
public:
    Complaint(Variable variable, const char *name, std::string_view value)
        : m_said(!complaintsHeld && (complained.fetch_or(variable) & variable) == 0) {
        if (m_said)
            Add("boomerang: %s=%.*s is not understood, so it does nothing; known: ", name,
                static_cast<int>(value.size()), value.data());
    }
    ~Complaint() {
        if (m_said)
            std::fprintf(stderr, "%s\n", m_line);
    }
    Complaint(const Complaint &) = delete;
    Complaint &operator=(const Complaint &) = delete;

    Complaint &Word(const char *before, const char *word) {
        if (m_said)
            Add("%s%s", before, word);
        return *this;
    }

private:
    BMR_FORMAT(2, 3) void Add(const char *format, ...) {
        va_list arguments;
        va_start(arguments, format);
        // NOLINTNEXTLINE(clang-analyzer-valist.Uninitialized): va_start is one line above
        const int added = std::vsnprintf(m_line + m_length, sizeof m_line - m_length, format, arguments);
        va_end(arguments);
        m_length = std::min(m_length + static_cast<size_t>(std::max(added, 0)), sizeof m_line - 1);
    }

    static std::atomic<unsigned> complained;
    bool m_said;
    char m_line[1024] = ""; ///< a value that is longer is cut
    size_t m_length = 0;
};
std::atomic<unsigned> Complaint::complained{0};

/// The place of the value among two words, or nothing where it is neither.
std::optional<bool> ChoiceOfEnvironment(Variable variable, const char *name, const char *no,
                                        const char *yes) {
    const std::string_view value = ReadEnvironment(name);
    if (value.empty())
        return std::nullopt;
    if (value == no || value == yes)
        return value == yes;
    Complaint(variable, name, value).Word("", no).Word(", ", yes);
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

HeldComplaints::HeldComplaints() {
    complaintsHeld = true;
}

HeldComplaints::~HeldComplaints() {
    complaintsHeld = false;
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

std::optional<Mode> ModeOfEnvironment() {
    const std::string_view value = ReadEnvironment("BOOMERANG");
    if (value.empty())
        return std::nullopt;
    if (value == "0" || value == "1")
        return value == "1" ? Mode::On : Mode::Off;
    for (const Mode mode : {Mode::On, Mode::Off, Mode::Verify})
        if (value == NameOf(mode))
            return mode;
    Complaint(kMode, "BOOMERANG", value).Word("", "on, off, verify");
    return std::nullopt;
}

std::optional<bmr_structure> StructureOfEnvironment() {
    const std::string_view value = ReadEnvironment("BOOMERANG_PAIRS_BY");
    if (value.empty())
        return std::nullopt;
    for (int i = 0; i < BMR_STRUCTURE_COUNT; ++i)
        if (value == bmr_structure_name(static_cast<bmr_structure>(i)))
            return static_cast<bmr_structure>(i);
    Complaint complaint(kStructure, "BOOMERANG_PAIRS_BY", value);
    for (int i = 0; i < BMR_STRUCTURE_COUNT; ++i)
        complaint.Word(i == 0 ? "" : ", ", bmr_structure_name(static_cast<bmr_structure>(i)));
    return std::nullopt;
}

bool EverywhereOfEnvironment() {
    return ChoiceOfEnvironment(kEverywhere, "BOOMERANG_EVERYWHERE", "off", "on").value_or(false);
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
