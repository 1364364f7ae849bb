// SPDX-License-Identifier: MIT
#include <boomerang/box2d.h>

#include "game.h"

void box2d_builds::InstallPlugin() {
    bmr::Install(); // as the README says; what it answers is not asked there either
}
