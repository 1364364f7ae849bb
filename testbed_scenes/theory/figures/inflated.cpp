// SPDX-License-Identifier: MIT
// Section 6: inflated hierarchies, and the window that gives rotational hysteresis.
#include <algorithm>
#include <cmath>

#include "boomerang/inflated.h"
#include "theory/figure.h"

namespace testbed {
namespace {

const std::vector<bmr_vec2> kOther = {{-1.75, -0.5}, {-0.95, -1.15}, {0.5, -1.2}, {1.7, -0.55},
                                      {1.85, 0.5},   {0.8, 1.2},     {-0.6, 1.1}, {-1.6, 0.5}};

/// Every corner of an envelope, in counter-clockwise order.
std::vector<bmr_corner> CornersOf(const bmr_hierarchy *hierarchy, uint32_t level) {
    std::vector<bmr_corner> corners;
    bmr_edge edge = 0;
    do {
        corners.push_back(bmr_hierarchy_corner_after(hierarchy, edge, level));
        edge = corners.back().after;
    } while (edge != 0);
    return corners;
}

std::vector<bmr_vec2> Inflated(const bmr_hierarchy *hierarchy, uint32_t level, double offset) {
    std::vector<bmr_vec2> points;
    for (const bmr_corner &corner : CornersOf(hierarchy, level))
        points.push_back(bmr_inflated_corner(hierarchy, corner, offset));
    return points;
}

/// Between the two normals of a corner.
bmr_vec2 Middle(const bmr_hierarchy *hierarchy, const bmr_corner &corner) {
    return bmr_add(bmr_hierarchy_line(hierarchy, corner.before).normal,
                   bmr_hierarchy_line(hierarchy, corner.after).normal);
}

} // namespace

void DrawInflated(Canvas &canvas) {
    const Body body(kOther);
    const bmr_hierarchy *hierarchy = body.Hierarchy(BMR_HIERARCHY_COMPASS);
    const bmr_inflation inflation = bmr_inflation_make(bmr_inflation_diameter(body.Polygon()), 0.5, 0.5, 0);
    constexpr uint32_t kLevels = 3;
    const Rectangle page = {10.0, 50.0, canvas.Width() - 10.0, canvas.Height() - 10.0};
    canvas.SetPanel(page, Around(Inflated(hierarchy, 0, bmr_inflation_offset(&inflation, 0)), 0.03));
    for (uint32_t j = 0; j < kLevels; ++j) {
        const Colour colour = ink::Series(j);
        canvas.Polygon(Inflated(hierarchy, j, bmr_inflation_offset(&inflation, j)), {colour, 0.10},
                       {colour, 1.6});
        canvas.Polygon(Envelope(hierarchy, j), {}, {colour, 1.0, 1.0, {2.0, 2.5}});
    }
    // Each corner of Q'_1 hangs on the corner of Q'_0 that swallows it.
    for (const bmr_corner &corner : CornersOf(hierarchy, 1)) {
        const bmr_corner outer = bmr_hierarchy_extreme(hierarchy, Middle(hierarchy, corner), 0);
        canvas.Segment(bmr_inflated_corner(hierarchy, corner, bmr_inflation_offset(&inflation, 1)),
                       bmr_inflated_corner(hierarchy, outer, bmr_inflation_offset(&inflation, 0)),
                       {ink::kBlack, 0.9, 1.0, {5.0, 3.0}});
    }
    canvas.Polygon(body.Vertices(), {ink::kGrey, 0.3}, {ink::kBlack, 2.0});
    canvas.Text(bmr_vec2_make(0.0, 0.0), 0.0, -5.0, "Q", 15.0, Align::Centre, ink::kBlack, true);

    canvas.ClearPanel();
    double x = 20.0;
    for (uint32_t j = 0; j < kLevels; ++j) {
        const std::string number = std::to_string(j);
        canvas.Segment({x, 30.0}, {x + 20.0, 30.0}, {ink::Series(j), 1.6});
        canvas.Segment({x, 20.0}, {x + 20.0, 20.0}, {ink::Series(j), 1.0, 1.0, {2.0, 2.5}});
        canvas.Text({x + 25.0, 27.0}, 0.0, 0.0, "Q'" + number, 10.0);
        canvas.Text({x + 25.0, 16.0}, 0.0, 0.0, "Q" + number, 10.0);
        x += 66.0;
    }
    canvas.Segment({x, 25.0}, {x + 24.0, 25.0}, {ink::kBlack, 0.9, 1.0, {5.0, 3.0}});
    canvas.Text({x + 30.0, 21.0}, 0.0, 0.0, "connecting edges: triangles and trapezoids between Q'0 and Q'1",
                10.0);
}

void DrawWindow(Canvas &canvas) {
    const Body owner(EllipsePoints(9, 1.2, 0.8, 0.2)), other(kOther);
    const bmr_hierarchy *hierarchy = other.Hierarchy(BMR_HIERARCHY_COMPASS);
    constexpr uint32_t kLevel = 2;
    const bmr_vec2 down = bmr_vec2_make(0.12, -1.0);
    // The corner that faces the line, its neighbours, and the cone that the three leave open.
    const bmr_corner middle = bmr_hierarchy_extreme(hierarchy, down, kLevel);
    const bmr_corner before = bmr_hierarchy_corner_before(hierarchy, middle.before, kLevel);
    const bmr_corner after = bmr_hierarchy_corner_after(hierarchy, middle.after, kLevel);
    const std::vector<bmr_vec2> points = {bmr_hierarchy_corner_point(hierarchy, before),
                                          bmr_hierarchy_corner_point(hierarchy, middle),
                                          bmr_hierarchy_corner_point(hierarchy, after)};
    const bmr_vec2 low = bmr_hierarchy_line(hierarchy, before.before).normal,
                   high = bmr_hierarchy_line(hierarchy, after.after).normal;
    const double gap = 0.55;
    const double offset = points[1].y - gap;

    const Rectangle page = {10.0, 44.0, canvas.Width() - 10.0, canvas.Height() - 10.0};
    canvas.SetPanel(page, {-2.9, offset - 1.9, 2.9, 1.55});
    canvas.Polygon(Envelope(hierarchy, kLevel), {ink::kGreen, 0.08}, {ink::kGreen, 1.2, 1.0, {2.0, 2.5}});
    canvas.Polygon(other.Vertices(), {ink::kGrey, 0.25}, {ink::kBlack, 1.6});
    canvas.Text(bmr_vec2_make(0.0, 0.0), 0.0, -5.0, "B, its envelope of level j", 12.0, Align::Centre);
    const bmr_pose place = bmr_pose_from_angle({0.1, 0.0}, 0.0);
    double top = -INFINITY;
    for (const bmr_vec2 &vertex : owner.Vertices())
        top = std::max(top, vertex.y);
    bmr_pose lower = place;
    lower.position.y = offset - top;
    canvas.Polygon(Placed(owner.Vertices(), lower), {ink::kBlue, 0.18}, {ink::kBlue, 1.6});
    canvas.Text(lower.position, 0.0, -5.0, "A", 13.0, Align::Centre, ink::kBlack, true);
    canvas.Line(bmr_vec2_make(0.0, 1.0), offset, {ink::kRed, 1.4});
    canvas.Text(bmr_vec2_make(-2.85, offset), 0.0, 5.0, "line(g), fixed in A", 11.0, Align::Left, ink::kRed);
    // The cone of directions, at the middle corner.
    const auto ray = [&](const bmr_vec2 &direction) {
        return bmr_add(points[1], bmr_scale(1.15, direction));
    };
    canvas.Polygon({points[1], ray(low), ray(bmr_scale(1.0 / std::hypot(down.x, down.y), down)), ray(high)},
                   {ink::kOrange, 0.22}, {ink::kOrange, 0.0});
    canvas.Arrow(points[1], ray(low), {ink::kOrange, 1.4});
    canvas.Arrow(points[1], ray(high), {ink::kOrange, 1.4});
    canvas.Arrow(points[1], bmr_add(points[1], bmr_vec2_make(0.0, -0.9)), {ink::kBlack, 1.2});
    for (const bmr_vec2 &point : points)
        canvas.Dot(point, 4.0, ink::kPurple);

    canvas.ClearPanel();
    canvas.Dot({24.0, 24.0}, 4.0, ink::kPurple);
    canvas.Text({34.0, 20.0}, 0.0, 0.0, "the window W: three corners, all beyond the line", 10.5);
    DrawKey(canvas, {330.0, 24.0}, {ink::kOrange, 1.6}, "its cone: W holds B's nearest corner in it");
}

} // namespace testbed
