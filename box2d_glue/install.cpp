// SPDX-License-Identifier: MIT
#include <mutex>

#include "boomerang/box2d_glue.h"
#include "polygon_contact.h"
#include "settings.h"

namespace bmr {

namespace {
std::mutex installing;
bool installed = false;
} // namespace

bool Install(const Options &options) {
    const std::lock_guard<std::mutex> lock(installing);
    if (installed || bmr_structure_name(options.structure) == nullptr || !MakeSettings(options))
        return false;
    PolygonContact::Register();
    installed = true;
    return true;
}

bool IsInstalled() {
    const std::lock_guard<std::mutex> lock(installing);
    return installed;
}

} // namespace bmr
