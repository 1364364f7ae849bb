// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_DIFFERENTIAL_PLUGIN_H
#define BOOMERANG_TEST_DIFFERENTIAL_PLUGIN_H

#include <string>

/// @file
/// All that the two programs do differently.

namespace differential {

/// "stock" or "plugin".
const char *Kind();
/// `told`: somebody listens to its events. False where there is no such structure, or where this program is
/// not the plugin's.
bool InstallPlugin(const std::string &structure, bool prefilter, bool told);

} // namespace differential

#endif
