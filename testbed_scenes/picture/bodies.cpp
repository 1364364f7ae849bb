// SPDX-License-Identifier: MIT
#include "picture/parts.h"

#include <algorithm>
#include <cmath>

namespace testbed {
namespace {

using shown::Body;
using shown::Fixture;

constexpr double kEdgeWidth = 0.9, kChainWidth = 1.6;
/// How faint what is not in focus is.
constexpr double kDimmed = 0.4;

Colour Mixed(const Colour &over, const Colour &under, double opacity) {
    const auto mix = [opacity](double a, double b) { return opacity * a + (1.0 - opacity) * b; };
    return {mix(over.red, under.red), mix(over.green, under.green), mix(over.blue, under.blue)};
}

class BodyPainter {
public:
    BodyPainter(Canvas &canvas, const WorldView &world, const Body &body, double unit, bool dim)
        : m_canvas(canvas), m_world(world), m_body(body), m_unit(unit), m_opacity(dim ? kDimmed : 1.0) {}

    void Draw() const {
        std::vector<const Fixture *> solid, other;
        for (const Fixture *fixture : m_world.FixturesOf(m_body.number))
            (fixture->shape == "polygon" && !fixture->sensor ? solid : other).push_back(fixture);
        if (solid.size() > 1)
            DrawSilhouette(solid);
        else
            other.insert(other.begin(), solid.begin(), solid.end());
        for (const Fixture *fixture : other)
            DrawFixture(*fixture);
    }

private:
    Colour ColourOf(const Fixture &fixture) const { return ColourOfState(StateOf(m_body, fixture)); }
    std::vector<bmr_vec2> PointsOf(const Fixture &fixture) const {
        return m_world.ToWorld(m_body.number, fixture.points);
    }

    /// A body of several polygons: all edges first, then the insides, opaque, over those edges that are inner
    /// ones. Drawn one by one, a fan of 63 triangles would be nothing but edges.
    void DrawSilhouette(const std::vector<const Fixture *> &fixtures) const {
        const Colour edge = Mixed(ColourOf(*fixtures[0]), style::kBackground, 0.95 * m_opacity);
        for (const Fixture *fixture : fixtures)
            m_canvas.Polygon(PointsOf(*fixture), {}, {edge, 2.0 * kEdgeWidth * m_unit, 1.0, {}});
        const Colour inside =
            Mixed(ColourOf(*fixtures[0]), style::kBackground, style::kFillOpacity * m_opacity);
        for (const Fixture *fixture : fixtures)
            m_canvas.Polygon(PointsOf(*fixture), {inside, 1.0}, {inside, 0.0, 1.0, {}});
        for (const Fixture *fixture : fixtures)
            DrawSeams(*fixture, edge);
    }

    /// Where pieces of an outline meet.
    void DrawSeams(const Fixture &fixture, const Colour &colour) const {
        const std::vector<bmr_vec2> points = PointsOf(fixture);
        const Pen pen = {colour, 0.5 * kEdgeWidth * m_unit, 0.5, {2.0 * m_unit, 2.0 * m_unit}};
        for (const int edge : fixture.inner) {
            const auto from = static_cast<std::size_t>(edge);
            if (from < points.size())
                m_canvas.Segment(points[from], points[(from + 1) % points.size()], pen);
        }
    }

    void DrawFixture(const Fixture &fixture) const {
        const Colour colour = ColourOf(fixture);
        Fill fill = {colour, fixture.sensor ? 0.0 : style::kFillOpacity * m_opacity};
        Pen pen = {colour, kEdgeWidth * m_unit, 0.95 * m_opacity, {}};
        if (fixture.sensor)
            pen.dash = {4.0 * m_unit, 3.0 * m_unit};
        const std::vector<bmr_vec2> points = PointsOf(fixture);
        if (fixture.shape == "circle") {
            const double radius = static_cast<double>(fixture.radius);
            m_canvas.Circle(points[0], radius, fill, pen);
            // A radius shows how it is turned.
            const bmr_vec2 axis = m_world.Turned(m_body.number, {fixture.radius, 0.0f});
            m_canvas.Segment(points[0], bmr_add(points[0], axis), pen);
        } else if (fixture.shape == "polygon") {
            m_canvas.Polygon(points, fill, pen);
        } else {
            pen.width = kChainWidth * m_unit;
            m_canvas.Polyline(points, pen);
        }
    }

