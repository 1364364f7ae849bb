// SPDX-License-Identifier: MIT
// The search for the closest direction against all pairs of features in long double, on every family, at
// distances from 1e-9 to 30 times the shapes: the separation that it reports is the distance, up to the
// tolerance and the rounding of the posed vertices.
extern "C" {
#include "geometry/distance.h"
}
#include "cases.h"
#include "polygon_distance.h"
#include "polygons.h"

namespace {

/// In some 20 of these a search that takes the distance of a segment from its difference loses up to 4 %.
constexpr size_t kPairs = 16000;
constexpr int kPlaces = 8;
/// A posed vertex has two products, two sums and a difference of coordinates below the scale, each rounded by
/// at most 2^-53: 5.6e-16 of the scale in each coordinate, 7.8e-16 as a vector.
constexpr long double kRounding = 8e-16L;

using distance::Point, distance::Points, distance::Transformed;

/// Of polygons that are apart.
long double Distance(const Points &a, const Points &b) {
    long double least = INFINITY;
    for (size_t i = 0; i < a.size(); ++i)
        for (size_t j = 0; j < b.size(); ++j) {
            const Point toA = distance::ToSegment(b[j], a[i], a[(i + 1) % a.size()]),
                        toB = distance::ToSegment(a[i], b[j], b[(j + 1) % b.size()]);
            least = std::min({least, std::hypot(toA.x, toA.y), std::hypot(toB.x, toB.y)});
        }
    return least;
}

struct Tally {
    size_t queries = 0, near = 0, tooLittle = 0, tooMuch = 0, notSeparated = 0;
    size_t starts = 0, startedAfar = 0, tooManySteps = 0; ///< of bmr_closest_start
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
    const Points p = Transformed(a, {{0.0, 0.0}, 1.0, 0.0}), q = Transformed(b, pose);
    const auto apart = [&](uint32_t i) {
        return Point{q[start.b[i]].x - p[start.a[i]].x, q[start.b[i]].y - p[start.a[i]].y};
    };
    const Point first = apart(0), last = apart(start.count - 1);
    const Point way = distance::ToSegment({0.0L, 0.0L}, first, last);
    const long double of = std::hypot(way.x, way.y), distance = Distance(p, q);
    const long double scale = a->extent + b->extent + std::hypot(pose.position.x, pose.position.y);
    ++tally.starts;
    // An angle is known to the rounding over the distance, and what it costs is its square.
    const long double angle = kRounding * scale / distance;
    tally.startedAfar += of > distance * (1.0L + BMR_DISTANCE_TOLERANCE) + 4.0L * kRounding * scale +
                                  scale * std::min(1.0L, 64.0L * angle * angle);
    tally.tooManySteps += start.steps > MostSteps(a, b);
    return start;
}

void Judge(const Points &a, const Points &b, const bmr_closest &closest, long double scale, Tally &tally) {
    const long double distance = Distance(a, b), slop = kRounding * scale;
    ++tally.queries;
    tally.near += distance < 1e-6L;
    tally.tooLittle += closest.separation < distance / (1.0L + BMR_DISTANCE_TOLERANCE) - slop;
    tally.tooMuch += closest.separation > distance + slop;
    tally.notSeparated += distance::SeparationAlong(a, b, closest.direction.x, closest.direction.y) <
                          closest.separation - 2.0L * slop;
}

/// Two random polygons in random directions from one another, each time at a random distance.
void RunOne(uint64_t seed, Tally &tally) {
    test_random random = {seed};
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
            Judge(Transformed(a, {{0.0, 0.0}, 1.0, 0.0}), Transformed(b, pose), closest,
                  a->extent + b->extent + std::hypot(pose.position.x, pose.position.y), tally);
    }
    std::free(a);
    std::free(b);
}

} // namespace

TEST_CASE("the closest direction separates by the distance") {
    Tally tally;
    for (size_t pair = 0; pair < test_scaled(kPairs); ++pair) {
        const Tally before = tally;
        RunOne(7919u * pair + 13u, tally);
        if (tally.tooLittle + tally.tooMuch + tally.notSeparated >
            before.tooLittle + before.tooMuch + before.notSeparated)
            MESSAGE("pair " << pair);
    }
    MESSAGE(tally.queries << " queries, " << tally.near << " of them near");
    CHECK(tally.tooLittle == 0);
    CHECK(tally.tooMuch == 0);
    CHECK(tally.notSeparated == 0);
    const bool enoughNear = tally.near > tally.queries / 10;
    CHECK(enoughNear); // a test without near pairs shows little
    MESSAGE(tally.starts << " starts, " << tally.startedAfar << " not at the closest points");
    CHECK(tally.startedAfar == 0);
    CHECK(tally.tooManySteps == 0);
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
        test_random random = {n};
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
