// SPDX-License-Identifier: MIT
// Section 3: the boomerang hierarchy and Dudley's construction.
#include <algorithm>
#include <cmath>
#include <string>

#include "theory/figure.h"

namespace testbed {
namespace {

/// The polygon of these figures: few vertices, no symmetry.
const std::vector<bmr_vec2> kPolygon = {{-1.9, -0.35}, {-1.35, -1.0}, {-0.2, -1.3}, {1.1, -1.15},
                                        {1.9, -0.6},   {2.1, 0.15},   {1.55, 0.95}, {0.6, 1.35},
                                        {-0.7, 1.2},   {-1.6, 0.6}};

/// The vertices of the polygon from the touch of one edge to that of another, counter-clockwise.
std::vector<bmr_vec2> Chain(const Body &body, const bmr_hierarchy *hierarchy, bmr_edge from, bmr_edge to) {
    const bmr_polygon *polygon = body.Polygon();
    const bmr_line line = bmr_hierarchy_line(hierarchy, from);
    uint32_t i = bmr_hierarchy_touch(hierarchy, from);
    // Of an edge's two vertices the chain leaves from the later one.
    const uint32_t next = (i + 1) % polygon->count;
    if (bmr_dot(line.normal, polygon->vertices[next]) > line.offset - 1e-9)
        i = next;
    std::vector<bmr_vec2> chain = {polygon->vertices[i]};
    for (const uint32_t last = bmr_hierarchy_touch(hierarchy, to); i != last;) {
        i = (i + 1) % polygon->count;
        chain.push_back(polygon->vertices[i]);
    }
    return chain;
}

} // namespace

void DrawBoomerangs(Canvas &canvas) {
    const Body body(kPolygon);
    const bmr_hierarchy *hierarchy = body.Hierarchy(BMR_HIERARCHY_COMPASS);
    constexpr uint32_t kLevels = 3;
    const std::vector<bmr_vec2> outer = Envelope(hierarchy, 0);
    canvas.SetPanel({10.0, 46.0, canvas.Width() - 10.0, canvas.Height() - 10.0}, Around(outer, 0.06));

    // The triangles that each level cuts off, coarse ones first.
    for (uint32_t level = 1; level <= kLevels; ++level)
        for (bmr_edge edge = 0; edge < bmr_hierarchy_edge_count(hierarchy); ++edge) {
            if (bmr_hierarchy_level(hierarchy, edge) != level)
                continue;
            const bmr_vec2 before =
                bmr_hierarchy_corner_point(hierarchy, bmr_hierarchy_corner_before(hierarchy, edge, level));
            const bmr_vec2 after =
                bmr_hierarchy_corner_point(hierarchy, bmr_hierarchy_corner_after(hierarchy, edge, level));
            canvas.Polygon({bmr_hierarchy_apex(hierarchy, edge), after, before},
                           {ink::Series(level - 1), 0.22}, {ink::Series(level - 1), 1.0});
        }
    canvas.Polygon(outer, {}, {ink::kBlack, 1.2});
    canvas.Polygon(body.Vertices(), {ink::kGrey, 0.25}, {ink::kBlack, 2.0});
    for (bmr_edge edge = 0; edge < bmr_hierarchy_edge_count(hierarchy); ++edge)
        if (const uint32_t level = bmr_hierarchy_level(hierarchy, edge); level >= 1 && level <= kLevels)
            canvas.Dot(bmr_hierarchy_apex(hierarchy, edge), 2.4, ink::Series(level - 1));

    // One boomerang of the top level in full: its chain of edges, its apex, its height.
    bmr_edge shown = BMR_NO_EDGE;
    for (bmr_edge edge = 0; edge < bmr_hierarchy_edge_count(hierarchy); ++edge)
        if (bmr_hierarchy_level(hierarchy, edge) == 1 &&
            (shown == BMR_NO_EDGE ||
             bmr_hierarchy_height(hierarchy, edge) > bmr_hierarchy_height(hierarchy, shown)))
            shown = edge;
    const bmr_boomerang boomerang = bmr_hierarchy_boomerang(hierarchy, shown);
    const bmr_vec2 apex = bmr_hierarchy_apex(hierarchy, shown);
    std::vector<bmr_vec2> chain = Chain(body, hierarchy, boomerang.outer_before, boomerang.outer_after);
    // The chain's nearest point to the apex is where the height is measured.
    bmr_vec2 foot = chain[0];
    for (size_t i = 0; i + 1 < chain.size(); ++i) {
        const bmr_vec2 along = bmr_sub(chain[i + 1], chain[i]);
        const double t =
            std::clamp(bmr_dot(bmr_sub(apex, chain[i]), along) / bmr_dot(along, along), 0.0, 1.0);
        const bmr_vec2 point = bmr_add(chain[i], bmr_scale(t, along));
        if (std::hypot(point.x - apex.x, point.y - apex.y) < std::hypot(foot.x - apex.x, foot.y - apex.y))
            foot = point;
    }
    chain.push_back(apex);
    canvas.Polygon(chain, {}, {ink::kBlack, 2.0, 1.0, {6.0, 4.0}});
    canvas.Segment(apex, foot, {ink::kBlack, 1.2, 1.0, {2.0, 3.0}});
    const double outwards = apex.x > 0.0 ? 1.0 : -1.0, upwards = apex.y > 0.0 ? 1.0 : -1.0;
    canvas.ClearPanel();
    canvas.SetPanel({10.0, 46.0, canvas.Width() - 10.0, canvas.Height() - 10.0}, Around(outer, 0.06));
    canvas.Text(apex, -8.0 * outwards, upwards > 0.0 ? -16.0 : 8.0, "apex", 11.0,
                outwards > 0.0 ? Align::Right : Align::Left);
    canvas.Text(bmr_scale(0.5, bmr_add(apex, foot)), -7.0 * outwards, 0.0, "height", 11.0,
                outwards > 0.0 ? Align::Right : Align::Left);
    canvas.Text(bmr_vec2_make(0.0, 0.0), 0.0, -4.0, "P", 16.0, Align::Centre, ink::kBlack, true);

    canvas.ClearPanel();
    double x = 14.0;
    DrawKey(canvas, {x, 26.0}, {ink::kBlack, 1.2}, "bounding rectangle P0", 11.0);
    x += 42.0 + canvas.TextWidth("bounding rectangle P0", 11.0);
    for (uint32_t level = 1; level <= kLevels; ++level) {
        canvas.Box({x, 20.0, x + 12.0, 32.0}, {ink::Series(level - 1), 0.22}, {ink::Series(level - 1), 1.0});
        const std::string text = "cut at level " + std::to_string(level);
        canvas.Text({x + 18.0, 22.0}, 0.0, 0.0, text, 11.0);
        x += 34.0 + canvas.TextWidth(text, 11.0);
    }
    DrawKey(canvas, {x, 26.0}, {ink::kBlack, 2.0, 1.0, {6.0, 4.0}}, "a boomerang", 11.0);
}

namespace {

/// The polygon, the points on the circle with their nearest vertices, and the degenerate edges that these
/// give.
void DrawDudley(Canvas &canvas, const Body &body, double radius) {
    const bmr_hierarchy *hierarchy = body.Hierarchy(BMR_HIERARCHY_DUDLEY);
    const bmr_polygon *polygon = body.Polygon();
    const bmr_vec2 center = polygon->center;
    canvas.Circle(center, radius, {}, {ink::kGrey, 1.2, 1.0, {2.0, 3.0}});
    for (bmr_edge edge = 0; edge < bmr_hierarchy_edge_count(hierarchy); ++edge) {
        if (bmr_hierarchy_level(hierarchy, edge) == 0)
            continue; // the rectangle is not Dudley's
        const bmr_line line = bmr_hierarchy_line(hierarchy, edge);
        const uint32_t touch = bmr_hierarchy_touch(hierarchy, edge);
        const bmr_vec2 at = polygon->vertices[touch], next = polygon->vertices[(touch + 1) % polygon->count];
        if (bmr_dot(line.normal, next) > line.offset - 1e-9)
            continue; // an edge of the polygon's own
        // From the touching vertex along the normal to the circle: the point it comes from.
        const bmr_vec2 d = bmr_sub(at, center);
        const double b = bmr_dot(d, line.normal), c = bmr_dot(d, d) - radius * radius;
        const bmr_vec2 on = bmr_add(at, bmr_scale(-b + std::sqrt(b * b - c), line.normal));
        canvas.Segment(on, at, {ink::kBlue, 0.8, 0.7});
        canvas.Dot(on, 2.5, ink::kBlue);
        const bmr_vec2 along = bmr_scale(0.09 * radius, bmr_left(line.normal));
        canvas.Segment(bmr_sub(at, along), bmr_add(at, along), {ink::kRed, 1.4, 1.0, {5.0, 3.0}});
    }
    canvas.Polygon(body.Vertices(), {ink::kGrey, 0.25}, {ink::kBlack, 2.0});
    canvas.Text(center, 0.0, -5.0, "P", 15.0, Align::Centre, ink::kBlack, true);
    canvas.Text(bmr_vec2_make(center.x, center.y - radius), 0.0, 8.0, "radius 2D", 11.0, Align::Centre);
}

} // namespace

void DrawDudley(Canvas &canvas) {
    const Body body(kPolygon);
    const double radius = 2.0 * bmr_polygon_diameter(body.Polygon()), bottom = 46.0,
                 top = canvas.Height() - 10.0;
    const bmr_vec2 center = body.Polygon()->center;
    const auto square = [&](double left, double half) {
        canvas.SetPanel({left, bottom, left + (top - bottom), top},
                        {center.x - half, center.y - half, center.x + half, center.y + half});
        DrawDudley(canvas, body, radius);
        canvas.ClearPanel();
    };
    square(10.0, 1.03 * radius);
    const double close = canvas.Width() - 10.0 - (top - bottom);
    square(close, 0.36 * radius);
    canvas.Polygon(
        {{close, bottom}, {close + (top - bottom), bottom}, {close + (top - bottom), top}, {close, top}}, {},
        {ink::kFaint, 1.0});

    canvas.Dot({34.0, 26.0}, 2.5, ink::kBlue);
    canvas.Segment({34.0, 26.0}, {54.0, 26.0}, {ink::kBlue, 0.8});
    canvas.Text({60.0, 22.0}, 0.0, 0.0, "x on the circle and its nearest vertex n(x)", 11.0);
    canvas.Segment({378.0, 26.0}, {402.0, 26.0}, {ink::kRed, 1.4, 1.0, {5.0, 3.0}});
    canvas.Text({408.0, 22.0}, 0.0, 0.0, "degenerate edge, outer normal x - n(x); on the right from nearby",
                11.0);
}

} // namespace testbed
