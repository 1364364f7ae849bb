// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_PLUGIN_OWN_WORLDS_H
#define BOOMERANG_TEST_PLUGIN_OWN_WORLDS_H

#include <string>
#include <vector>

namespace surprises {

/// Scenarios that need worlds of their own: more than one, one in another's place, or thousands of steps.
const std::vector<std::string> &OwnWorlds();

/// Plays one of these and prints a line or more; false where there is none of that name.
bool PlayOwnWorld(const std::string &name);

} // namespace surprises

#endif
