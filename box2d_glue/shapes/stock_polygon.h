// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_STOCK_POLYGON_H
#define BOOMERANG_GLUE_STOCK_POLYGON_H

#include "boomerang/convex_shape.h"

/// @file
/// b2PolygonShape::Set ends the program on points that it does not like, and welds points without a word.

namespace bmr {

/// Puts into `shape` what Set makes of `count` points (3 to b2_maxPolygonVertices), but keeps the radius. If
/// Set would assert, it is the exact hull. Adds to *welded the points that Set welds. If it may not weld, or
/// welds all but two: BMR_ERROR_TOO_CLOSE. BMR_ERROR_TOO_FEW_POINTS (all on a line, or in two places),
/// BMR_ERROR_OUT_OF_RANGE (the area is too small, or something overflows), BMR_ERROR_NO_MEMORY; the shape
/// stays as it was.
bmr_error SetStockPolygon(b2PolygonShape *shape, const b2Vec2 *points, int32 count, bool mayWeld,
                          Welded *welded);

/// The same of vertices that are in order: they keep their numbers. BMR_ERROR_NOT_CONVEX where Set would keep
/// others or another order.
bmr_error SetStockPolygonRaw(b2PolygonShape *shape, const b2Vec2 *vertices, int32 count);

} // namespace bmr

#endif
