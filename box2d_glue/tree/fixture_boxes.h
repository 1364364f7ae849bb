// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TREE_FIXTURE_BOXES_H
#define BOOMERANG_TREE_FIXTURE_BOXES_H

class b2Body;
class b2BroadPhase;
class b2Fixture;
struct b2Transform;

namespace bmr::tree {

/// b2Fixture::Synchronize: after a step each fixture's box is set anew, around where it was and where it is,
/// and its leaf of the tree moves if it must. Rounding is to nearest.
void SynchronizeBoxes(b2Fixture *fixture, b2BroadPhase *broadPhase, const b2Transform &xf1,
                      const b2Transform &xf2);

/// b2Body::SynchronizeFixtures: the same of all its fixtures, from the beginning of its sweep on if it is
/// awake. In any rounding.
void SynchronizeBoxes(b2Body *body);

} // namespace bmr::tree

#endif
