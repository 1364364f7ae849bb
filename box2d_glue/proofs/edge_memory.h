// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_EDGE_MEMORY_H
#define BOOMERANG_GLUE_EDGE_MEMORY_H

#include <cstdint>

namespace bmr {

/// What two polygons of Box2D's own size remember of each other, in their contact. It is a guess: code that
/// uses it tests it again, for the shapes as they are then.
struct EdgeMemory {
    uint8_t number;       ///< of the edge that kept the two apart, kNoEdge where none did
    uint8_t ofB : 1;      ///< whose edge it is
    uint8_t isVertex : 1; ///< of a sensor's contact: it is the vertex that was inside the other polygon
};

constexpr uint8_t kNoEdge = 0xff;

} // namespace bmr

#endif
