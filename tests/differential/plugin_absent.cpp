// SPDX-License-Identifier: MIT
#include "plugin.h"

namespace differential {

const char *Kind() {
    return "stock";
}

bool InstallPlugin(const std::string &, bool, bool) {
    return false;
}

} // namespace differential
