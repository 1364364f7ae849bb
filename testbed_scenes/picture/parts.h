// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_PICTURE_PARTS_H
#define BOOMERANG_TESTBED_PICTURE_PARTS_H

#include <array>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "drawing/canvas.h"
#include "picture/picture.h"
#include "picture/world_view.h"

/// @file
/// What a picture of a world is put together of. `unit` is one point of a picture 1200 wide.

namespace testbed {

// --- Colours of a world's picture. Widths and sizes are in points of a picture 1200 wide.

namespace style {

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
constexpr Colour kDisk = {0.93, 0.93, 0.93};
constexpr Colour kHandedOver = {1.0, 0.6, 0.15};
constexpr Colour kEvent = {0.78, 1.0, 0.3};
constexpr Colour kContact = {1.0, 0.35, 0.3};
constexpr Colour kTrail = {0.95, 0.8, 0.45};
constexpr Colour kText = {0.9, 0.9, 0.9};
constexpr Colour kFaintText = {0.68, 0.68, 0.7};

constexpr double kFillOpacity = 0.42;
constexpr double kTextSize = 13.0;

} // namespace style

/// Slack as colour, logarithmic, the same in all pictures so that they compare: less than twice Box2D's slop
/// is about to touch, more than the largest bodies' size is far away.
constexpr double kLeastSlack = 0.01, kMostSlack = 10.0;
/// Bright yellow for little slack, dark blue for much. The brightness differs, too, so people who do not see
/// these colours tell them apart.
Colour ColourOfSlack(double slack);
/// "0.124 m"; of a kinetic world, whose lengths have no unit, "0.124".
std::string LengthText(double length, bool kinetic);

// --- What is in a world whether or not anything is proved of it.

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

// --- Why pairs are known to be apart.

/// A pair whose proof is drawn in full.
struct Explained {
    const shown::Pair *pair = nullptr;
    const shown::Proof *proof = nullptr; ///< the one with the least slack
    bmr_vec2 place = {0.0, 0.0};         ///< the middle of the gap, in the world
};

/// The proof that bounds a pair's slack; nullptr if one of its contacts has none, or with stock.
const shown::Proof *WeakestProof(const shown::Pair &pair);

/// The pairs of the body in focus that are proved apart, do not touch and have their gap in the region: the
/// closest first, and not more than a picture can show.
std::vector<Explained> Explain(const WorldView &world, const PictureOptions &options,
                               const Rectangle &region);

/// The disks of bodies in pairs (of the body in focus, if any), which a kinetic world has.
void DrawDisks(Canvas &canvas, const WorldView &world, const PictureOptions &options, double unit);
/// Every proof as a short stroke across its gap, with its edge; with a body in focus those of pairs that
/// touch elsewhere.
void DrawProofs(Canvas &canvas, const WorldView &world, const PictureOptions &options, double unit);
/// In full: the line with its edge and the vertex opposite, the direction, or the disks.
void DrawExplained(Canvas &canvas, const WorldView &world, const PictureOptions &options, double unit,
                   const Explained &explained);
/// A diamond at each pair that needed a manifold; a dashed stroke first, where it does not touch.
void DrawHandedOver(Canvas &canvas, const WorldView &world, const PictureOptions &options, double unit);
/// A ring at each pair to whose certificate something happened in the step.
void DrawEvents(Canvas &canvas, const WorldView &world, const PictureOptions &options, double unit);
/// What that was, by its name in the paper, and how often.
std::map<std::string, std::size_t> EventsInFocus(const WorldView &world, const PictureOptions &options);

/// Is the pair one of the body in focus? All are, without one.
bool IsInFocus(const PictureOptions &options, const shown::Pair &pair);

} // namespace testbed

#endif
