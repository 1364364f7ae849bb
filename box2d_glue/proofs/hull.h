// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_HULL_H
#define BOOMERANG_GLUE_HULL_H

#include <cstdint>

#include "base/slab.h"
#include "boomerang/pair.h"

class b2BlockAllocator;
class b2Body;
class b2Fixture;

namespace bmr {

struct HullMember;

/// The convex hull of a body's polygon fixtures, or of one fixture of it, in the body's frame, with the
/// hierarchy that the chosen structure walks on. Shared by all pairs of its body; lives in the world's block
/// allocator.
///
/// Sensors are left out. Big ConvexShapes are there with their real polygons. A hull of many vertices is
/// replaced by an envelope of kMostHullVertices edges around it (an outer approximation by the paper's own
/// means), so that it fits a slab.
struct Hull {
    bmr_shape shape; ///< polygon and hierarchy; polygon NULL where the hull could not be built
    const b2Body *body;
    const b2Fixture *fixture;    ///< the one fixture this hull is of, or nullptr: of the whole body
    double reach;                ///< no vertex is farther from the body's origin
    float radius;                ///< largest radius of the fixtures it holds
    int32_t references;          ///< pairs that use it
    b2BlockAllocator *allocator; ///< the world's, where all of it lives
    uint64_t lookedAt;   ///< CurrentStep() when it was last seen to hold all fixtures that are no sensors
    Slab slab;           ///< what holds the shape and the members
    HullMember *members; ///< the fixtures it was built from, as they were then
    int32_t memberCount;
};

constexpr uint32_t kMostHullVertices = 64;
/// How far beyond an edge, relative to the coordinates, a vertex of the hull's own fixtures may seem to lie
/// by rounding.
constexpr double kHullTolerance = 1e-10;

/// The hierarchy of the chosen structure; NULL if it needs none.
inline const bmr_hierarchy *HierarchyOf(const Hull &hull) {
    for (const bmr_hierarchy *hierarchy : hull.shape.hierarchies)
        if (hierarchy != nullptr)
            return hierarchy;
    return nullptr;
}

/// A hull with one reference, built from the fixtures as they are now. Never fails: where geometry or memory
/// says no, its shape.polygon is NULL and pairs that use it answer nothing.
Hull *CreateHull(const b2Body *body, const b2Fixture *fixture, b2BlockAllocator *allocator);
/// Gives one reference back; the last one frees it.
void ReleaseHull(Hull *hull);
/// Builds it again from the fixtures as they are now. Pairs that use it must be reset by the caller.
void RebuildHull(Hull *hull);
/// Are all polygon fixtures that the hull is to hold in it, as they are now? Vertices may be changed in
/// place. True where its shape is NULL. Reads all of them: about 5 ns a fixture that is still as it was.
bool HullIsUpToDate(const Hull &hull);
/// Does the hull hold every vertex of this polygon fixture, as it is now, and a radius at least as large? And
/// are its vertices all that matters: false of a polygon that no hull is built of (a side without a
/// direction, normals of other sides), unless it looks as it did when this one was built.
bool HullHolds(const Hull &hull, const b2Fixture &fixture);

} // namespace bmr

#endif
