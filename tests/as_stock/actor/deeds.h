// SPDX-License-Identifier: MIT
#ifndef AS_STOCK_ACTOR_DEEDS_H
#define AS_STOCK_ACTOR_DEEDS_H

#include "world.h"

/// @file
/// What listeners and filters do alike: to a body or a fixture, as a number says.

namespace actor {

b2Body *CreateBox(World &world, b2Vec2 at, float angle, b2BodyType type);
/// A polygon: another radius, smaller, or scaled.
void Edit(b2Fixture *fixture, uint32_t mixed);
void SetFilterData(b2Fixture *fixture, uint32_t mixed);
void ThrowBody(b2Body *body, uint32_t mixed);

} // namespace actor

#endif
