// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_WORLD_COMMAND_H
#define BOOMERANG_TESTBED_WORLD_COMMAND_H

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "worlds/figures.h"

namespace CLI {
class App;
}

namespace testbed {

class Workers;

/// `boomerang-testbed world`: runs a kinetic world of many polygons and tells what it cost.
struct WorldCommand {
    std::string scene = "gas";
    // What is not told is the scene's own.
    std::optional<size_t> bodies;
    std::optional<std::string> shape, vertices, boundary, answer, zeno, structure;
    std::optional<double> sizes, density, speed, seconds, zenoSpeed;
    uint64_t seed = 1;
    bool allPairs = false, check = false, audit = false, quiet = false, list = false;
    std::string growth; ///< N1,N2,..
    std::string json, csv, record;
    double rate = 30.0; ///< frames of a recording for each unit of time
};

/// Adds the subcommand with its options, which write into `command`.
CLI::App *AddWorld(CLI::App &app, WorldCommand &command);
/// What the command asks for. Throws UsageError.
WorldChoice ChoiceFor(const WorldCommand &command);
/// Returns the exit code: 1 if a check failed.
int Execute(const WorldCommand &command);

/// The same density with each of these numbers of bodies, as a table: what grows, and what does not.
std::vector<WorldFigures> MeasureGrowth(const WorldCommand &command);

} // namespace testbed

#endif
