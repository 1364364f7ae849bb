// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_REPLAY_COMMAND_H
#define BOOMERANG_TESTBED_REPLAY_COMMAND_H

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "workers.h"

namespace CLI {
class App;
}

namespace testbed {

struct ReplayCommand {
    std::string scene;
    std::string recording;             ///< a file instead of a scene
    std::vector<std::string> polygons; ///< or files of one's own pair, A's and B's (one: both alike),
    std::string motion;                ///< and of its motion
    std::optional<int64_t> steps;
    std::string output;
    bool quiet = false;
    WorkerOptions worker;
};

/// The options that are replay's own; the scene's and the plugin's are added as for other commands.
CLI::App *AddReplay(CLI::App &app, ReplayCommand &command);

/// What --structure takes: the plugin's structures, and for a pair of one's own those of the paper.
std::vector<std::string> ReplayStructures();

/// Runs the scene with the plugin, then on stock Box2D, and writes the page. Returns the exit code: a
/// difference between the two runs is one. Errors are thrown (UsageError, WorkerError, std::runtime_error).
int Execute(const ReplayCommand &command, const Workers &workers);

} // namespace testbed

#endif
