// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_STOCK_POLYGON_H
#define BOOMERANG_GLUE_STOCK_POLYGON_H

#include <box2d/b2_polygon_shape.h>

#include "boomerang/error.h"

/// @file
/// b2PolygonShape::Set ends the program on points that it does not like, or silently makes fewer of them.

namespace bmr {

/// What Set makes of `count` points (3 to b2_maxPolygonVertices) into `shape`, but for its radius, which
/// stays. Where Set would weld points, BMR_ERROR_TOO_CLOSE; where it would assert, BMR_ERROR_TOO_FEW_POINTS
/// (all on a line), BMR_ERROR_NOT_CONVEX (rounding leaves no hull) or BMR_ERROR_OUT_OF_RANGE (the area is too
/// small, or something overflows); the shape stays as it was.
bmr_error SetStockPolygon(b2PolygonShape *shape, const b2Vec2 *points, int32 count);

/// The same of vertices that are in order: they keep their numbers. BMR_ERROR_NOT_CONVEX where Set would keep
/// others or another order.
bmr_error SetStockPolygonRaw(b2PolygonShape *shape, const b2Vec2 *vertices, int32 count);

} // namespace bmr

#endif
