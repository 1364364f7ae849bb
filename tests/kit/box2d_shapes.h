// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_BOX2D_SHAPES_H
#define BOOMERANG_TEST_BOX2D_SHAPES_H

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <box2d/b2_collision.h>
#include <box2d/b2_draw.h>
#include <box2d/b2_polygon_shape.h>

#include "exact_distance.h"
#include "random.h"

/// @file
/// Random fixtures for tests against Box2D itself, and where they lie.

namespace shapes {

/// kit/random.h's, as a class.
struct Engine {
    explicit Engine(uint64_t seed) : random(test_random_from(seed)) {}
    test_random random;
};

inline double Uniform(Engine &engine, double low, double high) {
    return test_random_uniform(&engine.random, low, high);
}

inline float UniformF(Engine &engine, double low, double high) {
    return static_cast<float>(Uniform(engine, low, high));
}

inline int Below(Engine &engine, int count) {
    return static_cast<int>(test_random_below(&engine.random, static_cast<uint32_t>(count)));
}

/// Points on a circle, in order; the first one is turned by so much.
inline std::vector<b2Vec2> Circle(int count, double radius, double x = 0.0, double y = 0.0,
                                  double turned = 0.0) {
    std::vector<b2Vec2> points;
    for (int i = 0; i < count; ++i) {
        const double angle = turned + 2.0 * 3.14159265358979323846 * i / count;
        points.emplace_back(static_cast<float>(x + radius * std::cos(angle)),
                            static_cast<float>(y + radius * std::sin(angle)));
    }
    return points;
}

/// Of 3 to 8 vertices; sizes over three decades; a third of them boxes, some of these needles. It lies within
/// `extent` of its body's origin.
inline b2PolygonShape RandomPolygon(Engine &engine, double extent) {
    const double size = std::min(extent / 3.0, std::pow(10.0, Uniform(engine, -1.0, 1.5)));
    const b2Vec2 center(UniformF(engine, -size, size), UniformF(engine, -size, size));
    b2PolygonShape polygon;
    if (Below(engine, 3) == 0) {
        const double aspect = std::pow(10.0, Uniform(engine, -1.5, 0.0));
        polygon.SetAsBox(static_cast<float>(size), static_cast<float>(std::max(0.02, size * aspect)), center,
                         UniformF(engine, -3.2, 3.2));
        return polygon;
    }
    // Points near a circle, one per sector, so that Set's weld never leaves fewer than three.
    const int count = 3 + Below(engine, 6);
    b2Vec2 points[b2_maxPolygonVertices];
    for (int i = 0; i < count; ++i) {
        const double angle = (i + Uniform(engine, 0.1, 0.9)) * 2.0 * 3.14159265358979 / count;
        const double distance = size * Uniform(engine, 0.8, 1.0);
        points[i] = center + b2Vec2(static_cast<float>(distance * std::cos(angle)),
                                    static_cast<float>(distance * std::sin(angle)));
    }
    polygon.Set(points, count);
    return polygon;
}

inline b2Transform RandomPose(Engine &engine, double range) {
    b2Transform xf;
    xf.Set(b2Vec2(UniformF(engine, -range, range), UniformF(engine, -range, range)),
           UniformF(engine, -3.2, 3.2));
    return xf;
}

struct Point {
    double x, y;
};

inline Point Place(const b2Transform &xf, const b2Vec2 &v) {
    const double s = xf.q.s, c = xf.q.c, x = v.x, y = v.y;
    return {c * x - s * y + double{xf.p.x}, s * x + c * y + double{xf.p.y}};
}

inline exact::Posed PosedOf(const b2PolygonShape &shape, const b2Transform &xf) {
    std::vector<bmr_vec2> points;
    for (int32 i = 0; i < shape.m_count; ++i)
        points.push_back({shape.m_vertices[i].x, shape.m_vertices[i].y});
    return exact::PosedOf(points, {{xf.p.x, xf.p.y}, xf.q.c, xf.q.s});
}

} // namespace shapes

/// A drawer that draws nothing: tests override what they look at.
struct IdleDraw : b2Draw {
    void DrawPolygon(const b2Vec2 *, int32, const b2Color &) override {}
    void DrawSolidPolygon(const b2Vec2 *, int32, const b2Color &) override {}
    void DrawCircle(const b2Vec2 &, float, const b2Color &) override {}
    void DrawSolidCircle(const b2Vec2 &, float, const b2Vec2 &, const b2Color &) override {}
    void DrawSegment(const b2Vec2 &, const b2Vec2 &, const b2Color &) override {}
    void DrawTransform(const b2Transform &) override {}
    void DrawPoint(const b2Vec2 &, float, const b2Color &) override {}
};

#endif
