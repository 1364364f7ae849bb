// SPDX-License-Identifier: MIT
// A game that knows of the plugin, and one that does not.
#if defined(WITH_PLUGIN)
#    include <boomerang/box2d.h>
#endif

void InstallPlugin();

void InstallPlugin() {
#if defined(WITH_PLUGIN)
    bmr::Install(); // as the README says; what it answers is not asked there either
#endif
}
