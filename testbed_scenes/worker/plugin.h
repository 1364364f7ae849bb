// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_PLUGIN_H
#define BOOMERANG_TESTBED_PLUGIN_H

#include <string>

#include <nlohmann/json.hpp>

#include "outline.h"

/// @file
/// All that the two workers do differently. boomerang-scene links plugin_absent.cpp, in which nothing
/// happens; boomerang-scene-plugin links plugin_boomerang.cpp.

namespace CLI {
class App;
}

namespace testbed {

struct PluginOptions {
    std::string structure = "free-direction";
    std::string prefilter = "on";
    std::string trace; ///< a file's name, or empty
};

void AddPluginOptions(CLI::App &app, PluginOptions &options);

/// Before the first world. Throws if the plugin will not install, or the trace cannot be written.
void InstallPlugin(const PluginOptions &options, bool count);
/// The step that events belong to from now on.
void SetTraceStep(int step);
/// Closes the trace; throws if not all of it could be written.
void FinishTrace();

/// "stock" or "plugin".
const char *PluginName();
/// What the plugin counted, or null.
nlohmann::json PluginStatistics();
/// Null without the plugin.
SlackFunction PluginSlack();

} // namespace testbed

#endif
