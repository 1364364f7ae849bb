// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_REACH_H
#define BOOMERANG_GLUE_REACH_H

#include <cstdint>

namespace bmr {

/// The hooks (bits of Options::hooks) that calls of this process's Box2D come by: a small world is stepped
/// once, with all hooks off, and each says whether it was called. Where the library is behind Box2D, or Box2D
/// is inside the program, or calls its own functions without the loader, some or all are not. The manifold of
/// polygons that touch is always among them: Box2D's register of contacts leads to it. For whoever announces
/// what is at work, before Install makes its settings, on a Box2D that is known; about 0.1 ms. None is
/// reported where there is no memory to find out.
uint32_t FindReachedHooks();

/// How Box2D's calls come by the hooks, in a few words, for whoever is told what is at work. Not copied;
/// until it is set there are no hooks, and contacts alone are ours.
void SetWayOfHooks(const char *way);
const char *WayOfHooks();

/// Is this thread stepping that world?
bool IsFindingReachedHooks();

} // namespace bmr

#endif
