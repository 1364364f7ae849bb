// SPDX-License-Identifier: MIT
#include "picture/labels.h"

#include <algorithm>
#include <cmath>

namespace testbed {
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

Points CornersOf(const Canvas &canvas, const WorldView &world, const recording::Fixture &fixture) {
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
    for (const recording::Fixture *fixture : world.FixturesOf(body)) {
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
