// SPDX-License-Identifier: MIT
#ifndef AS_STOCK_ACTOR_PLUGIN_H
#define AS_STOCK_ACTOR_PLUGIN_H

#include <box2d/box2d.h>

/// @file
/// What only a program with the plugin can do; nothing at all in plugin_absent.cpp. And what poison.cpp says.

namespace actor {

/// A polygon of any size, as numbers.
struct AnySize {
    int kind; ///< regular, ellipse, rounded box, the first simplified
    int vertices;
    float width, height;
};

/// bmr::Install, as games do it; or as BMR_ACTOR_INSTALL says: observed (somebody listens to its events, and
/// checks that their certificates hold). False where there is no plugin.
bool Install();
/// Asks for certified distances and proofs, which is not to change anything.
void InspectAll(b2World &world);
/// Does nothing where there are no such polygons.
void CreateAnySize(b2Body *body, const b2FixtureDef &def, const AnySize &size);
/// An outline with a notch and a hole.
void CreateOutline(b2Body *body, const b2FixtureDef &def, float width, float depth);

/// Of poison.cpp: the block that was last given back to Box2D's allocator and is still free, or nullptr.
const void *LastFreed();

} // namespace actor

#endif
