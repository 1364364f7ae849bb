// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_OUTLINE_H
#define BOOMERANG_TESTBED_OUTLINE_H

#include <cstdio>

class b2Body;
class b2World;

/// @file
/// What a worker prints for `--outline STEP`, so that boomerang-testbed can draw a world it does not hold.
/// Plain Box2D: the plugin's worker hands in the one function that needs the plugin.

namespace testbed {

/// The certified distance of two bodies, 0 where nothing is proved (bmr::CertifiedSlack has this type).
using SlackFunction = float (*)(const b2Body *, const b2Body *);

/// Prints one line per shape, pair and contact point, in world coordinates; bodies are numbered in the order
/// of the body list. STATE is static, kinematic, dynamic, sleeping, disabled or sensor:
///
///     outline polygon BODY STATE x y x y x y…
///     outline circle BODY STATE x y radius angle
///     outline chain BODY STATE x y x y…          an edge is a chain of two points
///     outline joint x y x y                      its two anchors
///     outline pair BODY BODY x y x y slack       body pairs that share a polygon contact: the closest points
///     of
///                                                their closest two fixtures; slack is -1 without a
///                                                SlackFunction
///     outline point x y                          a live contact point
///
/// Does not change the world. O(fixtures + contacts).
void WriteOutline(std::FILE *out, const b2World &world, SlackFunction slack = nullptr);

} // namespace testbed

#endif
