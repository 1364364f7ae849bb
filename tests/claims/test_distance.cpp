// SPDX-License-Identifier: MIT
// Distance and closest points where they are hard (at random: random/fuzz_queries.cpp), and of many vertices
// against the certificate that an answer is: two points, and a line between the polygons.
extern "C" {
#include "geometry/distance.h"
}
#include "boomerang/distance.h"
#include "cases.h"
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

/// Elementary steps that are enough: up to four looks at the support vertices of both, each a climb of 12
/// that is given up and a binary search; two for each look that halves one of two chains; and some for what
/// is around the end.
unsigned EnoughSteps(const Scene &s) {
    const double a = std::ceil(std::log2(s.a->count)), b = std::ceil(std::log2(s.b->count));
    return static_cast<unsigned>(4.0 * (2.0 * 13.0 + a + b) + 2.0 * (a + b + 2.0)) + 8;
}

unsigned StepsOf(const Scene &s) {
    bmr_closest_points answer;
    unsigned steps = 0;
    REQUIRE(bmr_distance_counted(s.a, &s.pose_a, s.b, &s.pose_b, &answer, &steps) == BMR_OK);
    return steps;
}

} // namespace

TEST_CASE("a distance takes a logarithmic number of steps") {
    test_random random = test_random_from(77);
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

// --- the search for the closest direction against rational arithmetic, on every family, at
// distances from 1e-9 to 30 times the shapes: the separation that it reports is the distance, up to the
// tolerance and the rounding of the posed vertices ---

namespace {

/// In some 20 of these a search that takes the distance of a segment from its difference loses up to 4 %.
constexpr size_t kPairs = 16000;
constexpr int kPlaces = 8;
/// A posed vertex has two products, two sums and a difference of coordinates below the scale, each rounded by
/// at most 2^-53: 5.6e-16 of the scale in each coordinate, 7.8e-16 as a vector.
constexpr long double kRounding = 8e-16L;

using exact::Posed, exact::PosedOf, exact::SignedDistance;

struct Tally {
    size_t queries = 0, near = 0, starts = 0;
};

/// log2 of all vertices, rounded up.
unsigned Levels(const bmr_polygon *a, const bmr_polygon *b) {
    unsigned levels = 0;
    while ((size_t{1} << levels) < size_t{a->count} + b->count)
        ++levels;
    return levels;
}

/// Elementary steps that bmr_closest_start may take: up to four looks at the support vertices of both, each a
/// climb of 12 that is given up and a binary search, and then every look halves one of two chains.
unsigned MostSteps(const bmr_polygon *a, const bmr_polygon *b) {
    const unsigned levels = Levels(a, b);
    return 4 * 2 * (13 + levels) + 2 * 2 * (levels + 1);
}

/// The start that is found, and how far its vertices or its edge and vertex are from being the closest.
bmr_simplex Start(const bmr_polygon *a, const bmr_polygon *b, const bmr_pose &pose, const bmr_simplex &near,
                  Tally &tally) {
    bmr_simplex start;
    bmr_closest_start(a, b, &pose, &near, &start);
    const auto part = [&start](const bmr_polygon *p, const uint32_t *vertices, const bmr_pose &at) {
        return Posed{{p->vertices[vertices[0]], p->vertices[vertices[start.count - 1]]}, at};
    };
    const long double of = SignedDistance(part(a, start.a, bmr_pose_identity()), part(b, start.b, pose)),
                      distance = SignedDistance(PosedOf(a), PosedOf(b, pose));
    const long double scale = a->extent + b->extent + std::hypot(pose.position.x, pose.position.y);
    ++tally.starts;
    // An angle is known to the rounding over the distance, and what it costs is its square.
    const long double angle = kRounding * scale / distance;
    CHECK(of <= distance * (1.0L + BMR_DISTANCE_TOLERANCE) + 4.0L * kRounding * scale +
                    scale * std::min(1.0L, 64.0L * angle * angle));
    CHECK(start.steps <= MostSteps(a, b));
    return start;
}

void Judge(const Posed &a, const Posed &b, const bmr_closest &closest, long double scale, Tally &tally) {
    const long double distance = SignedDistance(a, b), slop = kRounding * scale;
    ++tally.queries;
    tally.near += distance < 1e-6L;
    CHECK(closest.separation >= distance / (1.0L + BMR_DISTANCE_TOLERANCE) - slop);
    CHECK(closest.separation <= distance + slop);
    CHECK(exact::SeparationAlong(closest.direction, a, b) >= closest.separation - 2.0L * slop);
}

/// Two random polygons in random directions from one another, each time at a random distance.
void RunOne(uint64_t seed, Tally &tally) {
    test_random random = test_random_from(seed);
    const auto any = [&random]() {
        return test_polygon(static_cast<test_family>(test_random_below(&random, TEST_FAMILY_COUNT)),
                            3 + test_random_below(&random, 60), &random);
    };
    bmr_polygon *a = any(), *b = any();
    const auto from = [&random, a, b]() {
        return bmr_simplex_make(test_random_below(&random, a->count), test_random_below(&random, b->count));
    };
    for (int place = 0; place < kPlaces; ++place) {
        const double angle = test_random_uniform(&random, -3.2, 3.2),
                     side = test_random_uniform(&random, -3.2, 3.2),
                     wanted = std::pow(10.0, test_random_uniform(&random, -9.0, 1.5));
        bmr_pose pose = {bmr_vec2_make(100.0 * std::cos(side), 100.0 * std::sin(side)), std::cos(angle),
                         std::sin(angle)};
        bmr_simplex simplex = from();
        bmr_closest closest;
        // Each step towards A leaves a smaller part of the distance to be corrected sideways.
        bool apart = true;
        for (int step = 0; step < 4 && apart; ++step) {
            apart = bmr_closest_direction(a, b, &pose, 0.0, 0.0, &simplex, &closest);
            if (apart)
                pose.position =
                    bmr_sub(pose.position, bmr_scale(closest.separation - wanted, closest.direction));
        }
        // From anywhere, from where the search for a start leads from anywhere, or from where it ended.
        const uint32_t way = test_random_below(&random, 3);
        if (way < 2)
            simplex = from();
        if (way == 1 && apart)
            simplex = Start(a, b, pose, simplex, tally);
        if (bmr_closest_direction(a, b, &pose, 0.0, 0.0, &simplex, &closest))
            Judge(PosedOf(a), PosedOf(b, pose), closest,
                  a->extent + b->extent + std::hypot(pose.position.x, pose.position.y), tally);
    }
    std::free(a);
    std::free(b);
}

} // namespace

TEST_CASE("the closest direction separates by the distance") {
    Tally tally;
    for (size_t pair = 0; pair < test_scaled(kPairs); ++pair)
        RunOne(7919u * pair + 13u, tally);
    MESSAGE(tally.queries << " queries, " << tally.near << " of them near");
    const bool enoughNear = tally.near > tally.queries / 10;
    CHECK(enoughNear); // a test without near pairs shows little
    const bool enoughStarts = tally.starts > tally.queries / 4;
    CHECK(enoughStarts);
}

TEST_CASE("the search for a start takes logarithmically many steps, where vertices crowd too") {
    // On a parabola each vertex half as far from the lowest one as the one before: iterations that go from
    // vertex to vertex pass all of them.
    std::vector<bmr_vec2> points, turned;
    for (int k = 0; k < 48; ++k)
        points.push_back(bmr_vec2_make(std::pow(2.0, -k), std::pow(4.0, -k)));
    for (const bmr_vec2 &p : points)
        turned.push_back(bmr_vec2_make(p.x, -1e-24 - p.y));
    bmr_polygon *a = nullptr, *b = nullptr;
    REQUIRE(bmr_polygon_create(turned.data(), turned.size(), nullptr, &a) == BMR_OK);
    REQUIRE(bmr_polygon_create(points.data(), points.size(), nullptr, &b) == BMR_OK);
    const bmr_pose pose = bmr_pose_identity();
    unsigned most = 0, mostAfter = 0, mostWithout = 0;
    for (uint32_t i = 0; i < a->count; ++i)
        for (uint32_t j = 0; j < b->count; ++j) {
            const bmr_simplex near = bmr_simplex_make(i, j);
            bmr_simplex start, without = near;
            REQUIRE(bmr_closest_start(a, b, &pose, &near, &start));
            most = std::max(most, start.steps);
            bmr_closest closest;
            const unsigned before = start.steps;
            REQUIRE(bmr_closest_direction(a, b, &pose, 0.0, 0.0, &start, &closest));
            mostAfter = std::max(mostAfter, start.steps - before);
            REQUIRE(bmr_closest_direction(a, b, &pose, 0.0, 0.0, &without, &closest));
            mostWithout = std::max(mostWithout, without.steps);
        }
    MESSAGE("crowded vertices: " << most << " steps, then " << mostAfter << "; iterating first "
                                 << mostWithout);
    CHECK(most <= MostSteps(a, b));
    CHECK(mostAfter <= 16);
    // A query that starts anywhere iterates a few times, each with two supports, and then has the start
    // searched for. Without that search it takes 1218 steps here.
    CHECK(mostWithout > most); // it is another way
    CHECK(mostWithout <= MostSteps(a, b) + 10 * 2 * (13 + Levels(a, b)));
    std::free(a);
    std::free(b);
    for (size_t n = 64; n <= 32768; n *= 8) {
        test_random random = test_random_from(n);
        bmr_polygon *p = test_polygon(TEST_ELLIPSE, n, &random), *q = test_polygon(TEST_CIRCLE, n, &random);
        unsigned mostHere = 0;
        for (int k = 0; k < 400; ++k) {
            const double side = test_random_uniform(&random, -3.2, 3.2),
                         turn = test_random_uniform(&random, -3.2, 3.2);
            const bmr_pose there = {bmr_vec2_make(5.0 * std::cos(side), 5.0 * std::sin(side)), std::cos(turn),
                                    std::sin(turn)};
            const bmr_simplex near =
                bmr_simplex_make(test_random_below(&random, p->count), test_random_below(&random, q->count));
            bmr_simplex start;
            REQUIRE(bmr_closest_start(p, q, &there, &near, &start));
            mostHere = std::max(mostHere, start.steps);
            bmr_closest closest;
            const unsigned before = start.steps;
            REQUIRE(bmr_closest_direction(p, q, &there, 0.0, 0.0, &start, &closest));
            CHECK(start.steps - before <= 16);
        }
        MESSAGE(n << " vertices: at most " << mostHere << " steps");
        CHECK(mostHere <= MostSteps(p, q));
        std::free(p);
        std::free(q);
    }
}
