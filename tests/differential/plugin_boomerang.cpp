// SPDX-License-Identifier: MIT
#include "plugin.h"

#include <boomerang/box2d.h>

namespace differential {

const char *Kind() {
    return "plugin";
}

bool InstallPlugin(const std::string &structure, bool prefilter) {
    for (int i = 0; i < BMR_STRUCTURE_COUNT; ++i) {
        bmr::Options options;
        options.structure = static_cast<bmr_structure>(i);
        options.prefilter = prefilter;
        // With one structure as games have it, with the others also where it does not pay.
        options.everywhere = structure != "free-direction";
        if (structure == bmr_structure_name(options.structure))
            return bmr::Install(options);
    }
    return false;
}

} // namespace differential
