// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CONVEX_ACCESS_H
#define BOOMERANG_GLUE_CONVEX_ACCESS_H

#include <atomic>
#include <cstring>

#include "boomerang/convex_shape.h"

namespace bmr::internal {

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

} // namespace bmr::internal

#endif
