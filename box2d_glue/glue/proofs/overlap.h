// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_OVERLAP_H
#define BOOMERANG_GLUE_OVERLAP_H

#include <cstdint>

#include <box2d/b2_math.h>

class b2Shape;

namespace bmr {

/// What two polygons of Box2D's own size remember of each other, in their contact. It is a guess: code that
/// uses it tests it again, for the shapes as they are then.
struct EdgeMemory {
    uint8_t number;       ///< of the edge that kept the two apart, kNoEdge where none did
    uint8_t ofB : 1;      ///< whose edge it is
    uint8_t isVertex : 1; ///< of a sensor's contact: it is the vertex that was inside the other polygon
};

constexpr uint8_t kNoEdge = 0xff;

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
