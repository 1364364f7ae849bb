// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_LABELS_H
#define BOOMERANG_TESTBED_LABELS_H

#include <optional>
#include <string>
#include <vector>

#include "drawing/canvas.h"
#include "picture/world_view.h"

namespace testbed {

/// Short texts beside points of a page, none over another or over the edge of its area. The canvas shows the
/// page itself (Canvas::ClearPanel).
class Labels {
public:
    Labels(Canvas &canvas, const Rectangle &area, double unit)
        : m_canvas(canvas), m_area(area), m_unit(unit) {}

    /// Keeps labels away from here.
    void Block(bmr_vec2 at, double radius);
    /// Writes a number in a disc (none if it is 0) and a text near a point, with a line to the point where
    /// there is no room close by; nothing where there is no room at all.
    void Place(bmr_vec2 at, int number, const std::string &text, const Colour &colour);
    /// Writes a text around a point, if it fits there and not elsewhere.
    void PlaceAt(bmr_vec2 at, const std::string &text, double size, const Colour &colour);

private:
    bool IsFree(const Rectangle &box) const;
    void Write(const Rectangle &box, int number, const std::string &text, const Colour &colour);

    Canvas &m_canvas;
    const Rectangle m_area;
    const double m_unit;
    std::vector<Rectangle> m_taken;
};

/// A number in a disc, as labels and lists show it; `radius` on the page.
void DrawNumber(Canvas &canvas, bmr_vec2 at, double radius, int number, const Colour &colour);

/// Where a body's number stands in a picture.
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
