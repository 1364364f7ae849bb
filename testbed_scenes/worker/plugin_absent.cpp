// SPDX-License-Identifier: MIT
#include "worker/plugin.h"

namespace testbed {

void InstallPlugin(const std::string &, bool, PluginObserver *) {}
const char *PluginName() {
    return "stock";
}
nlohmann::json PluginStatistics() {
    return nullptr;
}
ShownProof ShowProof(const b2Contact &) {
    return {};
}
} // namespace testbed
