// SPDX-License-Identifier: MIT
#include "picture/parts.h"

#include <algorithm>
#include <cmath>

namespace testbed {
namespace {

/// In points of a picture 1200 wide.
constexpr double kPadding = 4.0, kHeight = 19.0;
/// Labels are tried at these distances, in so many directions.
constexpr double kDistances[] = {22.0, 34.0, 50.0, 75.0, 110.0};
constexpr int kDirections = 12;
/// From here on a line leads to the point.
constexpr double kLeaderFrom = 30.0;

bool Overlap(const Rectangle &a, const Rectangle &b) {
    return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

} // namespace

void Labels::Block(bmr_vec2 at, double radius) {
    m_taken.push_back({at.x - radius, at.y - radius, at.x + radius, at.y + radius});
}

bool Labels::IsFree(const Rectangle &box) const {
    return box.left >= m_area.left && box.right <= m_area.right && box.bottom >= m_area.bottom &&
           box.top <= m_area.top &&
           std::none_of(m_taken.begin(), m_taken.end(),
                        [&box](const Rectangle &taken) { return Overlap(box, taken); });
}

void Labels::Place(bmr_vec2 at, const std::string &text) {
    const double width = m_canvas.TextWidth(text, style::kTextSize * m_unit) + 2.0 * kPadding * m_unit;
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
            m_canvas.Box(box, {style::kStrip, 0.8});
            const double size = style::kTextSize * m_unit;
            m_canvas.Text(bmr_vec2_make(box.left + kPadding * m_unit, centre.y), 0.0, -0.36 * size, text,
                          size, Align::Left, style::kText);
            m_taken.push_back(box);
            return;
        }
    }
}

void Labels::PlaceAt(bmr_vec2 at, const std::string &text, double size) {
    const double halfWidth = 0.5 * m_canvas.TextWidth(text, size, true) + 2.0 * m_unit, half = 0.6 * size;
    const Rectangle box = {at.x - halfWidth, at.y - half, at.x + halfWidth, at.y + half};
    if (!IsFree(box))
        return;
    m_canvas.Text(at, 0.0, -0.36 * size, text, size, Align::Centre, style::kText, true);
    m_taken.push_back(box);
}

std::optional<bmr_vec2> PlaceIn(const WorldView &world, const Rectangle &region, int body) {
    bmr_vec2 sum = bmr_vec2_make(0.0, 0.0);
    double count = 0.0;
    for (const shown::Fixture *fixture : world.FixturesOf(body)) {
        if (fixture->shape != "polygon")
            continue;
        std::vector<bmr_vec2> seen = world.ToWorld(body, fixture->points);
        seen = Clipped(seen, bmr_vec2_make(-1.0, 0.0), -region.right);
        seen = Clipped(seen, bmr_vec2_make(1.0, 0.0), region.left);
        seen = Clipped(seen, bmr_vec2_make(0.0, -1.0), -region.top);
        seen = Clipped(seen, bmr_vec2_make(0.0, 1.0), region.bottom);
        for (const bmr_vec2 &corner : seen)
            sum = bmr_add(sum, corner);
        count += static_cast<double>(seen.size());
    }
    return count > 0.0 ? std::optional<bmr_vec2>(bmr_scale(1.0 / count, sum)) : std::nullopt;
}

} // namespace testbed
