// SPDX-License-Identifier: MIT
#include "worker/plugin.h"

namespace testbed {

void AddPluginOptions(CLI::App &, PluginOptions &) {}
void InstallPlugin(const PluginOptions &, bool, PluginObserver *) {}
const char *PluginName() {
    return "stock";
}
nlohmann::json PluginStatistics() {
    return nullptr;
}
ShownProof ShowProof(const b2Contact &) {
    return {};
}
std::array<std::vector<shown::Vec>, 2> ShowHulls(const b2Contact &, bool) {
    return {};
}

} // namespace testbed
