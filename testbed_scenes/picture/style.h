// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_PICTURE_STYLE_H
#define BOOMERANG_TESTBED_PICTURE_STYLE_H

#include <string>

#include "drawing/canvas.h"

/// @file
/// Colours of a world's picture. Widths and sizes are in points of a picture 1200 wide.

namespace testbed::style {

// Those of Box2D's testbed (b2World::DebugDraw and the testbed's own draw.cpp).
constexpr Colour kBackground = {0.15, 0.15, 0.16};
constexpr Colour kStrip = {0.1, 0.1, 0.11};
constexpr Colour kDynamic = {0.9, 0.7, 0.7};
constexpr Colour kSleeping = {0.6, 0.6, 0.6};
constexpr Colour kKinematic = {0.5, 0.5, 0.9};
constexpr Colour kStatic = {0.5, 0.9, 0.5};
constexpr Colour kDisabled = {0.5, 0.5, 0.3};
constexpr Colour kJoint = {0.5, 0.8, 0.8};
constexpr Colour kBox = {0.9, 0.3, 0.9};
// Ours: what stands out against those.
constexpr Colour kSensor = {0.85, 0.8, 0.45};
constexpr Colour kCertificate = {0.25, 0.85, 1.0};
constexpr Colour kHull = {0.93, 0.93, 0.93};
constexpr Colour kEnvelope = {0.72, 0.6, 1.0};
constexpr Colour kHandedOver = {1.0, 0.6, 0.15};
constexpr Colour kEvent = {0.78, 1.0, 0.3};
constexpr Colour kContact = {1.0, 0.35, 0.3};
constexpr Colour kTrail = {0.95, 0.8, 0.45};
constexpr Colour kText = {0.9, 0.9, 0.9};
constexpr Colour kFaintText = {0.68, 0.68, 0.7};

constexpr double kFillOpacity = 0.42;
constexpr double kTextSize = 13.0, kSmallText = 12.0;

} // namespace testbed::style

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
