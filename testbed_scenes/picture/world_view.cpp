// SPDX-License-Identifier: MIT
#include "picture/world_view.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace testbed {

using shown::Body;
using shown::Fixture;
using shown::Pose;
using shown::Vec;

WorldView::WorldView(const shown::Frame &frame) : m_frame(frame) {
    for (const Body &body : frame.bodies)
        m_bodies[body.number] = &body;
    for (const Fixture &fixture : frame.fixtures)
        m_fixtures[fixture.body].push_back(&fixture);
    for (auto &[body, fixtures] : m_fixtures)
        std::sort(fixtures.begin(), fixtures.end(),
                  [](const Fixture *one, const Fixture *other) { return one->number < other->number; });
    for (const shown::Outline &outline : frame.outlines)
        m_outlines[outline.id] = &outline;
}

const Body *WorldView::FindBody(int number) const {
    const auto found = m_bodies.find(number);
    return found != m_bodies.end() ? found->second : nullptr;
}

const Pose &WorldView::PoseOf(int body) const {
    const Body *found = FindBody(body);
    if (found == nullptr)
        throw std::runtime_error("there is no body " + std::to_string(body) + " in step " +
                                 std::to_string(m_frame.step));
    return found->pose;
}

const std::vector<const Fixture *> &WorldView::FixturesOf(int body) const {
    static const std::vector<const Fixture *> none;
    const auto found = m_fixtures.find(body);
    return found != m_fixtures.end() ? found->second : none;
}

const shown::Outline *WorldView::FindOutline(int id) const {
    const auto found = m_outlines.find(id);
    return found != m_outlines.end() ? found->second : nullptr;
}

bmr_vec2 WorldView::ToWorld(int body, const Vec &point) const {
    return ToVec2(Transform(PoseOf(body), point));
}

std::vector<bmr_vec2> WorldView::ToWorld(int body, const std::vector<Vec> &points) const {
    const Pose &pose = PoseOf(body);
    std::vector<bmr_vec2> world;
    world.reserve(points.size());
    for (const Vec &point : points)
        world.push_back(ToVec2(Transform(pose, point)));
    return world;
}

bmr_vec2 WorldView::Turned(int body, const Vec &direction) const {
    return ToVec2(Rotate(PoseOf(body), direction));
}

Rectangle WorldView::BoxOf(const Fixture &fixture) const {
    Rectangle box = NoRectangle();
    const double radius = fixture.shape == "circle" ? static_cast<double>(fixture.radius) : 0.0;
    for (const bmr_vec2 &point : ToWorld(fixture.body, fixture.points))
        Grow(&box, point, radius);
    return box;
}

Rectangle WorldView::BoxOfBody(int body) const {
    Rectangle box = NoRectangle();
    for (const Fixture *fixture : FixturesOf(body))
        Grow(&box, BoxOf(*fixture));
    return box;
}

bmr_vec2 ToVec2(const Vec &v) {
    return bmr_vec2_make(static_cast<double>(v.x), static_cast<double>(v.y));
}

Rectangle NoRectangle() {
    constexpr double kFar = std::numeric_limits<double>::max();
    return {kFar, kFar, -kFar, -kFar};
}

bool IsEmpty(const Rectangle &box) {
    return box.left > box.right || box.bottom > box.top;
}

void Grow(Rectangle *box, bmr_vec2 point, double radius) {
    Grow(box, {point.x - radius, point.y - radius, point.x + radius, point.y + radius});
}

void Grow(Rectangle *box, const Rectangle &other) {
    *box = {std::min(box->left, other.left), std::min(box->bottom, other.bottom),
            std::max(box->right, other.right), std::max(box->top, other.top)};
}

Rectangle Intersection(const Rectangle &a, const Rectangle &b) {
    return {std::max(a.left, b.left), std::max(a.bottom, b.bottom), std::min(a.right, b.right),
            std::min(a.top, b.top)};
}

Rectangle Widened(const Rectangle &box, double share) {
    const double by = share * std::max(box.Width(), box.Height());
    return {box.left - by, box.bottom - by, box.right + by, box.top + by};
}

} // namespace testbed
