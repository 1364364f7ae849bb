// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_OVERLAP_H
#define BOOMERANG_GLUE_OVERLAP_H

#include <box2d/b2_math.h>

class b2Shape;

namespace bmr {

/// What b2TestOverlap is certain to say of two shapes at two poses.
enum class Overlap { kApart, kOverlapping, kUnknown };

/// Of any shapes. Remembers, for the thread, the direction that kept the two apart, and tries it first.
/// Whatever is within rounding of touching is unknown, as is what is not a number or out of reach
/// (thresholds.h).
Overlap CertainOverlap(const b2Shape &shapeA, int32 childA, const b2Shape &shapeB, int32 childB,
                       const b2Transform &xfA, const b2Transform &xfB);

} // namespace bmr

#endif
