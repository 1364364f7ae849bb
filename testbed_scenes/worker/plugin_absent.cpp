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
std::array<std::vector<shown::Vec>, 2> ShowHulls(const b2Contact &, bool) {
    return {};
}

} // namespace testbed
