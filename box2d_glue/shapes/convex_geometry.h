// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CONVEX_GEOMETRY_H
#define BOOMERANG_GLUE_CONVEX_GEOMETRY_H

#include <atomic>
#include <cstdint>

#include "convex32/convex32.h"

class b2Shape;

/// @file
/// From a shape that Box2D hands over to the polygon that it really is.

namespace bmr {

/// The real polygon of a ConvexShape of more than 8 vertices; nullptr of every other shape. Never written,
/// and there for as long as the shape is. A few loads: it is asked at every evaluation of a contact.
const bmr_convex32_block *BigPolygonOf(const b2Shape &shape);

/// A number that no other polygon of the process has, or ever had. Code that remembers a polygon without
/// keeping it alive knows it again by this. 0 for every other shape.
uint64_t NumberOfBigPolygon(const b2Shape &shape);

/// The polygon of that number; nullptr where no shape has it (any more). Any number may be asked, on any
/// thread, also one that was read from uninitialised memory: the answer is nullptr or a polygon that some
/// shape has. A few loads, no lock.
const bmr_convex32_block *BigPolygonOfNumber(uint64_t number);

namespace internal {
extern std::atomic<bool> anyBigPolygon;
} // namespace internal
/// Has this process ever made a big polygon? One load. Our hooks ask this first. True before the first such
/// shape is handed out; never false again.
inline bool AnyBigPolygon() {
    return internal::anyBigPolygon.load(std::memory_order_relaxed);
}

} // namespace bmr

#endif
