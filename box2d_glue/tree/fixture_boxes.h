// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TREE_FIXTURE_BOXES_H
#define BOOMERANG_TREE_FIXTURE_BOXES_H

#include <box2d/b2_math.h>

class b2BroadPhase;
class b2Fixture;

namespace bmr::tree {

using Box2DsSynchronize = void(b2Fixture *, b2BroadPhase *, const b2Transform &, const b2Transform &);

/// b2Fixture::Synchronize: after a step each fixture's box is set anew, around where it was and where it is,
/// and its leaf of the tree moves if it must. `box2d` is Box2D's own, which does what is not done here:
/// shapes that are neither polygons nor circles nor ConvexShapes, and boxes that are not finite.
/// Rounding is to nearest.
void SynchronizeBoxes(b2Fixture *fixture, b2BroadPhase *broadPhase, const b2Transform &xf1,
                      const b2Transform &xf2, Box2DsSynchronize *box2d);

} // namespace bmr::tree

#endif
