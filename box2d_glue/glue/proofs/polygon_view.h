// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_POLYGON_VIEW_H
#define BOOMERANG_GLUE_POLYGON_VIEW_H

#include <algorithm>
#include <cmath>

#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>

#include "shapes/convex_geometry.h"
#include "shapes/shapes32.h"

namespace bmr {

/// A polygon shape as it really is: all vertices of a big ConvexShape, Box2D's own arrays of any other. Good
/// as long as the shape is.
inline bmr_convex32 RealPolygon(const b2PolygonShape &shape) {
    if (const bmr_convex32_block *big = BigPolygonOf(shape))
        return big->polygon;
    const bmr_polygon32 small = Polygon32(shape);
    return bmr_convex32_small(&small);
}

// Of a polygon fixture.
inline bmr_convex32 RealPolygon(const b2Fixture &fixture) {
    return RealPolygon(static_cast<const b2PolygonShape &>(*fixture.GetShape()));
}

inline bool IsBig(const b2Fixture &fixture) {
    return BigPolygonOf(*fixture.GetShape()) != nullptr;
}

/// The largest distance of a vertex from the body's origin. O(vertices).
inline double Extent(const bmr_convex32 &polygon) {
    double most = 0.0;
    for (uint32_t i = 0; i < polygon.count; ++i)
        most = std::max(most, std::hypot(static_cast<double>(polygon.vertices[i].x),
                                         static_cast<double>(polygon.vertices[i].y)));
    return most;
}

} // namespace bmr

#endif
