// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_RENDER_COMMAND_H
#define BOOMERANG_TESTBED_RENDER_COMMAND_H

#include <cstdint>
#include <optional>
#include <string>

#include "picture/picture.h"
#include "workers.h"

namespace CLI {
class App;
}

namespace testbed {

struct RenderCommand {
    std::string scene;
    std::string recording; ///< a file instead of a scene
    std::optional<int64_t> step;
    std::string frames; ///< FIRST:LAST[:EVERY] instead of a step
    bool plugin = true;
    std::string output;
    std::string focus;
    int width = 1200;
    bool quiet = false;
    /// What to draw: none named means what Layers has by itself.
    Layers named = {false, false, false, false, false, false, false, false, false};
    bool all = false, bare = false;
    WorkerOptions worker;
};

/// The options that are render's own; the scene's and the plugin's are added as for other commands.
CLI::App *AddRender(CLI::App &app, RenderCommand &command);

/// Returns the exit code; errors are thrown (UsageError, WorkerError, std::runtime_error).
int Execute(const RenderCommand &command, const Workers &workers);

} // namespace testbed

#endif
