// SPDX-License-Identifier: MIT
// Rings at random on a few places of a grid, so that they cross, overlap, repeat and touch: what is wrong
// with them is found, and nothing else; and what is an outline is cut into its pieces.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "boomerang/outline.h"
#include "outline_families.h"
#include "outline_oracle.h"
#include "test_scale.h"

using namespace outlines;

namespace {

struct Edge {
    bmr_vec2 a, b;
};

/// Small integers: doubles are exact.
double Turn(bmr_vec2 a, bmr_vec2 b, bmr_vec2 c) {
    return bmr_cross(bmr_sub(b, a), bmr_sub(c, a));
}

bool IsOn(const Edge &e, bmr_vec2 p) {
    return Turn(e.a, e.b, p) == 0.0 && bmr_dot(bmr_sub(e.a, p), bmr_sub(e.b, p)) <= 0.0;
}

bool Meet(const Edge &e, const Edge &f) {
    return IsOn(e, f.a) || IsOn(e, f.b) || IsOn(f, e.a) || IsOn(f, e.b) ||
           (Turn(e.a, e.b, f.a) * Turn(e.a, e.b, f.b) < 0.0 &&
            Turn(f.a, f.b, e.a) * Turn(f.a, f.b, e.b) < 0.0);
}

bool CrossInside(const Edge &e, const Edge &f) {
    return Turn(e.a, e.b, f.a) * Turn(e.a, e.b, f.b) < 0.0 && Turn(f.a, f.b, e.a) * Turn(f.a, f.b, e.b) < 0.0;
}

bool Overlap(const Edge &e, const Edge &f) {
    if (Turn(e.a, e.b, f.a) != 0.0 || Turn(e.a, e.b, f.b) != 0.0)
        return false;
    const bmr_vec2 along = bmr_sub(e.b, e.a);
    const double length = bmr_dot(along, along);
    const double p = bmr_dot(along, bmr_sub(f.a, e.a)), q = bmr_dot(along, bmr_sub(f.b, e.a));
    return std::min(length, std::max(p, q)) > std::max(0.0, std::min(p, q));
}

/// Rings with all that has to be known of them.
struct Rings {
    std::vector<Edge> edges;
    std::vector<uint32_t> ring, before; ///< of each edge: its ring, and the edge that ends where it begins

    explicit Rings(const Outline &outline) {
        uint32_t begin = 0;
        for (uint32_t r = 0; r < outline.counts.size(); ++r) {
            const uint32_t count = outline.counts[r];
            for (uint32_t i = 0; i < count; ++i) {
                edges.push_back({outline.points[begin + i], outline.points[begin + (i + 1) % count]});
                ring.push_back(r);
                before.push_back(begin + (i + count - 1) % count);
            }
            begin += count;
        }
    }

    /// The passages through a place: where each comes from, and where it goes on to.
    std::vector<Edge> Passages(bmr_vec2 place) const {
        std::vector<Edge> passages;
        for (size_t i = 0; i < edges.size(); ++i) {
            if (Same(edges[i].a, place))
                passages.push_back({edges[before[i]].a, edges[i].b});
            else if (!Same(edges[i].b, place) && IsOn(edges[i], place))
                passages.push_back(edges[i]);
        }
        return passages;
    }

    bool IsInside(bmr_vec2 p) const {
        bool inside = false;
        for (const Edge &e : edges)
            if ((e.a.y <= p.y) != (e.b.y <= p.y) && Turn(e.a, e.b, p) * (e.a.y <= p.y ? 1.0 : -1.0) > 0.0)
                inside = !inside;
        return inside;
    }
};

/// Is the direction to p inside of the turn from that to a, counter-clockwise, to that to b? All different.
bool IsWithin(bmr_vec2 place, bmr_vec2 a, bmr_vec2 b, bmr_vec2 p) {
    const auto angle = [&](bmr_vec2 q) {
        const double turn =
            std::atan2(q.y - place.y, q.x - place.x) - std::atan2(a.y - place.y, a.x - place.x);
        return turn < 0.0 ? turn + 2.0 * M_PI : turn;
    };
    return angle(p) < angle(b);
}

/// Two passages through a place, which leave it in four directions. (Where two directions are one, edges
/// overlap.)
bool CrossInPlace(const Rings &rings, bmr_vec2 place) {
    const std::vector<Edge> passages = rings.Passages(place);
    std::vector<bmr_vec2> ends;
    for (const Edge &e : passages)
        for (const bmr_vec2 end : {e.a, e.b}) {
            for (const bmr_vec2 other : ends)
                if (Turn(place, end, other) == 0.0 &&
                    bmr_dot(bmr_sub(end, place), bmr_sub(other, place)) > 0.0)
                    return false;
            ends.push_back(end);
        }
    for (const Edge &e : passages)
        for (const Edge &f : passages)
            if (&e != &f && IsWithin(place, e.a, e.b, f.a) != IsWithin(place, e.a, e.b, f.b))
                return true;
    return false;
}

/// Right above the lowest edge at its leftmost place a hole is void.
bool IsHoleOutside(const Rings &rings, uint32_t ring) {
    bmr_vec2 place = {INFINITY, 0.0};
    for (size_t i = 0; i < rings.edges.size(); ++i)
        if (rings.ring[i] == ring && Before(rings.edges[i].a, place))
            place = rings.edges[i].a;
    bmr_vec2 lowest = {-INFINITY, INFINITY};
    for (size_t i = 0; i < rings.edges.size(); ++i) {
        const Edge &e = rings.edges[i];
        if (rings.ring[i] != ring || (!Same(e.a, place) && !Same(e.b, place)))
            continue;
        const bmr_vec2 end = Same(e.a, place) ? e.b : e.a;
        if (std::isinf(lowest.x) || Turn(place, lowest, end) < 0.0)
            lowest = end;
    }
    const bmr_vec2 along = bmr_sub(lowest, place);
    return rings.IsInside(bmr_add(place, bmr_scale(1e-3, bmr_add(along, bmr_scale(1e-3, bmr_left(along))))));
}

std::set<bmr_error> FaultsOf(const Outline &outline) {
    std::set<bmr_error> faults;
    const Rings rings(outline);
    for (size_t i = 0; i < rings.edges.size(); ++i)
        for (size_t k = 0; k < i; ++k) {
            if (CrossInside(rings.edges[i], rings.edges[k]))
                faults.insert(BMR_ERROR_CROSSING_EDGES);
            if (Overlap(rings.edges[i], rings.edges[k]))
                faults.insert(BMR_ERROR_OVERLAPPING_EDGES);
        }
    for (const Edge &e : rings.edges)
        if (CrossInPlace(rings, e.a))
            faults.insert(BMR_ERROR_CROSSING_EDGES);
    for (uint32_t r = 1; r < outline.counts.size(); ++r)
        if (IsHoleOutside(rings, r))
            faults.insert(BMR_ERROR_HOLE_OUTSIDE);
    return faults;
}

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
        const std::set<bmr_error> faults = FaultsOf(outline);
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
        const Rings all(outline);
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

TEST_CASE("rings that are too short or repeat a point are named") {
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
        {{square, {{1, 1}, {2, 2}, {2, 2}}}, BMR_ERROR_REPEATED_POINT, {5, 6}, 1},
        {{{{0, 0}, {4, 0}, {4, 4}, {0, 0}}}, BMR_ERROR_REPEATED_POINT, {3, 0}, 0},
        {{{{0, 0}, {4, 0}, {-0.0, 0.0}}}, BMR_ERROR_REPEATED_POINT, {2, 0}, 0},
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
