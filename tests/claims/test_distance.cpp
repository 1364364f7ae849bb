// SPDX-License-Identifier: MIT
// Distance, closest points and penetration where they are hard (at random: random/fuzz_queries.cpp), and of
// many vertices against the certificate that an answer is: two points, and a line between the polygons.
#include "boomerang/distance.h"
#include "cases.h"
#include "geometry/posed_polygons.h"
#include "polygons.h"
#include "query_oracle.h"

namespace {

using namespace query;

struct PolygonDeleter {
    void operator()(bmr_polygon *p) const { bmr_polygon_destroy(p, nullptr); }
};
using Polygon = std::unique_ptr<bmr_polygon, PolygonDeleter>;

Polygon Hull(const std::vector<bmr_vec2> &points) {
    bmr_polygon *polygon = nullptr;
    REQUIRE(bmr_polygon_create(points.data(), points.size(), nullptr, &polygon) == BMR_OK);
    return Polygon(polygon);
}

/// A is anywhere; B beside it, with its supports `gap` apart in some direction.
Scene Beside(const bmr_polygon *a, const bmr_polygon *b, double gap, test_random *random) {
    const double way = test_random_uniform(random, -4, 4);
    const bmr_vec2 u = {std::cos(way), std::sin(way)};
    const bool axes = test_random_below(random, 4) == 0; // sides that are exactly parallel
    const bmr_pose turned = bmr_pose_from_angle({0, 0}, axes ? 0.0 : test_random_uniform(random, -4, 4));
    const bmr_vec2 pa = a->vertices[bmr_polygon_support(a, u)];
    const bmr_vec2 pb =
        bmr_rotate(&turned, b->vertices[bmr_polygon_support(b, bmr_unrotate(&turned, bmr_neg(u)))]);
    const double slide = test_random_uniform(random, -0.3, 0.3) * std::fmin(a->extent, b->extent);
    bmr_pose b_in_a = turned;
    b_in_a.position = bmr_add(bmr_sub(pa, pb), bmr_add(bmr_scale(gap, u), bmr_scale(slide, bmr_left(u))));
    const double far = test_random_below(random, 8) == 0 ? 1e7 : 1.0; // where rounding is that of the places
    const bmr_pose pose_a = bmr_pose_from_angle(
        {far * test_random_uniform(random, -5, 5), far * test_random_uniform(random, -5, 5)},
        axes ? 0.0 : test_random_uniform(random, -4, 4));
    bmr_pose pose_b = bmr_pose_from_angle(bmr_transform(&pose_a, b_in_a.position), 0.0);
    pose_b.c = pose_a.c * turned.c - pose_a.s * turned.s;
    pose_b.s = pose_a.s * turned.c + pose_a.c * turned.s;
    return SceneOf(a, pose_a, b, pose_b);
}

bmr_closest_points Closest(const Scene &s) {
    bmr_closest_points answer = {-1.0, {9, 9}, {9, 9}, {9, 9}};
    REQUIRE(bmr_distance(s.a, &s.pose_a, s.b, &s.pose_b, &answer) == BMR_OK);
    return answer;
}

bmr_overlap Overlap(const Scene &s) {
    bmr_overlap answer = {-1.0, {9, 9}, {9, 9}, {9, 9}};
    REQUIRE(bmr_penetration(s.a, &s.pose_a, s.b, &s.pose_b, &answer) == BMR_OK);
    return answer;
}

/// Elementary steps that are enough: up to four looks at the support vertices of both, each a climb of 12
/// that is given up and a binary search; two for each look that halves one of two chains; and some for what
/// is around the end.
unsigned EnoughSteps(const Scene &s) {
    const double a = std::ceil(std::log2(s.a->count)), b = std::ceil(std::log2(s.b->count));
    return static_cast<unsigned>(4.0 * (2.0 * 13.0 + a + b) + 2.0 * (a + b + 2.0)) + 8;
}

unsigned StepsOf(const Scene &s) {
    bmr_posed_polygons posed;
    bmr_closest_points answer;
    REQUIRE(bmr_posed_polygons_make(s.a, &s.pose_a, s.b, &s.pose_b, &answer, &posed) == BMR_OK);
    unsigned steps = 0;
    bmr_posed_polygons_closest(&posed, &steps, &answer);
    return steps;
}

} // namespace

TEST_CASE("a distance takes a logarithmic number of steps") {
    test_random random = {77};
    unsigned most = 0, most_small = 0;
    for (const size_t n : {size_t{16}, size_t{256}, size_t{4096}, size_t{60000}})
        for (size_t round = 0; round < test_scaled(60); ++round) {
            CAPTURE(n);
            CAPTURE(round);
            const test_family families[] = {TEST_REGULAR, TEST_ELLIPSE, TEST_NEEDLE, TEST_LENS, TEST_CLUSTER};
            const Polygon a(test_polygon(families[round % 5], n, &random)),
                b(test_polygon(families[test_random_below(&random, 5)], round % 2 ? n : 8, &random));
            const double gaps[] = {3.0, 0.2, 1e-2, 1e-4, 1e-8};
            const Scene s = Beside(a.get(), b.get(), gaps[test_random_below(&random, 5)], &random);
            const bmr_closest_points closest = Closest(s);
            if (closest.distance > 0.0)
                CHECK(ProvesItself(s, closest));
            const unsigned steps = StepsOf(s);
            CHECK(steps <= EnoughSteps(s));
            (n == 16 ? most_small : most) = std::max(n == 16 ? most_small : most, steps);
        }
    MESSAGE("steps at most " << most_small << " for 16 vertices, " << most << " for up to 60000");
    CHECK(most > most_small); // a count that does not grow would be no count
}

