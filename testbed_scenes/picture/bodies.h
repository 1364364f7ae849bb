// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_PICTURE_BODIES_H
#define BOOMERANG_TESTBED_PICTURE_BODIES_H

#include <deque>
#include <functional>
#include <map>
#include <string>

#include "picture/world_view.h"

/// @file
/// What is in a world whether or not anything is proved of it. `unit` is one point of a picture 1200 wide.

namespace testbed {

/// "dynamic", "sleeping", "kinematic", "static", "sensor" or "disabled", and its colour.
std::string StateOf(const shown::Body &body, const shown::Fixture &fixture);
Colour ColourOfState(const std::string &state);

/// All bodies, those that stand still first. Those that `isDim` are fainter.
void DrawBodies(Canvas &canvas, const WorldView &world, double unit, const std::function<bool(int)> &isDim);
void DrawJoints(Canvas &canvas, const WorldView &world, double unit);
/// Lines through the places of each body, older ones fainter. A step longer than `longest` (a periodic box
/// has taken the body to its other side) is left out.
void DrawTrails(Canvas &canvas, const std::map<int, std::deque<bmr_vec2>> &trails, double longest,
                double unit);
/// The boxes of the broad phase.
void DrawBoxes(Canvas &canvas, const WorldView &world, double unit);
/// Where what goes out on one side comes in on the other.
void DrawPeriodicBox(Canvas &canvas, const Rectangle &box, double unit);
/// Points of contact, and the normal, longer for a larger impulse.
void DrawContacts(Canvas &canvas, const WorldView &world, double unit);

} // namespace testbed

#endif
