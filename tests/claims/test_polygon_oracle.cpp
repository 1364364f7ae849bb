// SPDX-License-Identifier: MIT
// Hulls of many points against CGAL's exact kernel; those of few, and the predicate, are held against
// rational arithmetic by tests/random/fuzz_polygon.cpp.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>

#include "boomerang/polygon.h"
#include "polygons.h"
#include "test_scale.h"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct Points : std::vector<bmr_vec2> {
    using std::vector<bmr_vec2>::vector;
};

bool same(bmr_vec2 a, bmr_vec2 b) {
    return a.x == b.x && a.y == b.y;
}

/// The strictly convex hull by CGAL, from the lowest (then leftmost) point on.
Points exact_hull(const Points &points) {
    using Point = Kernel::Point_2;
    std::vector<Point> in, out;
    for (const bmr_vec2 &p : points)
        in.emplace_back(p.x, p.y);
    CGAL::convex_hull_2(in.begin(), in.end(), std::back_inserter(out));
    Points hull;
    for (const Point &p : out)
        hull.push_back(
            {CGAL::to_double(p.x()), CGAL::to_double(p.y())}); // the coordinates given, hence exact
    const auto below = [](bmr_vec2 a, bmr_vec2 b) { return a.y < b.y || (a.y == b.y && a.x < b.x); };
    std::rotate(hull.begin(), std::min_element(hull.begin(), hull.end(), below), hull.end());
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

TEST_CASE("the hull of every family of polygons is CGAL's, by its filtered exact kernel") {
    test_random random = {1005};
    for (int family = 0; family < TEST_FAMILY_COUNT; ++family)
        for (std::size_t n : {3u, 10u, 100u, 1000u, 4096u, 65535u}) {
            if (n > 4096 && test_scaled(8) < 4) // CGAL takes most of a minute there under a sanitizer
                continue;
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
