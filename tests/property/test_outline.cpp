// SPDX-License-Identifier: MIT
// Outlines of all kinds: their pieces are the solid, exactly, and few; simplified ones stay within their
// tolerance.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "boomerang/outline.h"
#include "outline_families.h"
#include "outline_optimum.h"
#include "outline_oracle.h"
#include "test_scale.h"

using namespace outlines;

namespace {

struct Pieces {
    bmr_outline_pieces *pieces = nullptr;
    bmr_error error;
    bmr_outline_fault fault = {};

    explicit Pieces(const Outline &outline, double tolerance = 0.0) {
        const bmr_rings rings = outline.Rings();
        const bmr_outline_def def = {tolerance};
        error = bmr_outline_decompose(&rings, &def, nullptr, &pieces, &fault);
    }
    Pieces(const Pieces &) = delete;
    Pieces &operator=(const Pieces &) = delete;
    ~Pieces() { bmr_outline_pieces_destroy(pieces, nullptr); }
    const bmr_outline_pieces *operator->() const { return pieces; }
};

bool HasDistinctPoints(const Outline &outline) {
    std::vector<bmr_vec2> points = outline.points;
    std::sort(points.begin(), points.end(), Before);
    return std::adjacent_find(points.begin(), points.end(), Same) == points.end();
}

/// Corners of the rings at which the solid takes more than half a turn.
size_t Notches(const Outline &outline) {
    size_t count = 0, begin = 0;
    for (const uint32_t n : outline.counts) {
        const std::vector<bmr_vec2> ring(&outline.points[begin], &outline.points[begin] + n);
        const int sense = DirectionOf(ring) * (begin == 0 ? 1 : -1);
        for (size_t i = 0; i < n; ++i)
            count +=
                exact::Orientation(ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]) * sense < 0 ? 1 : 0;
        begin += n;
    }
    return count;
}

/// Groups of pieces that hang together by edges.
size_t Parts(const bmr_outline_pieces &o) {
    std::vector<uint32_t> part(o.piece_count);
    for (uint32_t p = 0; p < o.piece_count; ++p)
        part[p] = p;
    const auto root = [&](uint32_t p) {
        while (part[p] != p)
            p = part[p];
        return p;
    };
    for (uint32_t e = 0; e < o.edge_count; ++e)
        if (o.edges[e].twin != BMR_OUTLINE_NONE)
            part[root(o.edges[e].piece)] = root(o.edges[o.edges[e].twin].piece);
    size_t count = 0;
    for (uint32_t p = 0; p < o.piece_count; ++p)
        count += part[p] == p ? 1 : 0;
    return count;
}

void CheckExact(const Outline &outline) {
    const Pieces made(outline);
    REQUIRE(made.error == BMR_OK);
    CHECK(made.fault.error == BMR_OK);
    CHECK(Complaint(outline.Rings(), *made.pieces) == "");
    CHECK(bmr_outline_pieces_audit(made.pieces) == BMR_OK);
    CHECK(made->piece_count <= 2 * made->notch_count + Parts(*made.pieces));
    if (!HasDistinctPoints(outline) ||
        made->edge_count - 2 * (made->piece_count + outline.counts.size() - 2) != outline.points.size())
        return; // it touches itself
    CHECK(made->notch_count == Notches(outline));
    CHECK(made->hole_count + 1 == outline.counts.size());
    CHECK(made->piece_count <= 2 * made->notch_count + 1 - made->hole_count);
}

/// Of outlines without holes and touches.
bool IsSimple(const Outline &outline) {
    const bmr_rings rings = outline.Rings();
    bmr_outline_fault fault;
    if (outline.counts.size() != 1 || !HasDistinctPoints(outline) ||
        bmr_outline_check(&rings, nullptr, &fault) != BMR_OK)
        return false;
    for (size_t i = 0; i < outline.points.size(); ++i) // no point on an edge of others
        for (size_t k = 0; k < outline.points.size(); ++k) {
            const bmr_vec2 a = outline.points[i], b = outline.points[(i + 1) % outline.points.size()];
            const bmr_vec2 p = outline.points[k];
            if (exact::Orientation(a, b, p) == 0 && Before(a, p) == Before(p, b) && !Same(a, p) &&
                !Same(b, p))
                return false;
        }
    return true;
}

