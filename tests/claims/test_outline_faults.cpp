// SPDX-License-Identifier: MIT
// Rings at random on a few places of a grid, so that they cross, overlap, repeat and touch: what is wrong
// with them is found, and nothing else; and what is an outline is cut into its pieces.
#include <set>

#include "boomerang/outline.h"
#include "cases.h"
#include "outline_families.h"
#include "outline_faults.h"
#include "outline_oracle.h"

using namespace outlines;

namespace {

Outline AtRandom(test_random *random) {
    Outline outline;
    const uint32_t rings = 1 + test_random_below(random, 3), side = 2 + test_random_below(random, 4);
    for (uint32_t r = 0; r < rings; ++r) {
        std::vector<bmr_vec2> ring;
        const uint32_t count = 3 + test_random_below(random, r == 0 ? 4 : 2);
        while (ring.size() < count) {
            const bmr_vec2 p = {1.0 * test_random_below(random, side), 1.0 * test_random_below(random, side)};
            if ((ring.empty() || !Same(ring.back(), p)) && (ring.size() + 1 < count || !Same(ring[0], p)))
                ring.push_back(p);
        }
        // Every other outline has a frame around its rings, so that more of them are holes.
        if (r == 0 && rings > 1 && test_random_below(random, 2) == 1) {
            const double s = side - 1.0;
            ring = {{0.0, 0.0}, {s, 0.0}, {s, s}, {0.0, s}};
        }
        outline.Add(ring);
    }
    return outline;
}

} // namespace

TEST_CASE("what is wrong with rings at random is found, and nothing else") {
    const size_t rounds = test_scaled(100) * test_scaled(400);
    size_t outlines = 0, with_holes = 0, found[BMR_ERROR_COUNT] = {};
    for (size_t round = 0; round < rounds; ++round) {
        test_random random = {round};
        const Outline outline = AtRandom(&random);
        const std::set<bmr_error> faults = FaultsOf(outline.Rings());
        const bmr_rings rings = outline.Rings();
        bmr_outline_fault fault;
        const bmr_error error = bmr_outline_check(&rings, nullptr, &fault);
        bmr_outline_pieces *pieces = nullptr;
        bmr_outline_fault again;
        CAPTURE(round);
        REQUIRE(bmr_outline_decompose(&rings, nullptr, nullptr, &pieces, &again) == error);
        CHECK(fault.error == error);
        CHECK(again.error == error);
        ++found[error];
        if (faults.empty()) {
            REQUIRE(error == BMR_OK);
            ++outlines;
            with_holes += outline.counts.size() > 1 ? 1 : 0;
            CHECK(Complaint(rings, *pieces) == "");
            bmr_outline_pieces_destroy(pieces, nullptr);
            continue;
        }
        CHECK(pieces == nullptr);
        CHECK(faults.count(error) == 1);
        CHECK(again.edge[0] == fault.edge[0]);
        const Rings all(rings);
        CHECK(fault.ring[0] == all.ring[fault.edge[0]]);
        if (error == BMR_ERROR_HOLE_OUTSIDE) {
            CHECK(IsHoleOutside(all, fault.ring[0]));
            continue;
        }
        REQUIRE(fault.edge[0] < fault.edge[1]);
        CHECK(fault.ring[1] == all.ring[fault.edge[1]]);
        const Edge &e = all.edges[fault.edge[0]], &f = all.edges[fault.edge[1]];
        CHECK((error == BMR_ERROR_OVERLAPPING_EDGES ? Overlap(e, f) : Meet(e, f)));
    }
    MESSAGE("outlines: ", outlines, " (with holes: ", with_holes,
            "), crossing: ", found[BMR_ERROR_CROSSING_EDGES],
            ", overlapping: ", found[BMR_ERROR_OVERLAPPING_EDGES],
            ", holes outside: ", found[BMR_ERROR_HOLE_OUTSIDE]);
    // All that can be wrong was there, and so was what is right.
    CHECK(found[BMR_ERROR_CROSSING_EDGES] > 0);
    CHECK(found[BMR_ERROR_OVERLAPPING_EDGES] > 0);
    CHECK(found[BMR_ERROR_HOLE_OUTSIDE] > 0);
    CHECK(with_holes > 0);
}

TEST_CASE("rings that are too short are named, by the edges that were given") {
    struct Case {
        std::vector<std::vector<bmr_vec2>> rings;
        bmr_error error;
        uint32_t edges[2], ring;
    };
    const std::vector<bmr_vec2> square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    const uint32_t none = BMR_OUTLINE_NONE;
    const Case cases[] = {
        {{square, {}}, BMR_ERROR_TOO_FEW_POINTS, {none, none}, 1},
        {{square, {{1, 1}, {2, 2}}}, BMR_ERROR_TOO_FEW_POINTS, {4, 4}, 1},
        {{square, {{1, 1}, {2, 2}, {2, 2}}}, BMR_ERROR_TOO_FEW_POINTS, {4, 4}, 1},
        {{{{0, 0}, {0, 0}, {4, 0}, {4, 4}, {0, 0}}, {{1, 1}}}, BMR_ERROR_TOO_FEW_POINTS, {5, 5}, 1},
        {{{{0, 0}, {4, 0}, {-0.0, 0.0}}}, BMR_ERROR_TOO_FEW_POINTS, {0, 0}, 0},
        {{{{0, 0}, {0, 0}, {2, 2}, {2, 2}, {2, 0}, {0, 2}}}, BMR_ERROR_CROSSING_EDGES, {0, 4}, 0},
        {{{{0, 0}, {4, 0}, {2, 0}}}, BMR_ERROR_OVERLAPPING_EDGES, {0, 2}, 0},
    };
    for (const Case &c : cases) {
        Outline outline;
        for (const auto &ring : c.rings)
            outline.Add(ring);
        const bmr_rings rings = outline.Rings();
        bmr_outline_fault fault;
        CHECK(bmr_outline_check(&rings, nullptr, &fault) == c.error);
        CHECK(fault.error == c.error);
        CHECK(fault.edge[0] == c.edges[0]);
        CHECK(fault.edge[1] == c.edges[1]);
        CHECK(fault.ring[0] == c.ring);
    }
}

