// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_SHAPES_COMMAND_H
#define BOOMERANG_TESTBED_SHAPES_COMMAND_H

#include <string>

#include "shapes_comparison.h"

namespace CLI {
class App;
}

namespace testbed {

/// boomerang-testbed compare-shapes.
struct ShapesCommand {
    std::string scene;
    ShapesOptions options;
    std::string json, csv, curve;
    bool quiet = false;
};

/// The options that are its own; the scene's and the plugin's are added as for other commands.
CLI::App *AddCompareShapes(CLI::App &app, ShapesCommand &command);

/// Returns the exit code; errors are thrown (UsageError, WorkerError).
int Execute(ShapesCommand command, const Workers &workers);

} // namespace testbed

#endif
