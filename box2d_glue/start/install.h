// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_INSTALL_H
#define BOOMERANG_GLUE_INSTALL_H

#include "boomerang/box2d_glue.h"

namespace bmr {

/// From here on Install returns false, and nothing of Box2D is touched. Says why, in one line on stderr. Not
/// copied. Returns false.
bool Refuse(const char *why);

/// Why this Box2D was left alone: what was said on stderr. nullptr where it was not.
const char *WhyRefused();

/// Was Install called, with any result? Then the library does not start by itself.
bool InstallWasCalled();

/// How Box2D's calls reach the hooks, in a few words; and why they do not, if that is known: then Install
/// refuses. Not copied.
void SetWay(const char *way, const char *whyNotAhead);
const char *TheWay();

} // namespace bmr

#endif
