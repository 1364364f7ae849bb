// SPDX-License-Identifier: MIT
// Rings that are drawn wrongly in each of the known ways become outlines, and many outlines become one.
#include "boomerang/repair.h"
#include "cases.h"
#include "exact_distance.h"
#include "polygons.h"

namespace {

using bmr::FillRule;
using bmr::Outline;
using Ring = std::vector<bmr_vec2>;

constexpr double kSnap = 0.01;

Outline Drawn(const std::vector<Ring> &rings) {
    Outline outline;
    for (const Ring &ring : rings)
        outline.AddRing(ring.data(), ring.size());
    return outline;
}

Ring Box(double left, double bottom, double right, double top) {
    return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

/// Of an outline that is one: bmr_outline_decompose takes it.
double AreaOf(const Outline &outline) {
    const bmr_rings rings = outline.GetRings();
    bmr_outline_pieces *pieces = nullptr;
    REQUIRE(bmr_outline_decompose(&rings, nullptr, nullptr, &pieces, nullptr) == BMR_OK);
    bmr_outline_pieces_destroy(pieces, nullptr);
    bmr_mass mass;
    REQUIRE(bmr_outline_mass(&rings, &mass) == BMR_OK);
    return mass.area;
}

struct Count {
    size_t outlines, rings;
    double area;
};

Count Counted(const std::vector<Outline> &outlines) {
    Count all = {outlines.size(), 0, 0.0};
    for (const Outline &outline : outlines) {
        all.rings += outline.counts.size();
        all.area += AreaOf(outline);
    }
    return all;
}

} // namespace

TEST_CASE("what is drawn wrongly is refused as it is, and repaired") {
    const Ring square = Box(0, 0, 4, 4);
    const double near = 2.8e-14;
    struct Case {
        std::string name;
        std::vector<Ring> rings;
        bmr_error refused;
        Count evenOdd;
        double nonZero; ///< its area
    };
    const Case cases[] = {
        {"a hole along an edge of the outer ring",
         {square, Box(0, 1, 2, 2)},
         BMR_ERROR_OVERLAPPING_EDGES,
         {1, 1, 14},
         16},
        {"holes side by side",
         {square, Box(1, 1, 2, 2), Box(2, 1, 3, 2)},
         BMR_ERROR_OVERLAPPING_EDGES,
         {1, 2, 14},
         16},
        {"a hole given twice",
         {square, Box(1, 1, 2, 2), Box(1, 1, 2, 2)},
         BMR_ERROR_OVERLAPPING_EDGES,
         {1, 1, 16},
         16},
        {"an outline given twice", {square, square}, BMR_ERROR_OVERLAPPING_EDGES, {0, 0, 0}, 16},
        {"a hole across the outer ring", {square, Box(3, 1, 5, 2)}, BMR_ERROR_CROSSING_EDGES, {2, 2, 16}, 17},
        {"holes across each other",
         {square, Box(1, 1, 3, 2), Box(2, 1, 3.5, 3)},
         BMR_ERROR_OVERLAPPING_EDGES,
         {1, 2, 13},
         16},
        {"a hole that touches but for rounding",
         {square, {{1, 1}, {4 + near, 2}, {1, 3}}},
         BMR_ERROR_CROSSING_EDGES,
         {1, 1, 13},
         16},
        {"a hole as good as along an edge", {square, Box(near, 1, 2, 2)}, BMR_OK, {1, 1, 14}, 16},
        {"a hole outside", {square, Box(6, 0, 7, 1)}, BMR_ERROR_HOLE_OUTSIDE, {2, 2, 17}, 17},
        {"an island in a hole",
         {square, Box(1, 1, 3, 3), Box(1.5, 1.5, 2.5, 2.5)},
         BMR_ERROR_HOLE_OUTSIDE,
         {2, 3, 13},
         16},
        {"an island that touches its hole",
         {square, Box(1, 1, 3, 3), {{1, 2}, {2, 1.5}, {2, 2.5}}},
         BMR_ERROR_HOLE_OUTSIDE,
         {2, 3, 12.5},
         16},
        {"a ring like an 8", {{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}, BMR_ERROR_CROSSING_EDGES, {2, 2, 8}, 8},
        {"a ring twice around",
         {{{0, 0}, {4, 0}, {4, 4}, {1, 4}, {1, 1}, {3, 1}, {3, 3}, {0, 3}}},
         BMR_ERROR_CROSSING_EDGES,
         {1, 1, 11},
         15},
        {"a spike",
         {{{0, 0}, {4, 0}, {8, 0}, {4, 0}, {4, 4}, {0, 4}}},
         BMR_ERROR_OVERLAPPING_EDGES,
         {1, 1, 16},
         16},
        {"a spike inwards",
         {{{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 2}, {2, 4}, {0, 4}}},
         BMR_ERROR_OVERLAPPING_EDGES,
         {1, 1, 16},
         16},
        {"a ring that repeats points",
         {{{0, 0}, {4, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}},
         BMR_OK,
         {1, 1, 16},
         16},
        {"a point for a hole", {square, {{2, 2}}}, BMR_ERROR_TOO_FEW_POINTS, {1, 1, 16}, 16},
        {"a line for a hole",
         {square, {{1, 1}, {2, 2}, {3, 3}}},
         BMR_ERROR_OVERLAPPING_EDGES,
         {1, 1, 16},
         16},
        {"parts that hang together in a point",
         {{{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}}},
         BMR_OK,
         {2, 2, 8},
         8},
        {"nothing but a line", {{{0, 0}, {4, 0}, {2, 0}}}, BMR_ERROR_OVERLAPPING_EDGES, {0, 0, 0}, 0},
    };
    // At the origin, and where floats have steps of half a millimetre.
    for (const double away : {0.0, 8000.0})
        for (const Case &c : cases) {
            CAPTURE(c.name);
            CAPTURE(away);
            Outline drawn = Drawn(c.rings);
            for (bmr_vec2 &point : drawn.points)
                point.x += away;
            const bmr_rings rings = drawn.GetRings();
            if (away == 0.0)
                CHECK(bmr_outline_check(&rings, nullptr, nullptr) == c.refused);
            std::vector<Outline> repaired(7);
            const bmr_error error = RepairOutline(drawn, FillRule::EvenOdd, kSnap, &repaired);
            CHECK(error == (c.evenOdd.outlines > 0 ? BMR_OK : BMR_ERROR_TOO_FEW_POINTS));
            if (error != BMR_OK) {
                CHECK(repaired.size() == 7);
                repaired.clear();
            }
            const Count found = Counted(repaired);
            CHECK(found.outlines == c.evenOdd.outlines);
            CHECK(found.rings == c.evenOdd.rings);
            CHECK(found.area == doctest::Approx(c.evenOdd.area).epsilon(0.003));
            repaired.clear();
            RepairOutline(drawn, FillRule::NonZero, kSnap, &repaired);
            CHECK(Counted(repaired).area == doctest::Approx(c.nonZero).epsilon(0.003));
        }
}

TEST_CASE("results are exact as floats, and have no straight points") {
    const Outline drawn = Drawn({{{8000.1, 0}, {8002, 0.004}, {8004, 0}, {8004, 1}, {8000.1, 3}}});
    std::vector<Outline> repaired;
    REQUIRE(RepairOutline(drawn, FillRule::EvenOdd, kSnap, &repaired) == BMR_OK);
    for (const bmr_vec2 &point : repaired[0].points) {
        CHECK(double{static_cast<float>(point.x)} == point.x);
        CHECK(double{static_cast<float>(point.y)} == point.y);
    }
    const Outline straight = Drawn({{{0, 0}, {1, 0}, {2, 0}, {4, 0}, {4, 4}}});
    REQUIRE(RepairOutline(straight, FillRule::EvenOdd, kSnap, &repaired) == BMR_OK);
    CHECK(repaired[0].points.size() == 3);
    const Outline touching = Drawn({Box(0, 0, 4, 4), {{4, 2}, {6, 1}, {6, 3}}});
    REQUIRE(RepairOutline(touching, FillRule::EvenOdd, kSnap, &repaired) == BMR_OK);
    REQUIRE(repaired.size() == 2);
    CHECK(repaired[0].points.size() + repaired[1].points.size() == 7);
}

TEST_CASE("tiles become one outline, also where they do not quite meet, and where a corner is in an edge") {
    std::vector<Outline> tiles;
    const auto add = [&](double x, double y, double size) {
        const double off = static_cast<double>(tiles.size() % 3) * 0.0006;
        tiles.push_back(Drawn({Box(x + off, y - off, x + size + off, y + size - off)}));
    };
    for (int x = 0; x < 6; ++x) // a ring of tiles of 1 and 2
        for (int y = 0; y < 4; ++y)
            if (x == 0 || x == 5 || y == 0 || y == 3)
                add(x, y, 1);
    add(6.0013, 0.5, 2); // beside three, with a gap
    std::vector<Outline> merged;
    REQUIRE(MergeOutlines(tiles.data(), tiles.size(), FillRule::NonZero, kSnap, &merged) == BMR_OK);
    const Count found = Counted(merged);
    CHECK(found.outlines == 1);
    CHECK(found.rings == 2);
    CHECK(found.area == doctest::Approx(16 + 4).epsilon(0.003));
    CHECK(merged[0].points.size() < 50);

    // A long row or column is united as fast as a square of as many: the other way round it takes minutes.
    for (const bool row : {true, false}) {
        tiles.clear();
        for (int i = 0; i < 10000; ++i)
            tiles.push_back(Drawn({row ? Box(i, 0, i + 1, 1) : Box(0, i, 1, i + 1)}));
        REQUIRE(MergeOutlines(tiles.data(), tiles.size(), FillRule::NonZero, kSnap, &merged) == BMR_OK);
        CHECK(Counted(merged).area == doctest::Approx(10000));
        CHECK(merged[0].points.size() == 4);
    }

    // Solids add up, whichever way their rings run, and a hole that another one covers is filled.
    const Ring square = Box(0, 0, 4, 4), back(square.rbegin(), square.rend());
    const Outline some[] = {Drawn({back, Box(1, 1, 3, 3)}), Drawn({Box(2, 0, 6, 4)}), Drawn({back})};
    REQUIRE(MergeOutlines(some, 2, FillRule::EvenOdd, kSnap, &merged) == BMR_OK);
    CHECK(Counted(merged).area == doctest::Approx(22));
    CHECK(Counted(merged).rings == 2);
    REQUIRE(MergeOutlines(some, 3, FillRule::EvenOdd, kSnap, &merged) == BMR_OK);
    CHECK(Counted(merged).area == doctest::Approx(24));
}

TEST_CASE("what cannot be repaired has its error, and leaves the result as it was") {
    const Ring square = Box(0, 0, 4, 4);
    const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
    std::vector<Outline> result(3);
    const auto answer = [&](const std::vector<Ring> &rings, double snap) {
        const bmr_error error = RepairOutline(Drawn(rings), FillRule::EvenOdd, snap, &result);
        CHECK(result.size() == 3);
        return error;
    };
    CHECK(answer({square}, nan) == BMR_ERROR_NOT_FINITE);
    CHECK(answer({square}, inf) == BMR_ERROR_NOT_FINITE);
    CHECK(answer({square}, 0.0) == BMR_ERROR_NEGATIVE);
    CHECK(answer({square}, -1.0) == BMR_ERROR_NEGATIVE);
    CHECK(answer({square}, 1e-300) == BMR_ERROR_OUT_OF_RANGE);
    CHECK(answer({square}, 1e-310) == BMR_ERROR_OUT_OF_RANGE);
    CHECK(answer({square}, 5e-324) == BMR_ERROR_OUT_OF_RANGE);
    CHECK(answer({square}, 1e-8) == BMR_ERROR_OUT_OF_RANGE);
    CHECK(answer({square}, 1e308) == BMR_ERROR_TOO_FEW_POINTS);
    CHECK(answer({{{0, 0}, {1e300, 0}, {0, 1}}}, kSnap) == BMR_ERROR_OUT_OF_RANGE);
    CHECK(answer({{{0, 0}, {nan, 0}, {0, 1}}}, kSnap) == BMR_ERROR_NOT_FINITE);
    CHECK(answer({{{0, 0}, {1, -inf}, {0, 1}}}, kSnap) == BMR_ERROR_NOT_FINITE);
    CHECK(answer({}, kSnap) == BMR_ERROR_NO_POINTS);
    CHECK(answer({{}}, kSnap) == BMR_ERROR_NO_POINTS);
    CHECK(answer({Ring((size_t{1} << 20) + 1)}, kSnap) == BMR_ERROR_TOO_MANY_POINTS);
    Ring stairs; // 65,538 corners, all of which are needed
    for (int i = 0; i < 32768; ++i) {
        stairs.push_back({static_cast<double>(i), static_cast<double>(i)});
        stairs.push_back({i + 1.0, static_cast<double>(i)});
    }
    stairs.push_back({32768, 40000});
    stairs.push_back({0, 40000});
    CHECK(answer({stairs}, kSnap) == BMR_ERROR_TOO_MANY_POINTS);
    Ring line; // each edge would bend to a third of the points
    for (int i = 0; i < 5000; ++i)
        line.push_back({static_cast<double>(i * 1759 % 5000), 0});
    line.push_back({0, 1});
    CHECK(answer({line}, kSnap) == BMR_ERROR_TOO_MANY_POINTS);
    Outline wrong = Drawn({square});
    wrong.counts[0] = 5;
    CHECK(RepairOutline(wrong, FillRule::EvenOdd, kSnap, &result) == BMR_ERROR_OUT_OF_RANGE);
    CHECK(RepairOutline(wrong, FillRule::EvenOdd, kSnap, nullptr) == BMR_ERROR_NULL_ARGUMENT);
    CHECK(bmr::MergeOutlines(nullptr, 1, FillRule::EvenOdd, kSnap, &result) == BMR_ERROR_NULL_ARGUMENT);
    CHECK(bmr::MergeOutlines(nullptr, 0, FillRule::EvenOdd, kSnap, &result) == BMR_ERROR_NO_POINTS);
    CHECK(result.size() == 3);
}

// --- garbage for rings: what comes of it is taken by bmr_outline_decompose, no two outlines overlap, and no
// place farther from all rings than snap has changed sides. (Sides are counted by rays from points that are
// drawn.) ---

namespace {

size_t Below(test_random *random, size_t count) {
    return test_random_below(random, static_cast<uint32_t>(count));
}

/// A world of garbage: how large it is, what its points are rounded to (0: nothing), where it lies.
struct World {
    double size, step, away;
};

Outline Garbage(test_random *random, const World &world) {
    Outline outline;
    for (size_t rings = 1 + Below(random, 4); rings > 0; --rings) {
        std::vector<bmr_vec2> ring(1 + Below(random, Below(random, 4) > 0 ? 12 : 40));
        for (bmr_vec2 &point : ring) {
            point = {test_random_uniform(random, 0.0, world.size),
                     test_random_uniform(random, 0.0, world.size)};
            if (world.step > 0.0)
                point = {world.step * std::floor(point.x / world.step),
                         world.step * std::floor(point.y / world.step)};
            point.x += world.away;
        }
        outline.AddRing(ring.data(), ring.size());
    }
    return outline;
}

/// Where a point is among rings.
struct Side {
    int around = 0;   ///< how often rings go around it counter-clockwise
    bool odd = false; ///< does an odd number of them?
};

Side SideOf(const Outline &outline, bmr_vec2 p) {
    Side side;
    size_t begin = 0;
    for (const uint32_t count : outline.counts) {
        for (uint32_t i = 0; i < count; ++i) {
            const bmr_vec2 a = outline.points[begin + i], b = outline.points[begin + (i + 1) % count];
            if ((a.y <= p.y) == (b.y <= p.y))
                continue;
            const double turn = bmr_cross(bmr_sub(b, a), bmr_sub(p, a));
            if ((turn > 0.0) == (b.y > a.y)) {
                side.around += b.y > a.y ? 1 : -1;
                side.odd = !side.odd;
            }
        }
        begin += count;
    }
    return side;
}

/// How far the point is from the nearest ring.
long double FromRings(const std::vector<Outline> &outlines, bmr_vec2 p) {
    long double nearest = INFINITY;
    for (const Outline &outline : outlines) {
        const bmr_vec2 *ring = outline.points.data();
        for (const uint32_t count : outline.counts) {
            nearest = std::min(nearest, exact::DistanceToRing(p, {ring, ring + count}));
            ring += count;
        }
    }
    return nearest;
}

/// In how many of the outlines the point is.
int CountAround(const std::vector<Outline> &outlines, bmr_vec2 p) {
    int count = 0;
    for (const Outline &outline : outlines)
        count += SideOf(outline, p).odd ? 1 : 0;
    return count;
}

bool Decomposes(const Outline &outline) {
    const bmr_rings rings = outline.GetRings();
    bmr_outline_pieces *pieces = nullptr;
    if (bmr_outline_decompose(&rings, nullptr, nullptr, &pieces, nullptr) != BMR_OK)
        return false;
    bmr_outline_pieces_destroy(pieces, nullptr);
    return true;
}

} // namespace

TEST_CASE("garbage becomes outlines, and nothing changes sides that is farther than snap from all rings") {
    const World worlds[] = {{4, 1, 0},         {10, 1, 1000},  {10, 0, 0},
                            {40, 0.125, 8000}, {100, 0, 8000}, {3000, 1, 0}};
    const double snaps[] = {0.01, 0.1, 1.0, 3.0};
    test_random random = test_random_from(4);
    size_t outlines = 0, points = 0, inside = 0;
    long double farthest = 0.0L; // from the rings, of a place that changed sides; in snaps
    for (size_t n = test_scaled(3000); n > 0; --n) {
        const World &world = worlds[Below(&random, std::size(worlds))];
        const double snap = snaps[Below(&random, std::size(snaps))];
        const FillRule rule = Below(&random, 2) == 0 ? FillRule::EvenOdd : FillRule::NonZero;
        std::vector<Outline> drawn(Below(&random, 2) == 0 ? 1 : 1 + Below(&random, 4));
        for (Outline &outline : drawn)
            outline = Garbage(&random, world);
        std::vector<Outline> made;
        const bmr_error error = MergeOutlines(drawn.data(), drawn.size(), rule, snap, &made);
        REQUIRE((error == BMR_OK || error == BMR_ERROR_TOO_FEW_POINTS));
        outlines += made.size();
        // (It is cut where it is one, and that takes most of the time.)
        for (const Outline &outline : made) {
            const bmr_rings rings = outline.GetRings();
            REQUIRE(bmr_outline_check(&rings, nullptr, nullptr) == BMR_OK);
            REQUIRE((n % 4 != 0 || Decomposes(outline)));
        }
        for (int i = 0; i < 40; ++i) {
            const Outline &near = drawn[Below(&random, drawn.size())];
            bmr_vec2 p = near.points[Below(&random, near.points.size())];
            const double reach = i % 2 == 0 ? 3.0 * snap : world.size;
            p = {p.x + test_random_uniform(&random, -reach, reach),
                 p.y + test_random_uniform(&random, -reach, reach)};
            bool solid = false;
            for (const Outline &outline : drawn) {
                const Side side = SideOf(outline, p);
                solid = solid || (rule == FillRule::EvenOdd ? side.odd : side.around != 0);
            }
            const int around = CountAround(made, p);
            REQUIRE(around <= 1);
            if ((around == 1) != solid)
                farthest = std::max(farthest, FromRings(drawn, p) / snap);
            ++points;
            inside += around == 1 ? 1u : 0u;
        }
    }
    MESSAGE(outlines, " outlines; of ", points, " points ", inside, " inside; changed sides at most at ",
            static_cast<double>(farthest), " snaps");
    CHECK(farthest <= 1.0L);
    CHECK(farthest > 0.0L); // the control: some do change
    CHECK(inside > points / 10);
}
