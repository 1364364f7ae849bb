// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_DIFFERENTIAL_PLUGIN_H
#define BOOMERANG_TEST_DIFFERENTIAL_PLUGIN_H

#include <string>

class b2Body;

/// @file
/// All that the two programs do differently.

namespace differential {

/// "stock" or "plugin".
const char *Kind();
/// False where there is no such structure, or where this program is not the plugin's.
bool InstallPlugin(const std::string &structure, bool prefilter);
/// What the plugin must be told where vertices were edited in place.
void ShapeWasEdited(b2Body *body);

} // namespace differential

#endif
