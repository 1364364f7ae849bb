// SPDX-License-Identifier: MIT
#include "install.h"

void InstallPlugin() {}
