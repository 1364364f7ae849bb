// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_STEP_H
#define BOOMERANG_GLUE_STEP_H

#include <box2d/b2_settings.h>

class b2World;
struct b2TimeStep;

namespace bmr {

/// Is a step that begins ours, and with it each of its passes? Else Box2D makes the step, and the hook of
/// each pass asks whose that pass is.
bool StepIsOurs();

/// b2World::Step of a step that is ours: the passes in their order. The clock is read once between two of
/// them; and forces are cleared of the bodies that are awake alone, where it is known that no other has any.
void RunStep(b2World *world, float seconds, int32 velocityIterations, int32 positionIterations);

/// b2World::Solve and SolveTOI. `box2d`: Box2D's own, for a thread that does not round to nearest.
using PassOfBox2D = void (*)(b2World *world, const b2TimeStep &step);
void Solve(b2World *world, const b2TimeStep &step, PassOfBox2D box2d);
void SolveTOI(b2World *world, const b2TimeStep &step, PassOfBox2D box2d);

} // namespace bmr

#endif