    Canvas &m_canvas;
    const WorldView &m_world;
    const Body &m_body;
    double m_unit, m_opacity;
};

} // namespace

std::string StateOf(const Body &body, const Fixture &fixture) {
    if (body.disabled)
        return "disabled";
    if (fixture.sensor)
        return "sensor";
    return body.type == "dynamic" && body.asleep ? "sleeping" : body.type;
}

Colour ColourOfState(const std::string &state) {
    if (state == "sleeping")
        return style::kSleeping;
    if (state == "kinematic")
        return style::kKinematic;
    if (state == "static")
        return style::kStatic;
    if (state == "sensor")
        return style::kSensor;
    if (state == "disabled")
        return style::kDisabled;
    return style::kDynamic;
}

void DrawBodies(Canvas &canvas, const WorldView &world, double unit, const std::function<bool(int)> &isDim) {
    for (const bool resting : {true, false}) {
        // Box2D's list has the newest body first; the oldest is to lie below.
        const std::vector<Body> &bodies = world.Frame().bodies;
        for (auto body = bodies.rbegin(); body != bodies.rend(); ++body)
            if ((body->type == "static") == resting)
                BodyPainter(canvas, world, *body, unit, isDim(body->number)).Draw();
    }
}

void DrawJoints(Canvas &canvas, const WorldView &world, double unit) {
    const Pen pen = {style::kJoint, 1.2 * unit, 0.8, {}};
    for (const shown::Joint &joint : world.Frame().joints) {
        std::vector<bmr_vec2> line;
        for (const shown::Vec &point : joint.line)
            line.push_back(ToVec2(point));
        canvas.Polyline(line, pen);
        for (const std::size_t anchor : {1U, 2U})
            canvas.Dot(line[anchor], 2.0 * unit, style::kJoint);
    }
}

void DrawBoxes(Canvas &canvas, const WorldView &world, double unit) {
    const Pen pen = {style::kBox, 0.8 * unit, 0.6, {1.0 * unit, 3.0 * unit}};
    for (const shown::Box &box : world.Frame().boxes) {
        const bmr_vec2 low = ToVec2({box.left, box.bottom}), high = ToVec2({box.right, box.top});
        canvas.Box({low.x, low.y, high.x, high.y}, {}, pen);
    }
}

void DrawPeriodicBox(Canvas &canvas, const Rectangle &box, double unit) {
    canvas.Box(box, {}, {style::kText, 1.6 * unit, 0.8, {9.0 * unit, 5.0 * unit}});
}

void DrawTrails(Canvas &canvas, const std::map<int, std::deque<bmr_vec2>> &trails, double longest,
                double unit) {
    for (const auto &[body, places] : trails)
        for (std::size_t i = 1; i < places.size(); ++i) {
            const bmr_vec2 step = bmr_sub(places[i], places[i - 1]);
            if (std::hypot(step.x, step.y) > longest)
                continue;
            const double age = static_cast<double>(i) / static_cast<double>(places.size());
            canvas.Segment(places[i - 1], places[i], {style::kTrail, 1.3 * unit, age, {}});
        }
}

void DrawContacts(Canvas &canvas, const WorldView &world, double unit) {
    constexpr double kShortest = 4.0, kLongest = 16.0;
    float most = 0.0f;
    for (const shown::Contact &contact : world.Frame().touching)
        for (const shown::ContactPoint &point : contact.points)
            most = std::max(most, point.impulse);
    const Pen pen = {style::kContact, 1.1 * unit, 0.95, {}};
    for (const shown::Contact &contact : world.Frame().touching) {
        for (const shown::ContactPoint &point : contact.points) {
            const double share = most > 0.0f ? std::sqrt(static_cast<double>(point.impulse / most)) : 0.0;
            const double length = (kShortest + share * (kLongest - kShortest)) * unit / canvas.Scale();
            const bmr_vec2 at = ToVec2(point.at);
            canvas.Segment(at, bmr_add(at, bmr_scale(length, ToVec2(contact.normal))), pen);
            canvas.Dot(at, 2.0 * unit, style::kContact);
        }
    }
}

} // namespace testbed
