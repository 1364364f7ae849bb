// SPDX-License-Identifier: MIT
#include "picture/labels.h"

#include <algorithm>
#include <cmath>

#include "picture/style.h"

namespace testbed {
namespace {

/// In points of a picture 1200 wide.
constexpr double kDisc = 9.0, kPadding = 4.0, kHeight = 19.0;
/// Labels are tried at these distances, in so many directions.
constexpr double kDistances[] = {22.0, 34.0, 50.0, 75.0, 110.0};
constexpr int kDirections = 12;
/// From here on a line leads to the point.
constexpr double kLeaderFrom = 30.0;

bool Overlap(const Rectangle &a, const Rectangle &b) {
    return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

} // namespace

void DrawNumber(Canvas &canvas, bmr_vec2 at, double radius, int number, const Colour &colour) {
    canvas.Circle(at, radius / canvas.Scale(), {colour, 1.0}, {colour, 0.0, 1.0, {}});
    const double size = (number < 10 ? 1.35 : 1.1) * radius;
    canvas.Text(at, 0.0, -0.36 * size, std::to_string(number), size, Align::Centre, style::kStrip, true);
}

void Labels::Block(bmr_vec2 at, double radius) {
    m_taken.push_back({at.x - radius, at.y - radius, at.x + radius, at.y + radius});
}

bool Labels::IsFree(const Rectangle &box) const {
    return box.left >= m_area.left && box.right <= m_area.right && box.bottom >= m_area.bottom &&
           box.top <= m_area.top &&
           std::none_of(m_taken.begin(), m_taken.end(),
                        [&box](const Rectangle &taken) { return Overlap(box, taken); });
}

void Labels::Write(const Rectangle &box, int number, const std::string &text, const Colour &colour) {
    m_canvas.Polygon({bmr_vec2_make(box.left, box.bottom), bmr_vec2_make(box.right, box.bottom),
                      bmr_vec2_make(box.right, box.top), bmr_vec2_make(box.left, box.top)},
                     {style::kStrip, 0.8}, {style::kStrip, 0.0, 1.0, {}});
    const double middle = 0.5 * (box.bottom + box.top);
    double x = box.left + kPadding * m_unit;
    if (number > 0) {
        DrawNumber(m_canvas, bmr_vec2_make(x + kDisc * m_unit, middle), kDisc * m_unit, number, colour);
        x += (2.0 * kDisc + kPadding) * m_unit;
    }
    const double size = style::kTextSize * m_unit;
    m_canvas.Text(bmr_vec2_make(x, middle), 0.0, -0.36 * size, text, size, Align::Left, style::kText);
    m_taken.push_back(box);
}

void Labels::Place(bmr_vec2 at, int number, const std::string &text, const Colour &colour) {
    const double width = m_canvas.TextWidth(text, style::kTextSize * m_unit) +
                         ((number > 0 ? 2.0 * kDisc : 0.0) + (text.empty() ? 1.0 : 3.0) * kPadding) * m_unit;
    const double height = kHeight * m_unit;
    for (const double distance : kDistances) {
        for (int i = 0; i < kDirections; ++i) {
            // Right and left first.
            const double angle = M_PI * (i % 2 == 0 ? i : kDirections - i + 1) / kDirections * 2.0 + 0.3;
            const double reachX = 0.5 * width + distance * m_unit * std::fabs(std::cos(angle));
            const bmr_vec2 centre =
                bmr_vec2_make(at.x + std::copysign(reachX, std::cos(angle)) * std::fabs(std::cos(angle)),
                              at.y + (0.5 * height + distance * m_unit) * std::sin(angle));
            const Rectangle box = {centre.x - 0.5 * width, centre.y - 0.5 * height, centre.x + 0.5 * width,
                                   centre.y + 0.5 * height};
            const Rectangle near = {at.x - 4.0 * m_unit, at.y - 4.0 * m_unit, at.x + 4.0 * m_unit,
                                    at.y + 4.0 * m_unit};
            if (!IsFree(box) || Overlap(box, near))
                continue;
            if (distance >= kLeaderFrom) {
                const bmr_vec2 end = bmr_vec2_make(std::clamp(at.x, box.left, box.right),
                                                   std::clamp(at.y, box.bottom, box.top));
                m_canvas.Segment(at, end, {style::kFaintText, 0.8 * m_unit, 0.9, {}});
            }
            Write(box, number, text, colour);
            return;
        }
    }
}

void Labels::PlaceAt(bmr_vec2 at, const std::string &text, double size, const Colour &colour) {
    const double halfWidth = 0.5 * m_canvas.TextWidth(text, size, true) + 2.0 * m_unit, half = 0.6 * size;
    const Rectangle box = {at.x - halfWidth, at.y - half, at.x + halfWidth, at.y + half};
    if (!IsFree(box))
        return;
    m_canvas.Text(at, 0.0, -0.36 * size, text, size, Align::Centre, colour, true);
    m_taken.push_back(box);
}

} // namespace testbed
