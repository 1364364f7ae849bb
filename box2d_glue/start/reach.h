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

/// How Box2D's calls come by the hooks, in a few words; which hooks may answer there; and, where these are
/// not all, why: BOOMERANG_VERBOSE prints it. Not copied; until it is set there are no hooks, and
/// contacts alone are ours.
void SetWayOfHooks(const char *way, uint32_t hooks, const char *whyNotAll);
const char *WayOfHooks();
uint32_t HooksOfWay();
const char *WhyNotAllHooks();

namespace internal {

/// Does nothing, and is defined where a part of the interface is that nothing else asks for by a name of its
/// own. Where an archive with all of this (boomerang_accelerate) is linked behind libboomerang_box2d.so,
/// which has the interface, too, a linker would leave that part out, and its calls would go to the library.
void LinkOfConvexOutlines();
void LinkOfInspect();
void LinkOfOutlineShape();
void LinkOfSlack();
void LinkOfStatistics();

} // namespace internal

/// Is this thread stepping that world?
bool IsFindingReachedHooks();

} // namespace bmr

#endif
