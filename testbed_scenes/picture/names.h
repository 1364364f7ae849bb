// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_PICTURE_NAMES_H
#define BOOMERANG_TESTBED_PICTURE_NAMES_H

#include <optional>
#include <vector>

#include "drawing/canvas.h"
#include "picture/world_view.h"

/// @file
/// Where a body's number stands in a picture.

namespace testbed {

/// The middle, on the page, of what `area` shows of a body's polygons and circles; where that is not in one
/// of them, the middle of the largest. Nothing where `area` shows less than a number needs. `unit` is one
/// point of a picture 1200 wide. Cost: linear in the body's vertices.
std::optional<bmr_vec2> MiddleOfVisible(const Canvas &canvas, const WorldView &world, const Rectangle &area,
                                        double unit, int body);

/// Where the way from a point inside of `area` to another leaves it, `margin` before its border; the other
/// point, if that is inside.
bmr_vec2 WhereItLeaves(const Rectangle &area, double margin, bmr_vec2 from, bmr_vec2 to);

} // namespace testbed

#endif
