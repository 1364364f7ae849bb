// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_EVENTS_COMMAND_H
#define BOOMERANG_TESTBED_EVENTS_COMMAND_H

#include <string>
#include <vector>

#include "boomerang/kds.h"

namespace CLI {
class App;
}

namespace testbed {

/// `boomerang-testbed events`: counts the events of every structure along every motion.
struct EventsCommand {
    std::vector<std::string> motions;    ///< none: all
    std::vector<std::string> structures; ///< names or groups; none: "default"
    size_t n = 64;
    std::string shape = "ellipse:disc";
    std::string ratios = "8:2048";
    unsigned seeds = 3;
    std::string count = "events";
    bmr_kds_def def = bmr_default_kds_def();
    std::vector<std::string> polygons;
    std::string motion;
    std::string csv, json, trace;
    bool audit = false, noOptimum = false, quiet = false, list = false, box2d = false;
};

/// Adds the subcommand with its options, which write into `command`.
CLI::App *AddEvents(CLI::App &app, EventsCommand &command);

int Execute(const EventsCommand &command, const std::string &workersDirectory);

} // namespace testbed

#endif
