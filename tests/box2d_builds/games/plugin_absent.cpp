// SPDX-License-Identifier: MIT
#include "game.h"

void box2d_builds::InstallPlugin() {}
