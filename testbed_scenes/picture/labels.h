// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_LABELS_H
#define BOOMERANG_TESTBED_LABELS_H

#include <string>
#include <vector>

#include "drawing/canvas.h"

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

} // namespace testbed

#endif
