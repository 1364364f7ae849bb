// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_REPORT_COMMAND_H
#define BOOMERANG_TESTBED_REPORT_COMMAND_H

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace testbed {

/// `boomerang-testbed report`: measured numbers, from files or measured now, as one page.
struct ReportCommand {
    std::vector<std::string> scenes; ///< none: all
    std::vector<std::string> json, costs;
    std::vector<std::string> parts; ///< of what is measured now; none: all
    std::optional<int> steps;
    int repeat = 3;
    std::string output;  ///< "-": standard output
    std::string figures; ///< a directory for the plots as files
    std::string title = "Boomerang: measured";
    bool quiet = false;
};

/// Adds the subcommand with its options, which write into `command`.
CLI::App *AddReport(CLI::App &app, ReportCommand &command);

int Execute(const ReportCommand &command, const std::string &workersDirectory);

} // namespace testbed

#endif