size_t OptimumOf(const Outline &outline) {
    std::vector<bmr_vec2> ring = outline.points;
    if (DirectionOf(ring) < 0)
        std::reverse(ring.begin(), ring.end());
    return Optimum(ring).Pieces();
}

} // namespace

TEST_CASE("the pieces are convex, and their union is the solid, exactly") {
    const size_t rounds = test_scaled(150);
    for (size_t round = 0; round < rounds; ++round) {
        test_random random = {round};
        const auto size = static_cast<uint32_t>(round % 60);
        CAPTURE(round);
        CheckExact(Shuffled(&random, Region(&random, 8, 20 + size, 0.4).Rings(true)));
        CheckExact(Shuffled(&random, Region(&random, 8, 20 + size, 0.0).Rings(true)));
        const Outline grid = Shuffled(&random, Region(&random, 10, 40 + 2 * size, 0.0).Rings(false));
        CheckExact(grid);
        // From denormals to the largest numbers, and both in one outline.
        CheckExact(Scaled(grid, -1074, -1074));
        CheckExact(Scaled(grid, 1019, round % 2 == 0 ? 1019 : -1074));
        CheckExact(Scaled(Shuffled(&random, Star(&random, 10 + size)), round % 3 == 0 ? 498 : -498, -498));
        CheckExact(Shuffled(&random, Comb(&random, 2 + size / 4)));
        CheckExact(Shuffled(&random, Spiral(10 + 2 * size)));
        CheckExact(Shuffled(&random, Silhouette(&random, 40 + size)));
        CheckExact(Shuffled(&random, Fan(1 + size / 2)));
    }
}

TEST_CASE("large outlines are cut exactly, too") {
    // Nothing in here takes more than a second: what grew with the square of the points would.
    test_random random = {7};
    CheckExact(Fan(static_cast<uint32_t>(test_scaled(3000))));
    CheckExact(Spiral(static_cast<uint32_t>(2 * test_scaled(5000))));
    CheckExact(Region(&random, 100, static_cast<uint32_t>(test_scaled(9000)), 0.4).Rings(true));
}

TEST_CASE("small outlines without holes have the fewest pieces that there are") {
    const size_t rounds = test_scaled(150);
    for (size_t round = 0; round < rounds; ++round) {
        test_random random = {round + 1000};
        const auto size = static_cast<uint32_t>(round % 14);
        for (const Outline &outline :
             {Region(&random, 5, 4 + size, 0.4).Rings(true), Region(&random, 5, 4 + size, 0.0).Rings(true),
              Region(&random, 5, 4 + 2 * size, 0.0).Rings(false), Star(&random, 6 + size),
              Comb(&random, 1 + size / 4)}) {
            if (!IsSimple(outline))
                continue;
            const Pieces made(Shuffled(&random, outline));
            CAPTURE(round);
            REQUIRE(made.error == BMR_OK);
            CHECK(made->piece_count == OptimumOf(outline));
        }
    }
}

TEST_CASE("larger ones have at most 1.5 times as many, in the mean") {
    const size_t rounds = test_scaled(1);
    double sum = 0.0;
    for (size_t round = 0; round < rounds; ++round) {
        test_random random = {round};
        for (const Outline &outline : {Star(&random, BMR_OUTLINE_OPTIMAL_POINTS + 2),
                                       Silhouette(&random, BMR_OUTLINE_OPTIMAL_POINTS + 2)}) {
            const Pieces made(outline);
            REQUIRE(made.error == BMR_OK);
            sum += static_cast<double>(made->piece_count) / static_cast<double>(OptimumOf(outline));
        }
    }
    const double mean = sum / (2.0 * static_cast<double>(rounds));
    MESSAGE("mean of pieces / optimum: ", mean);
    CHECK(mean <= 1.5);
    CHECK(mean >= 1.0);
}
