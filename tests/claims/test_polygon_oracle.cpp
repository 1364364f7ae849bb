// SPDX-License-Identifier: MIT
// The hull and its predicate against CGAL's exact kernel.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/convex_hull_2.h>

#include "boomerang/polygon.h"
#include "geometry/predicates.h"
#include "polygons.h"
#include "test_scale.h"

namespace {

using Filtered = CGAL::Exact_predicates_inexact_constructions_kernel;
using Rational = CGAL::Simple_cartesian<CGAL::Gmpq>; // no filter, no floating point at all

struct Points : std::vector<bmr_vec2> {
    using std::vector<bmr_vec2>::vector;
};

bool same(bmr_vec2 a, bmr_vec2 b) {
    return a.x == b.x && a.y == b.y;
}

/// As scaled, but enough for every control to see what it waits for.
std::size_t rounds(std::size_t count) {
    return std::max<std::size_t>(test_scaled(count), 500);
}

/// The strictly convex hull by CGAL, from the lowest (then leftmost) point on.
template <class Kernel> Points exact_hull(const Points &points) {
    using Point = typename Kernel::Point_2;
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

/// A monotone chain with the plain determinant: what the oracle must be able to tell from an exact one.
Points naive_hull(Points points) {
    const auto below = [](bmr_vec2 a, bmr_vec2 b) { return a.y < b.y || (a.y == b.y && a.x < b.x); };
    std::sort(points.begin(), points.end(), below);
    points.erase(std::unique(points.begin(), points.end(), same), points.end());
    if (points.size() < 3)
        return points;
    Points hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t fixed = hull.size() + 1;
        for (const bmr_vec2 &p : points) {
            while (hull.size() > fixed &&
                   bmr_cross(bmr_sub(hull.back(), hull[hull.size() - 2]), bmr_sub(p, hull.back())) <= 0.0)
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

Points hard_points(test_random *random) {
    Points points(64);
    points.resize(test_hard_points(random, points.data()));
    return points;
}

double any_double(test_random *random) {
    const int exponent =
        static_cast<int>(test_random_below(random, 2090)) - 1070; // denormals to beyond 1e300
    const double magnitude = std::ldexp(test_random_uniform(random, 0.5, 1.0), exponent);
    switch (test_random_below(random, 5)) {
    case 0:
        return 0.0;
    case 1:
        return test_random_below(random, 8) - 4.0;
    case 2:
        return -magnitude;
    default:
        return magnitude;
    }
}

int exact_orientation(bmr_vec2 a, bmr_vec2 b, bmr_vec2 c) {
    return static_cast<int>(CGAL::orientation(Rational::Point_2(a.x, a.y), Rational::Point_2(b.x, b.y),
                                              Rational::Point_2(c.x, c.y)));
}

} // namespace

TEST_CASE("the orientation of any three finite points is that of rational arithmetic") {
    test_random random = {1001};
    std::size_t wrong = 0, naive_wrong = 0, zero = 0;
    for (std::size_t i = 0; i < rounds(40000); ++i) {
        bmr_vec2 p[3];
        for (bmr_vec2 &q : p)
            q = {any_double(&random), any_double(&random)};
        if (i % 3 == 0) { // nearly collinear
            const double t = test_random_uniform(&random, -2.0, 2.0);
            p[2] = bmr_add(p[0], bmr_scale(t, bmr_sub(p[1], p[0])));
            if (!std::isfinite(p[2].x) || !std::isfinite(p[2].y))
                continue;
        }
        const int expected = exact_orientation(p[0], p[1], p[2]);
        wrong += bmr_orientation(p[0], p[1], p[2]) != expected;
        zero += expected == 0;
        const double plain = bmr_cross(bmr_sub(p[1], p[0]), bmr_sub(p[2], p[0]));
        naive_wrong += (plain > 0.0) - (plain < 0.0) != expected;
    }
    CHECK(wrong == 0);
    CHECK(naive_wrong > 0); // control
    CHECK(zero > 0);
}

TEST_CASE("the hull of hard points is CGAL's exact hull, vertex for vertex") {
    test_random random = {1003};
    std::size_t wrong = 0, naive_wrong = 0;
    for (std::size_t i = 0; i < rounds(4000); ++i) {
        const Points points = hard_points(&random);
        const Points expected = exact_hull<Rational>(points);
        wrong += !equal(own_hull(points), expected);
        naive_wrong += !equal(naive_hull(points), expected);
    }
    CHECK(wrong == 0);
    CHECK(naive_wrong > 0); // control: a hull by plain determinants is told apart
}

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
            CHECK(equal(hull, exact_hull<Filtered>(points)));
            // Controls: a vertex less, a vertex moved by one ulp.
            Points damaged = hull;
            damaged.pop_back();
            CHECK_FALSE(equal(damaged, hull));
            damaged = hull;
            damaged.front().x = std::nextafter(damaged.front().x, 1e300);
            CHECK_FALSE(equal(damaged, hull));
        }
}

TEST_CASE("containment with tolerance 0 is exact") {
    test_random random = {1007};
    std::size_t wrong = 0, inside = 0, outside = 0, border = 0;
    for (std::size_t i = 0; i < rounds(3000); ++i) {
        const Points points = hard_points(&random);
        bmr_polygon *polygon = nullptr;
        REQUIRE(bmr_polygon_create(points.data(), points.size(), nullptr, &polygon) == BMR_OK);
        if (polygon->count >= 3)
            for (const bmr_vec2 &q : points) {
                const bmr_vec2 x = {q.x, std::nextafter(q.y, test_random_below(&random, 2) ? 1e300 : -1e300)};
                int least = 1;
                for (std::uint32_t e = 0; e < polygon->count; ++e)
                    least =
                        std::min(least, exact_orientation(polygon->vertices[e],
                                                          polygon->vertices[(e + 1) % polygon->count], x));
                wrong += bmr_polygon_contains(polygon, x, 0.0) != (least >= 0);
                inside += least > 0;
                border += least == 0;
                outside += least < 0;
            }
        bmr_polygon_destroy(polygon, nullptr);
    }
    CHECK(wrong == 0);
    CHECK(inside > 0); // controls: all answers occur
    CHECK(border > 0);
    CHECK(outside > 0);
}
