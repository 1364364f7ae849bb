// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_FACE_GAP_H
#define BOOMERANG_GLUE_FACE_GAP_H

#include <cstdint>

class b2Fixture;

namespace bmr {

/// The separation of a polygon fixture from another's polygon along an edge of its own.
struct FaceGap {
    float separation = 0.0f; ///< as Box2D computes it
    int32_t edge = 0;
    /// A lower bound of the distance: the separation less what its arithmetic may be off by, and 0 where it
    /// is no more or where the two are too far from the origin to say.
    double proved = 0.0;
};

/// Along the edge of the owner that has the largest, at the bodies' present poses; of the real polygons where
/// they are big. O(vertices).
FaceGap LargestFaceGap(const b2Fixture &owner, const b2Fixture &other);
/// Along one edge of the owner; it must have it. Both of Box2D's own size.
FaceGap FaceGapAlong(int32_t edge, const b2Fixture &owner, const b2Fixture &other);

} // namespace bmr

#endif
