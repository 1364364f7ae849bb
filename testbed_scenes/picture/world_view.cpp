// SPDX-License-Identifier: MIT
#include "picture/world_view.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "picture/picture.h"

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

// --- which part of the world a picture shows ---

namespace {

/// Bodies outside of the middle part of all, widened by kReach of its size, are taken for runaways.
constexpr double kMiddleFrom = 0.05, kReach = 0.3;
/// Share of the region left empty around what it shows.
constexpr double kMargin = 0.04;
/// Share of the focus added around a body, for what is beside it.
constexpr double kAroundFocus = 0.25;
/// The picture's height is kept between these multiples of its width.
constexpr double kFlattest = 0.35, kTallest = 1.1;

double Quantile(std::vector<double> values, double share) {
    const auto index = static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)));
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(index), values.end());
    return values[index];
}

/// Around the moving bodies without runaways, with as much of the ground as lies near.
Rectangle RegionOfAll(const WorldView &world) {
    std::vector<Rectangle> moving, resting;
    for (const shown::Body &body : world.Frame().bodies) {
        for (const shown::Fixture *fixture : world.FixturesOf(body.number))
            (body.type == "static" ? resting : moving).push_back(world.BoxOf(*fixture));
    }
    if (moving.empty())
        std::swap(moving, resting);
    if (moving.empty())
        return {-1.0, -1.0, 1.0, 1.0};
    auto quantile = [&moving](double Rectangle::*side, double share) {
        std::vector<double> values;
        values.reserve(moving.size());
        for (const Rectangle &box : moving)
            values.push_back(box.*side);
        return Quantile(std::move(values), share);
    };
    const Rectangle middle = {
        quantile(&Rectangle::left, kMiddleFrom), quantile(&Rectangle::bottom, kMiddleFrom),
        quantile(&Rectangle::right, 1.0 - kMiddleFrom), quantile(&Rectangle::top, 1.0 - kMiddleFrom)};
    const Rectangle reach = Widened(middle, kReach);
    Rectangle region = middle;
    for (const std::vector<Rectangle> *boxes : {&moving, &resting}) {
        for (const Rectangle &box : *boxes)
            if (const Rectangle seen = Intersection(box, reach); !IsEmpty(seen))
                Grow(&region, seen);
    }
    return Widened(region, kMargin);
}

/// A body with its nearest gaps: those of up to kNearest pairs within kFarthest of its size, and the nearest
/// in any case.
Rectangle RegionOfOne(const WorldView &world, int number) {
    constexpr std::size_t kNearest = 4;
    constexpr double kFarthest = 3.0;
    std::vector<const shown::Pair *> pairs;
    for (const shown::Pair &pair : world.Frame().pairs)
        if ((pair.a == number || pair.b == number) && pair.polygon_contacts > 0 && pair.touching == 0)
            pairs.push_back(&pair);
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const auto *a, const auto *b) { return a->distance < b->distance; });
    pairs.resize(std::min(pairs.size(), kNearest));
    Rectangle region = world.BoxOfBody(number);
    if (IsEmpty(region)) // no fixtures
        Grow(&region, ToVec2(world.PoseOf(number).position), 1.0);
    const Rectangle near = Widened(region, kFarthest);
    for (const shown::Pair *pair : pairs) {
        Rectangle gap = NoRectangle();
        for (const shown::Vec &point : pair->closest)
            Grow(&gap, ToVec2(point));
        Rectangle both = near;
        Grow(&both, gap);
        const bool isNear = both.Width() <= near.Width() && both.Height() <= near.Height();
        if (isNear || pair == pairs[0])
            Grow(&region, gap);
    }
    return Widened(region, kAroundFocus);
}

/// A region of an awkward shape gets more of its surroundings, about its own middle.
Rectangle WithGoodShape(const Rectangle &region) {
    const double height = std::max({region.Height(), kFlattest * region.Width(), 1e-3});
    const double width = std::max(region.Width(), height / kTallest);
    const double x = 0.5 * (region.left + region.right), y = 0.5 * (region.bottom + region.top);
    return {x - 0.5 * width, y - 0.5 * height, x + 0.5 * width, y + 0.5 * height};
}

} // namespace

Rectangle RegionOf(const shown::Frame &frame, const PictureOptions &options) {
    const WorldView world(frame);
    if (options.region)
        return WithGoodShape(*options.region);
    return WithGoodShape(options.body ? RegionOfOne(world, *options.body) : RegionOfAll(world));
}

} // namespace testbed
