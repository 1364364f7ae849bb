// SPDX-License-Identifier: MIT
// Hulls of many points against a sort and a scan in rational arithmetic. Those of few, and the predicate, are
// left to tests/random/fuzz_polygon.cpp.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "boomerang/polygon.h"
#include "exact.h"
#include "polygons.h"

namespace {

struct Points : std::vector<bmr_vec2> {
    using std::vector<bmr_vec2>::vector;
};

bool same(bmr_vec2 a, bmr_vec2 b) {
    return a.x == b.x && a.y == b.y;
}

/// The strictly convex hull, from the lowest (then leftmost) point on: up to the highest, and back.
Points exact_hull(Points points) {
    std::sort(points.begin(), points.end(),
              [](bmr_vec2 a, bmr_vec2 b) { return a.y < b.y || (a.y == b.y && a.x < b.x); });
    points.erase(std::unique(points.begin(), points.end(), same), points.end());
    Points hull;
    for (int way = 0; way < 2; ++way) {
        const std::size_t first = hull.size(); // what the way up left stays, but for its last
        for (const bmr_vec2 &p : points) {
            while (hull.size() >= first + 2 && exact::Orientation(hull[hull.size() - 2], hull.back(), p) <= 0)
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

Points own_hull(const Points &points) {
    bmr_polygon *polygon = nullptr;
    REQUIRE(bmr_polygon_create(points.data(), points.size(), nullptr, &polygon) == BMR_OK);
    CHECK(bmr_polygon_audit(polygon) == BMR_OK);
    Points hull(polygon->vertices, polygon->vertices + polygon->count);
    bmr_polygon_destroy(polygon, nullptr);
    return hull;
}

bool equal(const Points &a, const Points &b) {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), same);
}

} // namespace

TEST_CASE("the hull of every family of polygons is that of rational arithmetic") {
    test_random random = {1005};
    for (int family = 0; family < TEST_FAMILY_COUNT; ++family)
        for (std::size_t n : {3u, 10u, 100u, 1000u, 4096u, 65535u}) {
            CAPTURE(test_family_name(static_cast<test_family>(family)));
            CAPTURE(n);
            Points points(n + 12);
            points.resize(test_points(static_cast<test_family>(family), n, &random, points.data()));
            if (points.size() > BMR_MAX_VERTICES)
                points.resize(BMR_MAX_VERTICES);
            Points hull = own_hull(points);
            CHECK(equal(hull, exact_hull(points)));
            // Controls: a vertex less, a vertex moved by one ulp.
            Points damaged = hull;
            damaged.pop_back();
            CHECK_FALSE(equal(damaged, hull));
            damaged = hull;
            damaged.front().x = std::nextafter(damaged.front().x, 1e300);
            CHECK_FALSE(equal(damaged, hull));
        }
}
