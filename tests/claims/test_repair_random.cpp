// SPDX-License-Identifier: MIT
// Garbage for rings: what comes of it is taken by bmr_outline_decompose, no two outlines overlap, and no
// place farther from all rings than snap has changed sides. (Sides are counted by rays from points that are
// drawn.)
#include "boomerang/repair.h"
#include "cases.h"

namespace {

using bmr::FillRule;
using bmr::Outline;

constexpr double kPi = 3.14159265358979323846;

using Random = std::mt19937_64;

double Uniform(Random *random, double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(*random);
}

size_t Below(Random *random, size_t count) {
    return std::uniform_int_distribution<size_t>(0, count - 1)(*random);
}

/// A world of garbage: how large it is, what its points are rounded to (0: nothing), where it lies.
struct World {
    double size, step, away;
};

Outline Garbage(Random *random, const World &world) {
    Outline outline;
    for (size_t rings = 1 + Below(random, 4); rings > 0; --rings) {
        std::vector<bmr_vec2> ring(1 + Below(random, Below(random, 4) > 0 ? 12 : 40));
        for (bmr_vec2 &point : ring) {
            point = {Uniform(random, 0.0, world.size), Uniform(random, 0.0, world.size)};
            if (world.step > 0.0)
                point = {world.step * std::floor(point.x / world.step),
                         world.step * std::floor(point.y / world.step)};
            point.x += world.away;
        }
        outline.AddRing(ring.data(), ring.size());
    }
    return outline;
}

double DistanceToEdge(bmr_vec2 p, bmr_vec2 a, bmr_vec2 b) {
    const bmr_vec2 edge = bmr_sub(b, a), way = bmr_sub(p, a);
    const double square = bmr_dot(edge, edge);
    const double along = square > 0.0 ? std::clamp(bmr_dot(way, edge) / square, 0.0, 1.0) : 0.0;
    const bmr_vec2 off = bmr_sub(way, bmr_scale(along, edge));
    return std::sqrt(bmr_dot(off, off));
}

/// Where a point is among rings.
struct Side {
    int around = 0;         ///< how often rings go around it counter-clockwise
    bool odd = false;       ///< does an odd number of them?
    double nearest = 1e300; ///< how far from the nearest edge
};

Side SideOf(const Outline &outline, bmr_vec2 p) {
    Side side;
    size_t begin = 0;
    for (const uint32_t count : outline.counts) {
        for (uint32_t i = 0; i < count; ++i) {
            const bmr_vec2 a = outline.points[begin + i], b = outline.points[begin + (i + 1) % count];
            side.nearest = std::min(side.nearest, DistanceToEdge(p, a, b));
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
    Random random(4);
    size_t outlines = 0, points = 0, inside = 0;
    double farthest = 0.0; // from the rings, of a place that changed sides; in snaps
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
        for (const Outline &outline : made)
            REQUIRE(Decomposes(outline));
        for (int i = 0; i < 40; ++i) {
            const Outline &near = drawn[Below(&random, drawn.size())];
            bmr_vec2 p = near.points[Below(&random, near.points.size())];
            const double reach = i % 2 == 0 ? 3.0 * snap : world.size;
            p = {p.x + Uniform(&random, -reach, reach), p.y + Uniform(&random, -reach, reach)};
            bool solid = false;
            double nearest = 1e300;
            for (const Outline &outline : drawn) {
                const Side side = SideOf(outline, p);
                solid = solid || (rule == FillRule::EvenOdd ? side.odd : side.around != 0);
                nearest = std::min(nearest, side.nearest);
            }
            const int around = CountAround(made, p);
            REQUIRE(around <= 1);
            if ((around == 1) != solid)
                farthest = std::max(farthest, nearest / snap);
            ++points;
            inside += around == 1 ? 1u : 0u;
        }
    }
    MESSAGE(outlines, " outlines; of ", points, " points ", inside, " inside; changed sides at most at ",
            farthest, " snaps");
    CHECK(farthest <= 1.0);
    CHECK(farthest > 0.0); // the control: some do change
    CHECK(inside > points / 10);
}

TEST_CASE("the area differs by no more than edges that move by snap sweep") {
    Random random(34);
    double most = 0.0; // of the bound
    for (size_t n = test_scaled(1500); n > 0; --n) {
        const double snap = std::ldexp(1.0, -static_cast<int>(Below(&random, 8))) * 0.5;
        std::vector<bmr_vec2> ring(3 + Below(&random, 60)); // a star
        double length = 0.0;
        for (size_t i = 0; i < ring.size(); ++i) {
            const double angle = 2.0 * kPi * static_cast<double>(i) / static_cast<double>(ring.size());
            const double radius = Uniform(&random, 1.0, 20.0);
            ring[i] = {radius * std::cos(angle), radius * std::sin(angle)};
        }
        for (size_t i = 0; i < ring.size(); ++i) {
            const bmr_vec2 edge = bmr_sub(ring[(i + 1) % ring.size()], ring[i]);
            length += std::sqrt(bmr_dot(edge, edge));
        }
        Outline star;
        star.AddRing(ring.data(), ring.size());
        bmr_mass mass, part;
        bmr_rings rings = star.GetRings();
        REQUIRE(bmr_outline_mass(&rings, &mass) == BMR_OK);
        std::vector<Outline> made;
        const bmr_error error = RepairOutline(star, FillRule::NonZero, snap, &made);
        REQUIRE((error == BMR_OK || error == BMR_ERROR_TOO_FEW_POINTS));
        double area = 0.0;
        for (const Outline &outline : made) {
            rings = outline.GetRings();
            REQUIRE(bmr_outline_mass(&rings, &part) == BMR_OK);
            area += part.area;
        }
        const double bound = 2.0 * snap * length + kPi * snap * snap * static_cast<double>(ring.size());
        most = std::max(most, std::fabs(area - mass.area) / bound);
    }
    MESSAGE("the area differs by at most ", most, " of the bound");
    CHECK(most <= 1.0);
    CHECK(most > 0.0);
}
