// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_INSTALL_H
#define BOOMERANG_GLUE_INSTALL_H

#include "boomerang/box2d_glue.h"

namespace bmr {

/// Install, by a name that no other library's can take: where this is in a shared Box2D, and
/// libboomerang_box2d.so is preloaded all the same, `Install` is the latter's.
bool InstallHere(const Options &options);

/// Why this Box2D was left alone: what was said on stderr. nullptr where it was not.
const char *WhyRefused();

/// Was Install called, with any result? Then the library does not start by itself.
bool InstallWasCalled();

} // namespace bmr

#endif
