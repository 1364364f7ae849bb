// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_PLUGIN_LIBRARY_CHECK_H
#define BOOMERANG_PLUGIN_LIBRARY_CHECK_H

namespace bmr {

/// Whether a b2World::Step of this process is this library's, as far as dynamic linking goes.
bool StepsComeByHere();

/// Why the libbox2d that was loaded must be left alone, or nullptr: a symbol of box2d_symbols.inc is not
/// there, or not all are in one and the same library (some are the program's own, or another version's), or
/// data has another size. Calls nothing of Box2D's. The answer lives until the next call.
const char *WhyLibraryIsUnknown();

} // namespace bmr

#endif
