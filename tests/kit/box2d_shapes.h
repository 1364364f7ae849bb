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

#include "polygon_distance.h"
#include "random.h"

/// @file
/// Random fixtures for tests against Box2D itself, and their true distance in double precision.

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

/// What is true of two convex polygons at float poses, radii left out.
struct Truth {
    double distance;  ///< 0 where they overlap
    bool cornersOnly; ///< the closest points are a corner of each
};

/// Of all sides against all corners; one of the two may be a point.
inline Truth Measure(const std::vector<Point> &a, const std::vector<Point> &b) {
    bool separated = false;
    double least = INFINITY, corners = INFINITY;
    for (const bool turned : {false, true}) {
        const std::vector<Point> &mine = turned ? b : a, &theirs = turned ? a : b;
        for (size_t i = 0; i < mine.size(); ++i) {
            const Point from = mine[i], to = mine[i + 1 < mine.size() ? i + 1 : 0];
            double side = INFINITY;
            for (const Point &p : theirs) {
                const distance::Point way = distance::ToSegment({p.x, p.y}, {from.x, from.y}, {to.x, to.y});
                least = std::min(least, static_cast<double>(std::hypot(way.x, way.y)));
                corners = std::min(corners, std::hypot(p.x - from.x, p.y - from.y));
                side = std::min(side, (to.y - from.y) * (p.x - from.x) - (to.x - from.x) * (p.y - from.y));
            }
            separated = separated || side > 0.0;
        }
    }
    return {separated ? least : 0.0, separated && corners <= least};
}

inline std::vector<Point> PlacedCorners(const b2PolygonShape &shape, const b2Transform &xf) {
    std::vector<Point> points;
    for (int i = 0; i < shape.m_count; ++i)
        points.push_back(Place(xf, shape.m_vertices[i]));
    return points;
}

inline Truth Measure(const b2PolygonShape &a, const b2Transform &xfA, const b2PolygonShape &b,
                     const b2Transform &xfB) {
    return Measure(PlacedCorners(a, xfA), PlacedCorners(b, xfB));
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
