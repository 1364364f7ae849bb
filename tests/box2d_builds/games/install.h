// SPDX-License-Identifier: MIT
#ifndef BOX2D_BUILDS_INSTALL_H
#define BOX2D_BUILDS_INSTALL_H

/// All that a game does differently which knows of the plugin; called before the first step.
void InstallPlugin();

#endif
