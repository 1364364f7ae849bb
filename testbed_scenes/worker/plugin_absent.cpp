// SPDX-License-Identifier: MIT
#include "worker/plugin.h"

namespace testbed {

void AddPluginOptions(CLI::App &, PluginOptions &) {}
void InstallPlugin(const PluginOptions &, bool) {}
void SetTraceStep(int) {}
void FinishTrace() {}
const char *PluginName() {
    return "stock";
}
nlohmann::json PluginStatistics() {
    return nullptr;
}
SlackFunction PluginSlack() {
    return nullptr;
}

} // namespace testbed
