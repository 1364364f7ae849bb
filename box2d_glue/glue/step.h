// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_STEP_H
#define BOOMERANG_GLUE_STEP_H

#include <box2d/b2_settings.h>

class b2World;

namespace bmr {

/// Is a step that begins ours, and with it each of its passes? It is Box2D's if the thread does not round to
/// nearest, or is about to end. Then the world leaves its table; and so does one that is stepped in the midst
/// of its own step, or as a contact of its ends.
bool StepIsOurs(const b2World &world);

/// b2World::Step of a step that is ours: the passes in their order. The clock is read once between two of
/// them; and forces are cleared of the bodies that are awake alone, where it is known that no other has any.
void RunStep(b2World *world, float seconds, int32 velocityIterations, int32 positionIterations);

} // namespace bmr

#endif
