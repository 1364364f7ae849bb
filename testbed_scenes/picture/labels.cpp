// SPDX-License-Identifier: MIT
#include "picture/parts.h"

#include <algorithm>
#include <cmath>

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

namespace {

/// Of a body a picture must show this much, in square points, for a number to stand there.
constexpr double kLeastArea = 250.0;
/// Circles have so many corners here.
constexpr int kCorners = 24;

using Points = std::vector<bmr_vec2>;

/// What of a convex polygon lies on the side of the line <normal, x> = offset that its normal does not point
/// to (Sutherland and Hodgman).
Points Beyond(const Points &polygon, bmr_vec2 normal, double offset) {
    Points kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const bmr_vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const double overA = bmr_dot(normal, a) - offset, overB = bmr_dot(normal, b) - offset;
        if (overA <= 0.0)
            kept.push_back(a);
        if ((overA < 0.0 && overB > 0.0) || (overA > 0.0 && overB < 0.0))
            kept.push_back(bmr_add(a, bmr_scale(overA / (overA - overB), bmr_sub(b, a))));
    }
    return kept;
}

Points Clipped(Points polygon, const Rectangle &area) {
    polygon = Beyond(polygon, bmr_vec2_make(1.0, 0.0), area.right);
    polygon = Beyond(polygon, bmr_vec2_make(-1.0, 0.0), -area.left);
    polygon = Beyond(polygon, bmr_vec2_make(0.0, 1.0), area.top);
    return Beyond(polygon, bmr_vec2_make(0.0, -1.0), -area.bottom);
}

/// The area of a polygon, and its centre of mass in `*middle`, where the area is none of zero.
double Weigh(const Points &polygon, bmr_vec2 *middle) {
    double area = 0.0;
    bmr_vec2 sum = bmr_vec2_make(0.0, 0.0);
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const bmr_vec2 a = bmr_sub(polygon[i - 1], polygon[0]), b = bmr_sub(polygon[i], polygon[0]);
        const double twice = bmr_cross(a, b);
        area += 0.5 * twice;
        sum = bmr_add(sum, bmr_scale(twice / 6.0, bmr_add(a, b)));
    }
    if (area != 0.0)
        *middle = bmr_add(polygon[0], bmr_scale(1.0 / area, sum));
    return std::fabs(area);
}

bool IsInside(const Points &polygon, bmr_vec2 point) {
    bool left = false, right = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const bmr_vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const double side = bmr_cross(bmr_sub(b, a), bmr_sub(point, a));
        left = left || side > 0.0;
        right = right || side < 0.0;
    }
    return !polygon.empty() && !(left && right);
}

Points CornersOf(const Canvas &canvas, const WorldView &world, const shown::Fixture &fixture) {
    Points points = world.ToWorld(fixture.body, fixture.points);
    if (fixture.shape == "circle" && !points.empty()) {
        const bmr_vec2 centre = points[0];
        points.clear();
        for (int i = 0; i < kCorners; ++i) {
            const double angle = 2.0 * M_PI * i / kCorners;
            points.push_back(bmr_add(centre, bmr_scale(static_cast<double>(fixture.radius),
                                                       bmr_vec2_make(std::cos(angle), std::sin(angle)))));
        }
    }
    for (bmr_vec2 &point : points)
        point = canvas.OnPage(point);
    return points;
}

} // namespace

std::optional<bmr_vec2> MiddleOfVisible(const Canvas &canvas, const WorldView &world, const Rectangle &area,
                                        double unit, int body) {
    std::vector<Points> parts;
    bmr_vec2 largest = bmr_vec2_make(0.0, 0.0), sum = largest;
    double most = 0.0, all = 0.0;
    for (const shown::Fixture *fixture : world.FixturesOf(body)) {
        if (fixture->shape != "polygon" && fixture->shape != "circle")
            continue;
        parts.push_back(Clipped(CornersOf(canvas, world, *fixture), area));
        bmr_vec2 middle = bmr_vec2_make(0.0, 0.0);
        const double seen = Weigh(parts.back(), &middle);
        all += seen;
        sum = bmr_add(sum, bmr_scale(seen, middle));
        if (seen > most) {
            most = seen;
            largest = middle;
        }
    }
    if (!(all > kLeastArea * unit * unit))
        return std::nullopt;
    const bmr_vec2 middle = bmr_scale(1.0 / all, sum);
    const bool isInside = std::any_of(parts.begin(), parts.end(),
                                      [middle](const Points &part) { return IsInside(part, middle); });
    return isInside ? middle : largest;
}

bmr_vec2 WhereItLeaves(const Rectangle &area, double margin, bmr_vec2 from, bmr_vec2 to) {
    const Rectangle inner = {area.left + margin, area.bottom + margin, area.right - margin,
                             area.top - margin};
    const bmr_vec2 way = bmr_sub(to, from);
    double share = 1.0;
    const auto stop = [&share](double start, double by, double low, double high) {
        if (by > 0.0)
            share = std::min(share, (high - start) / by);
        else if (by < 0.0)
            share = std::min(share, (low - start) / by);
    };
    stop(from.x, way.x, inner.left, inner.right);
    stop(from.y, way.y, inner.bottom, inner.top);
    return bmr_add(from, bmr_scale(std::max(share, 0.0), way));
}

} // namespace testbed
