// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_FUZZ_GLUE_PLUGIN_H
#define BOOMERANG_FUZZ_GLUE_PLUGIN_H

#include <box2d/box2d.h>

/// @file
/// What a script does that only a program with the plugin can; nothing at all in plugin_absent.cpp.

namespace fuzz {

/// A polygon of any size, as numbers.
struct AnySize {
    int kind; ///< regular, ellipse, rounded box, the first simplified
    int vertices;
    float width, height;
};

/// bmr::Invalidate.
void Invalidate(b2Body *body);
/// Asks for certified distances and proofs, which is not to change anything.
void Look(b2World &world);
/// Nullptr where there are no such polygons.
b2Fixture *CreateAnySize(b2Body *body, const b2FixtureDef &def, const AnySize &size);

} // namespace fuzz

#endif
