// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_OVERLAP_H
#define BOOMERANG_GLUE_OVERLAP_H

#include <box2d/b2_math.h>

#include "proofs/edge_memory.h"

class b2Shape;

namespace bmr {

/// The answer that b2TestOverlap certainly gives for two shapes at two poses.
enum class Overlap { kApart, kOverlapping, kUnknown };

/// Of any shapes. Shapes within rounding of touching are unknown, as are NaN and shapes out of reach
/// (thresholds.h). `memory`, if there is one, is asked first of two polygons of Box2D's own size, and gets
/// what was found. `touched`: they overlapped a step ago, and most likely do: nothing is searched for that
/// b2TestOverlap finds as fast.
Overlap CertainOverlap(const b2Shape &shapeA, int32 childA, const b2Shape &shapeB, int32 childB,
                       const b2Transform &xfA, const b2Transform &xfB, EdgeMemory *memory = nullptr,
                       bool touched = false);

} // namespace bmr

#endif
