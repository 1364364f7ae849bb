// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_STEP_H
#define BOOMERANG_GLUE_STEP_H

#include <box2d/b2_settings.h>

class b2World;

namespace bmr {

/// b2World::Step: the passes in their order. The clock is read once between two of them; and forces are
/// cleared of the bodies that are awake alone, where it is known that no other has any.
void RunStep(b2World *world, float seconds, int32 velocityIterations, int32 positionIterations);

} // namespace bmr

#endif
