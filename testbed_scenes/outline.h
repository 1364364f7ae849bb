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

/// Prints one line per shape, joint, pair and contact point, in world coordinates. Bodies have the numbers
/// that their stage gave them; STATE is static, kinematic, dynamic, sleeping, disabled or sensor:
///
///     outline polygon BODY STATE x y x y x y...
///     outline circle BODY STATE x y radius angle
///     outline chain BODY STATE x y x y...
///     outline joint x y x y
///     outline pair BODY BODY x y x y slack
///     outline point x y
///
/// An edge is a chain of two points. A joint is its two anchors. A pair is two bodies that share a polygon
/// contact, with the closest points of their closest two fixtures; its slack is -1 without a SlackFunction. A
/// point is one of a live manifold.
///
/// Does not change the world. O(fixtures + contacts).
void WriteOutline(std::FILE *out, const b2World &world, SlackFunction slack = nullptr);

} // namespace testbed

#endif
