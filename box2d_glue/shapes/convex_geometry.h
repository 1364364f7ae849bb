// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CONVEX_GEOMETRY_H
#define BOOMERANG_GLUE_CONVEX_GEOMETRY_H

#include <atomic>
#include <cstdint>
#include <cstring>

#include "boomerang/convex_shape.h"
#include "convex32/convex32.h"

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

/// Where a ConvexShape's functions are; nullptr before there is one. The class is final, and its functions
/// are in one library.
extern std::atomic<const void *> convexShapeTable;

/// The first word of every shape.
inline const void *TableOf(const b2Shape &shape) {
    const void *table;
    std::memcpy(&table, static_cast<const void *>(&shape), sizeof table);
    return table;
}

/// One of any size.
inline bool IsConvexShape(const b2Shape &shape) {
    return TableOf(shape) == convexShapeTable.load(std::memory_order_relaxed);
}

struct ConvexShapeAccess {
    /// 0 where the shape is any other, was changed in place, or has no more than 8 vertices and is no piece
    /// of an outline.
    static uint32_t HandleOf(const b2Shape &shape) {
        return IsConvexShape(shape) ? static_cast<const ConvexShape &>(shape).GetHandle() : 0;
    }
    /// Also where it was changed in place.
    static uint32_t KeptHandleOf(const b2Shape &shape) {
        return IsConvexShape(shape) ? static_cast<const ConvexShape &>(shape).GetKeptHandle() : 0;
    }
    /// The shape takes over the polygon of the handle, with one reference of the caller's.
    static void Adopt(ConvexShape *shape, uint32_t handle) { shape->Adopt(handle); }
};

} // namespace internal

/// Has this process ever made a big polygon? One load. Our hooks ask this first. True before the first such
/// shape is handed out; never false again.
inline bool AnyBigPolygon() {
    return internal::anyBigPolygon.load(std::memory_order_relaxed);
}

} // namespace bmr

#endif
