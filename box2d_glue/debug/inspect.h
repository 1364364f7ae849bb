// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_INSPECT_H
#define BOOMERANG_GLUE_INSPECT_H

#include <box2d/b2_math.h>

#include "boomerang/box2d_glue.h"

class b2Fixture;

/// @file
/// What the testbed's pictures and the tests ask: which line proves two fixtures apart. Nothing here changes
/// the simulation. Between steps, from the thread that steps.

namespace bmr::internal {

/// Why the two fixtures of a contact are known to be apart at their bodies' present poses. Element 0 of
/// arrays of two is of fixture A. Points and directions are in the body's own frame.
///
///   kind             says
///   none             nothing: the contact touches, is a sensor's, or is not of two polygons of ours
///   remembered-edge  an edge of one fixture: all of the other lies beyond
///   disks            two bounding disks of hulls
///   edge-line        an edge of the owner's envelope, and the nearest corner of the other's
///   direction        a direction, and the vertices of both hulls that are farthest along it
struct Proof {
    const char *kind = "none";
    const b2Fixture *fixtures[2] = {nullptr, nullptr}; ///< nullptr: the hull of all the body's polygons
    /// The vertex or corner nearest to the other body; of disks the centre. Of an edge, one of its ends.
    b2Vec2 supports[2] = {{0.0f, 0.0f}, {0.0f, 0.0f}};
    float radii[2] = {0.0f, 0.0f};                 ///< of disks
    int owner = 0;                                 ///< whose the line is
    b2Vec2 normal = {0.0f, 0.0f};                  ///< out of the owner, of unit length; zero for disks
    b2Vec2 edge[2] = {{0.0f, 0.0f}, {0.0f, 0.0f}}; ///< its ends, counter-clockwise
    /// A lower bound of the distance (radii not subtracted); 0 for none, and if a remembered edge is so far
    /// from the origin that rounding leaves nothing.
    float slack = 0.0f;
    /// With Options::pairsBy: the structure of the two bodies, the same for all contacts that share it.
    const void *structure = nullptr;
};

/// The proof that the next update of this contact would end with if its bodies stayed where they are.
BMR_BOX2D_API Proof Inspect(const b2Contact &contact);

} // namespace bmr::internal

#endif
