// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_REACH_H
#define BOOMERANG_GLUE_REACH_H

#include <cstdint>

namespace bmr {

/// Names a hook that Box2D does not call, in a few words; nullptr where it calls them all. A small world of
/// this process's Box2D is stepped once, and each hook notes that it was called. Where one is not, Box2D is
/// inside the program, or was built so that it calls its own functions without the loader. Before Install
/// makes its settings, on a Box2D that is known; about 0.1 ms. The answer lives until the next call.
const char *WhichHookIsNotCalled();

/// How Box2D's calls reach the hooks, in a few words; and why they do not, if that is known. Not copied.
void SetWay(const char *way, const char *whyNotAhead);
const char *TheWay();
const char *WhyNotAhead();

/// Is this thread stepping that small world?
bool IsFindingReach();

} // namespace bmr

#endif
