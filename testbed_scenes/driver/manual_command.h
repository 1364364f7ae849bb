// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_MANUAL_COMMAND_H
#define BOOMERANG_TESTBED_MANUAL_COMMAND_H

#include <string>

namespace CLI {
class App;
}

namespace testbed {

/// `boomerang-testbed man` and `boomerang-testbed completion`: what is installed beside the program.
struct ManualCommand {
    std::string shell;  ///< empty: the manual page
    std::string output; ///< a file; empty: standard output
};

/// Adds both subcommands.
void AddManual(CLI::App &app, ManualCommand &command);
/// Whether one of them was asked for.
bool WantsManual(const CLI::App &app);

/// The scenes in a completion are those of the workers.
int Execute(const ManualCommand &command, const CLI::App &app, const std::string &workersDirectory);

} // namespace testbed

#endif
