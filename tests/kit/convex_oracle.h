// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_CONVEX_ORACLE_H
#define BOOMERANG_TEST_CONVEX_ORACLE_H

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <box2d/b2_distance.h>
#include <box2d/b2_time_of_impact.h>

#include "box2d_shapes.h"
#include "convex32/convex32_distance.h"

/// @file
/// Convex polygons of any size for tests, in all the forms that are asked about.

namespace oracle {

using exact::Distance;
using shapes::Below;
using shapes::Engine;
using shapes::Uniform;

/// A polygon in all the forms that the tests ask about. `vertices` is what all of them have.
struct Polygon {
    std::vector<b2Vec2> vertices;
    float radius = 0.0f;
    bmr_convex32_block *block = nullptr; ///< NULL of fewer than 3 vertices

    explicit Polygon(const std::vector<b2Vec2> &points, float skin) : vertices(points), radius(skin) {
        if (points.size() < 3)
            return;
        if (bmr_convex32_create(reinterpret_cast<const bmr_vec32 *>(points.data()), points.size(), nullptr,
                                &block) != BMR_OK)
            return;
        const auto *kept = reinterpret_cast<const b2Vec2 *>(block->polygon.vertices);
        vertices.assign(kept, kept + block->polygon.count);
    }
    Polygon(Polygon &&other) noexcept
        : vertices(std::move(other.vertices)), radius(other.radius), block(other.block) {
        other.block = nullptr;
    }
    Polygon(const Polygon &) = delete;
    Polygon &operator=(const Polygon &) = delete;
    ~Polygon() { bmr_convex32_destroy(block, nullptr); }

    uint32_t Count() const { return static_cast<uint32_t>(vertices.size()); }
    bmr_proxy32 Ours() const {
        return block != nullptr ? bmr_proxy32_polygon(block, radius)
                                : bmr_proxy32_points(reinterpret_cast<const bmr_vec32 *>(vertices.data()),
                                                     Count(), radius);
    }
    /// Box2D's own, of all vertices (at most 255).
    b2DistanceProxy Stock() const {
        b2DistanceProxy proxy;
        proxy.m_buffer[0] = proxy.m_buffer[1] = b2Vec2_zero;
        proxy.Set(vertices.data(), static_cast<int32>(vertices.size()), radius);
        return proxy;
    }
};

/// About `count` points on an ellipse, or that many at random on it, around a centre off the origin.
inline Polygon RandomPolygon(Engine &engine, int count, float radius) {
    const double size = std::pow(10.0, Uniform(engine, -1.0, 0.7));
    const double aspect = Below(engine, 2) == 0 ? 1.0 : std::pow(10.0, Uniform(engine, -1.5, 0.0));
    const double phase = Uniform(engine, 0.0, 6.3), tilt = Uniform(engine, 0.0, 6.3);
    const double x = Uniform(engine, -size, size), y = Uniform(engine, -size, size);
    const bool regular = Below(engine, 2) == 0;
    std::vector<b2Vec2> points;
    for (int i = 0; i < count; ++i) {
        const double angle =
            phase + (i + (regular ? 0.0 : Uniform(engine, -0.4, 0.4))) * 6.283185307179586 / count;
        const double px = size * std::cos(angle), py = aspect * size * std::sin(angle);
        points.emplace_back(static_cast<float>(x + std::cos(tilt) * px - std::sin(tilt) * py),
                            static_cast<float>(y + std::sin(tilt) * px + std::cos(tilt) * py));
    }
    return Polygon(points, radius);
}

inline exact::Posed Placed(const Polygon &polygon, const bmr_pose &pose) {
    std::vector<bmr_vec2> points;
    for (const b2Vec2 &v : polygon.vertices)
        points.push_back({v.x, v.y});
    return {points, pose};
}
inline exact::Posed Placed(const Polygon &polygon, const b2Transform &xf) {
    return Placed(polygon, bmr_pose{{xf.p.x, xf.p.y}, xf.q.c, xf.q.s});
}

inline exact::Posed At(const Polygon &polygon, const b2Sweep &sweep, double t) {
    const double angle = (1.0 - t) * double{sweep.a0} + t * double{sweep.a};
    const double s = std::sin(angle), c = std::cos(angle), lx = sweep.localCenter.x, ly = sweep.localCenter.y;
    const double x = (1.0 - t) * double{sweep.c0.x} + t * double{sweep.c.x};
    const double y = (1.0 - t) * double{sweep.c0.y} + t * double{sweep.c.y};
    return Placed(polygon, bmr_pose{{x - (c * lx - s * ly), y - (s * lx + c * ly)}, c, s});
}

inline bmr_sweep32 Sweep32(const b2Sweep &sweep) {
    return {{sweep.localCenter.x, sweep.localCenter.y},
            {sweep.c0.x, sweep.c0.y},
            {sweep.c.x, sweep.c.y},
            sweep.a0,
            sweep.a,
            sweep.alpha0};
}

} // namespace oracle

#endif
