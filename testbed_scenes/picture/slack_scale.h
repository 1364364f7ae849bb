// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_SLACK_SCALE_H
#define BOOMERANG_TESTBED_SLACK_SCALE_H

#include <string>

#include "drawing/canvas.h"

namespace testbed {

/// Slack as colour, logarithmic, the same in all pictures so that they compare: less than twice Box2D's slop
/// is about to touch, more than the largest bodies' size is far away.
constexpr double kLeastSlack = 0.01, kMostSlack = 10.0;
/// Bright yellow for little, blue for much: told apart by brightness too, whatever one's sight.
Colour ColourOfSlack(double slack);
/// "0.124 m"; of a kinetic world, whose lengths have no unit, "0.124".
std::string LengthText(double length, bool kinetic);

} // namespace testbed

#endif
