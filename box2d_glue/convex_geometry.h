// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CONVEX_GEOMETRY_H
#define BOOMERANG_GLUE_CONVEX_GEOMETRY_H

#include <cstdint>

#include "boomerang/convex32.h"

class b2Shape;

/// @file
/// From a shape that Box2D hands over to the polygon that it really is.

namespace bmr {

/// The real polygon of a ConvexShape of more than 8 vertices; nullptr of every other shape. Never written,
/// and there for as long as the shape is. A few loads: it is asked at every evaluation of a contact.
const bmr_convex32_block *BigPolygonOf(const b2Shape &shape);

/// A number of that polygon that no other polygon of the process has, or ever had: what remembers a polygon
/// without keeping it alive knows it again by this. 0 of every other shape.
uint64_t NumberOfBigPolygon(const b2Shape &shape);

} // namespace bmr

#endif