TEST_CASE("points that are repeated in a row change nothing") {
    Outline plain, drawn;
    plain.Add({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}});
    plain.Add({{1, 0.5}, {2, 0.5}, {1, 1}});
    drawn.Add({{0, 0}, {4, 0}, {4, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}, {0, 4}, {-0.0, 0.0}, {0, 0}});
    drawn.Add({{1, 0.5}, {1, 0.5}, {2, 0.5}, {1, 1}, {1, 0.5}});
    const uint32_t index[] = {0, 1, 4, 5, 6, 10, 12, 13}; // of the plain points among the drawn
    const bmr_rings plain_rings = plain.Rings(), drawn_rings = drawn.Rings();
    CHECK(bmr_outline_check(&drawn_rings, nullptr, nullptr) == BMR_OK);
    for (const double tolerance : {0.0, 0.01}) {
        const bmr_outline_def def = {tolerance};
        bmr_outline_pieces *a = nullptr, *b = nullptr;
        REQUIRE(bmr_outline_decompose(&plain_rings, &def, nullptr, &a, nullptr) == BMR_OK);
        REQUIRE(bmr_outline_decompose(&drawn_rings, &def, nullptr, &b, nullptr) == BMR_OK);
        CHECK(b->point_count == 15);
        REQUIRE(a->edge_count == b->edge_count);
        for (uint32_t e = 0; e < a->edge_count; ++e) {
            CHECK(index[a->edges[e].point] == b->edges[e].point);
            CHECK((a->edges[e].outline == BMR_OUTLINE_NONE ? BMR_OUTLINE_NONE : index[a->edges[e].outline]) ==
                  b->edges[e].outline);
            CHECK(a->edges[e].twin == b->edges[e].twin);
        }
        bmr_outline_pieces_destroy(a, nullptr);
        bmr_outline_pieces_destroy(b, nullptr);
        uint32_t kept[15], counts[2];
        REQUIRE(bmr_outline_simplify(&drawn_rings, tolerance, nullptr, kept, counts, nullptr) == BMR_OK);
        CHECK(counts[0] == 5);
        CHECK(counts[1] == 3);
        for (uint32_t i = 0; i < 8; ++i)
            CHECK(kept[i] == index[i]);
    }
}

TEST_CASE("the audit of pieces sees what is falsified") {
    Outline outline;
    outline.Add({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    outline.Add({{1, 1}, {3, 1}, {2, 3}});
    const bmr_rings rings = outline.Rings();
    bmr_outline_pieces *pieces = nullptr;
    REQUIRE(bmr_outline_decompose(&rings, nullptr, nullptr, &pieces, nullptr) == BMR_OK);
    const std::vector<bmr_outline_edge> edges(pieces->edges, pieces->edges + pieces->edge_count);
    const std::vector<uint32_t> first(pieces->first, pieces->first + pieces->piece_count + 1);
    const std::vector<bmr_vec2> points(pieces->points, pieces->points + pieces->point_count);
    uint32_t inner = 0;
    while (edges[inner].twin == BMR_OUTLINE_NONE)
        ++inner;
    using Edges = std::vector<bmr_outline_edge>;
    using Firsts = std::vector<uint32_t>;
    using Points = std::vector<bmr_vec2>;
    const auto audited = [&](const std::function<void(Edges *, Firsts *, Points *)> &falsify) {
        Edges e = edges;
        Firsts f = first;
        Points p = points;
        falsify(&e, &f, &p);
        bmr_outline_pieces falsified = *pieces;
        falsified.edges = e.data();
        falsified.first = f.data();
        falsified.points = p.data();
        return bmr_outline_pieces_audit(&falsified);
    };
    const bmr_error structure = BMR_ERROR_INVALID_STRUCTURE;
    CHECK(audited([](Edges *, Firsts *, Points *) {}) == BMR_OK);
    CHECK(audited([](Edges *, Firsts *f, Points *) { f->front() = 1; }) == structure);
    CHECK(audited([](Edges *, Firsts *f, Points *) { (*f)[1] = 0; }) == structure);
    CHECK(audited([](Edges *e, Firsts *, Points *) { e->front().point = 7; }) == structure);
    CHECK(audited([&](Edges *e, Firsts *, Points *) { (*e)[inner].outline = 0; }) == structure);
    CHECK(audited([&](Edges *e, Firsts *, Points *) { (*e)[inner].twin = inner; }) == structure);
    CHECK(audited([](Edges *, Firsts *, Points *p) { (*p)[0] = {9, 9}; }) == BMR_ERROR_NOT_CONVEX);
    CHECK(audited([](Edges *, Firsts *, Points *p) { (*p)[0] = (*p)[1]; }) == BMR_ERROR_NOT_CONVEX);
    bmr_outline_pieces_destroy(pieces, nullptr);
}
