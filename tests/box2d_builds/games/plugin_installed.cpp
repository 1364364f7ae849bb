// SPDX-License-Identifier: MIT
#include <boomerang/box2d.h>

#include "install.h"

void InstallPlugin() {
    bmr::Install(); // as the README says; what it answers is not asked there either
}
