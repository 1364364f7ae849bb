// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_OUTLINE_COMMAND_H
#define BOOMERANG_TESTBED_OUTLINE_COMMAND_H

#include <string>

namespace CLI {
class App;
}

namespace testbed {

/// boomerang-testbed outline: cuts an outline into convex pieces, as bmr::OutlineShape does, and draws them.
struct OutlineCommand {
    /// A point `x y` (or `x,y`) a line; an empty line between rings, the outer one first; # begins a remark.
    std::string file;
    std::string picture, json; ///< empty: none
    double tolerance = 0.0;
    bool quiet = false;
};

CLI::App *AddOutline(CLI::App &app, OutlineCommand &command);

/// Returns the exit code; errors are thrown (UsageError).
int Execute(const OutlineCommand &command);

} // namespace testbed

#endif
