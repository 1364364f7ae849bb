// SPDX-License-Identifier: MIT
// b2World::~b2World, by its mangled names: a destructor that C++ would let us define ends the members, too,
// which Box2D's own is to do.
#include <box2d/b2_world.h>

#include "boomerang/box2d_glue.h"
#include "reach/stock.h"

namespace bmr::hooks {

namespace {

Real<void(b2World *)> realEndWorld("_ZN7b2WorldD1Ev");
Real<void(b2World *)> realEndBaseWorld("_ZN7b2WorldD2Ev");

} // namespace

BMR_BOX2D_API void EndWorld(b2World *world) asm("_ZN7b2WorldD1Ev");
BMR_BOX2D_API void EndBaseWorld(b2World *world) asm("_ZN7b2WorldD2Ev");

void EndWorld(b2World *world) {
    NoteWorldEnds(world);
    realEndWorld(world);
}

void EndBaseWorld(b2World *world) {
    NoteWorldEnds(world);
    realEndBaseWorld(world);
}

} // namespace bmr::hooks

BMR_FOR_LOADERS("_ZN7b2WorldD1Ev");
BMR_FOR_LOADERS("_ZN7b2WorldD2Ev");