TEST_CASE("vertices that close in on a corner cost no more") {
    // (2^-k, 4^-k): each edge is half as steep and a quarter as long as the one before.
    std::vector<bmr_vec2> points = {{-1.0, 1.0}};
    for (int k = 0; k < 26; ++k)
        points.push_back({std::exp2(-k), std::exp2(-2 * k)});
    const Polygon a = Hull(points);
    for (bmr_vec2 &p : points)
        p.y = -p.y;
    const Polygon b = Hull(points);
    for (const double gap : {1.0, 1e-3, 1e-6, 1e-10}) {
        const Scene s = SceneOf(a.get(), bmr_pose_identity(), b.get(), bmr_pose_from_angle({0.0, -gap}, 0.0));
        const bmr_closest_points closest = Closest(s);
        CHECK(closest.distance > 0.0);
        CHECK(ProvesItself(s, closest));
        CHECK(StepsOf(s) <= EnoughSteps(s));
    }
}

TEST_CASE("a small polygon deep in a large one, far from the origin, is not called apart") {
    // An angle was allowed to be off by the rounding of the places in the
    // world.
    const Polygon a = Hull({{7.3242187499999997e-05, 4.8828125000000003e-05},
                            {0.00012207031250000038, 0.00012207031250000033},
                            {-4.019299523606901e-05, 0.00019114864444852192},
                            {-3.9127174143160158e-05, 0.0001898114207766129},
                            {-1.2348771397571428e-05, 0.00015621411792198371},
                            {6.0635171416422775e-05, 6.4645414084685813e-05}});
    const Polygon b = Hull({{-0.02813783983886553, -0.046896399731442551},
                            {0.02813783983886553, -0.046896399731442551},
                            {0.02813783983886553, 0.02813783983886553},
                            {-0.0093792799462885101, 0.02813783983886553},
                            {-0.046896399731442551, 0.0093792799462885101}});
    const Scene s = SceneOf(
        a.get(), {{47801116.269814961, -11471115.056382688}, 0.20440300167520839, -0.97888682333871713},
        b.get(), {{47801116.24920857, -11471115.013335792}, -0.60058233583423326, 0.79956291677634495});
    const long double truth = distance::SignedDistance(s.points_a, s.points_b);
    CHECK(truth < -9e-6L);
    CHECK(Closest(s).distance == 0.0);
    CHECK(Agrees(s, Overlap(s), -truth));
}

TEST_CASE("a vertex that lies on the middle of an edge is not far from it") {
    // Found by fuzz_queries: no direction told the two ends of the edge apart, and the distance was that of
    // one of them, 1.
    const Polygon a = Hull({{-0.65293827693672313, -0.75741112119568399},
                            {0.75741112119568399, -0.65293827693672313},
                            {0.65293827693672324, 0.75741112119568388}});
    const Polygon b = Hull({{-0.97616540779736016, -0.89837491416800186},
                            {0, 0},
                            {0, 11},
                            {-1172.559637859219, 0.50143672824218088}});
    const bmr_pose here = bmr_pose_identity();
    const Scene s = SceneOf(a.get(), here, b.get(), here);
    CHECK(Closest(s).distance <= s.tolerance);
    CHECK(Overlap(s).depth <= s.tolerance);
}

TEST_CASE("the normal has unit length where the square of the distance is a denormal number") {
    const Polygon a = Hull({{0.0, 0.0}}), b = Hull({{-1e-156, 0.0}, {4.0, 3.0}, {4.0, 5.0}});
    const Scene s = SceneOf(a.get(), bmr_pose_identity(), b.get(), bmr_pose_identity());
    const bmr_closest_points closest = Closest(s);
    CHECK(closest.distance == doctest::Approx(6e-157).epsilon(1e-14));
    CHECK(std::fabs(std::hypot(closest.normal.x, closest.normal.y) - 1.0) <= 1e-15);
    CHECK(ProvesItself(s, closest));
}

TEST_CASE("vertices that lie together are no way around a polygon") {
    // Of two such vertices the searches at both ends of an arc found the other one each. The last pair has a
    // direction that separates only at the second look.
    const uint64_t states[] = {340848928178076474u,  3519922534721490492u, 7694584163053262375u,
                               5479711179065206770u, 2373509614993089665u, 6808758188017056697u};
    for (size_t i = 0; i < 6; ++i) {
        CAPTURE(i);
        test_random random = {states[i]};
        std::vector<bmr_vec2> points[2] = {std::vector<bmr_vec2>(64), std::vector<bmr_vec2>(64)};
        for (std::vector<bmr_vec2> &of : points)
            of.resize(test_hard_points(&random, of.data()));
        const Polygon a = Hull(points[0]), b = Hull(points[1]);
        const double way = test_random_uniform(&random, -4, 4);
        const bmr_vec2 u = {std::cos(way), std::sin(way)};
        bmr_pose pose = bmr_pose_from_angle({0, 0}, i < 5 ? test_random_uniform(&random, -4, 4) : 0.0);
        const bmr_vec2 pa = a->vertices[bmr_polygon_support(a.get(), u)],
                       pb = bmr_rotate(
                           &pose, b->vertices[bmr_polygon_support(b.get(), bmr_unrotate(&pose, bmr_neg(u)))]);
        const double gap = std::pow(10, test_random_uniform(&random, -12, 1));
        pose.position = bmr_add(bmr_sub(pa, pb), bmr_scale(gap, u));
        const Scene s = SceneOf(a.get(), bmr_pose_identity(), b.get(), pose);
        const long double truth = distance::SignedDistance(s.points_a, s.points_b);
        CHECK(std::fabs(Closest(s).distance - std::fmax(0.0L, truth)) <= s.tolerance);
    }
}
