// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_ENVIRONMENT_H
#define BOOMERANG_GLUE_ENVIRONMENT_H

#include <optional>
#include <string_view>

#include "boomerang/box2d_glue.h"

/// @file
/// The environment variables that set the plugin without rebuilding the program:
///
///     BOOMERANG=on|off|verify    or 1|0, for the first two
///     BOOMERANG_VERBOSE=0|1
///
/// They win over the options that the program passes. A value that is not understood is ignored, and one line
/// on stderr says so, once for a process. Nothing is read in programs that run with another user's rights
/// (setuid).
///
/// Three more are for the project's own tests and its testbed; pages for games do not have them:
///
///     BOOMERANG_PAIRS_BY=free-direction|...        Options::pairsBy, by bmr_structure_name
///     BOOMERANG_COUNTS=FILE                        what was counted, when the process ends
///     BOOMERANG_EVERYWHERE=on|off                  budgets of motion also where they cost more than they
///     save

namespace bmr {

/// The value, empty where there is none; it ends with a zero. Empty in programs that run with another user's
/// rights.
std::string_view ReadEnvironment(const char *name);

/// The word of Options::mode.
const char *NameOf(Mode mode);

/// BOOMERANG, if it is there and understood.
std::optional<Mode> ModeOfEnvironment();

/// `options`, outweighed by the environment.
Options WithEnvironment(const Options &options);

/// BOOMERANG_PAIRS_BY, if it is there and understood.
std::optional<bmr_structure> StructureOfEnvironment();
/// BOOMERANG_EVERYWHERE.
bool EverywhereOfEnvironment();

/// As long as one lives, this thread says nothing of values that are not understood: for code that only
/// looks.
class HeldComplaints {
public:
    HeldComplaints();
    ~HeldComplaints();
    HeldComplaints(const HeldComplaints &) = delete;
    HeldComplaints &operator=(const HeldComplaints &) = delete;
};

} // namespace bmr

#endif
