// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_PICTURE_BODIES_H
#define BOOMERANG_TESTBED_PICTURE_BODIES_H

#include <functional>
#include <string>

#include "picture/world_view.h"

/// @file
/// What is in a world whether or not anything is proved of it. `unit` is one point of a picture 1200 wide.

namespace testbed {

/// "dynamic", "sleeping", "kinematic", "static", "sensor" or "disabled", and its colour.
std::string StateOf(const recording::Body &body, const recording::Fixture &fixture);
Colour ColourOfState(const std::string &state);

/// All bodies, those that stand still first. Those that `isDim` are fainter.
void DrawBodies(Canvas &canvas, const WorldView &world, double unit, const std::function<bool(int)> &isDim);
void DrawJoints(Canvas &canvas, const WorldView &world, double unit);
/// The boxes of the broad phase.
void DrawBoxes(Canvas &canvas, const WorldView &world, double unit);
/// Points of contact, and the normal, longer for a larger impulse.
void DrawContacts(Canvas &canvas, const WorldView &world, double unit);

} // namespace testbed

#endif
