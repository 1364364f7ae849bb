// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_CONTRACTS_STAGE_H
#define BOOMERANG_TEST_CONTRACTS_STAGE_H

#include "boomerang/hierarchy.h"
#include "boomerang/pair.h"
#include "boomerang/polygon.h"
#include "contracts.h"

/// @file
/// Good objects, which the calls of contracts are made with. A program makes them once.

namespace contracts {

/// An ellipse's points, from radius `width` and `height`.
inline std::vector<bmr_vec2> Ellipse(size_t count, double width = 1.0, double height = 1.0) {
    std::vector<bmr_vec2> points;
    for (size_t i = 0; i < count; ++i) {
        const double angle =
            2.0 * 3.14159265358979323846 * static_cast<double>(i) / static_cast<double>(count);
        points.push_back({width * std::cos(angle), height * std::sin(angle)});
    }
    return points;
}
inline bmr_polygon *Polygon(const std::vector<bmr_vec2> &points) {
    bmr_polygon *polygon = nullptr;
    bmr_polygon_create(points.data(), points.size(), nullptr, &polygon);
    return polygon;
}

/// A polygon and its hierarchies.
struct Body {
    bmr_polygon *polygon;
    bmr_compass *compass = nullptr;
    bmr_hierarchy *hierarchies[BMR_HIERARCHY_KIND_COUNT] = {};

    explicit Body(const std::vector<bmr_vec2> &points) : polygon(Polygon(points)) {
        bmr_compass_create(64, nullptr, &compass);
        bmr_hierarchy_build_compass(polygon, compass, nullptr, &hierarchies[BMR_HIERARCHY_COMPASS]);
        bmr_hierarchy_build_dudley(polygon, nullptr, &hierarchies[BMR_HIERARCHY_DUDLEY]);
        bmr_hierarchy_build_dobkin_kirkpatrick(polygon, nullptr,
                                               &hierarchies[BMR_HIERARCHY_DOBKIN_KIRKPATRICK]);
    }
    Body(const Body &) = delete;
    Body &operator=(const Body &) = delete;
    ~Body() {
        for (bmr_hierarchy *hierarchy : hierarchies)
            bmr_hierarchy_destroy(hierarchy, nullptr);
        bmr_compass_destroy(compass, nullptr);
        bmr_polygon_destroy(polygon, nullptr);
    }
    bmr_shape Shape() const { return {polygon, {hierarchies[0], hierarchies[1], hierarchies[2]}, {}}; }
};

inline const Body &Square() {
    static const Body square({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
    return square;
}
inline const Body &Round() {
    static const Body round(Ellipse(60, 3.0));
    return round;
}

inline std::string VerticesOf(size_t count) {
    return std::to_string(count) + (count == 1 ? " vertex" : " vertices");
}

} // namespace contracts

#endif
