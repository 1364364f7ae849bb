// SPDX-License-Identifier: MIT
// Outlines of all kinds: their pieces are the solid, exactly, and few; simplified ones stay within their
// tolerance.
#include "boomerang/outline.h"
#include "cases.h"
#include "exact_distance.h"
#include "outline_families.h"
#include "outline_oracle.h"
#include <algorithm>
#include <cstdint>
#include <vector>

// --- The fewest convex pieces of a simple polygon, cut from corner to corner: every convex piece beside
// every segment is tried. Polynomial, and nothing of core's; slow. (Cuts that end in no notch are left out:
// what they part is convex without them.)

namespace outlines {

class Optimum {
public:
    /// Counter-clockwise, without holes and touches.
    explicit Optimum(std::vector<bmr_vec2> corners)
        : m_corners(std::move(corners)), m_count(m_corners.size()), m_ahead(m_count),
          m_fewest(m_count * m_count, kUnknown) {
        for (size_t i = 0; i < m_count; ++i)
            for (size_t k = i + 1; k < m_count; ++k)
                if (k == i + 1 || ((IsNotch(i) || IsNotch(k)) && IsCut(i, k)))
                    m_ahead[i].push_back(k);
    }

    size_t Pieces() { return Fewest(0, m_count - 1); }

private:
    static constexpr size_t kUnknown = SIZE_MAX, kNever = SIZE_MAX / 4;

    int Turn(size_t a, size_t b, size_t c) const {
        return exact::Orientation(m_corners[a], m_corners[b], m_corners[c]);
    }

    bool IsNotch(size_t i) const { return Turn((i + m_count - 1) % m_count, i, (i + 1) % m_count) < 0; }

    /// Left, or straight on.
    bool IsConvex(size_t a, size_t b, size_t c) const {
        const int turn = Turn(a, b, c);
        return turn > 0 ||
               (turn == 0 && Before(m_corners[a], m_corners[b]) == Before(m_corners[b], m_corners[c]));
    }

    /// Does the way from i to k begin inside of the corner i?
    bool BeginsInside(size_t i, size_t k) const {
        const size_t next = (i + 1) % m_count, before = (i + m_count - 1) % m_count;
        const bool left_of_next = Turn(i, next, k) > 0, right_of_before = Turn(i, before, k) < 0;
        return Turn(before, i, next) > 0 ? left_of_next && right_of_before : left_of_next || right_of_before;
    }

    /// Of three on one line.
    bool IsBetween(size_t a, size_t b, size_t c) const {
        return Before(m_corners[a], m_corners[b]) == Before(m_corners[b], m_corners[c]);
    }

    /// Is the open segment in the open inside?
    bool IsCut(size_t i, size_t k) const {
        if ((k + 1) % m_count == i || !BeginsInside(i, k) || !BeginsInside(k, i))
            return false;
        for (size_t a = 0; a < m_count; ++a) {
            const size_t b = (a + 1) % m_count;
            if (a == i || a == k || b == i || b == k)
                continue;
            const int side_a = Turn(i, k, a), side_b = Turn(i, k, b);
            if (side_a == 0 && side_b == 0 ? IsBetween(i, a, k) || IsBetween(i, b, k) || IsBetween(a, i, b)
                                           : side_a * side_b <= 0 && Turn(a, b, i) * Turn(a, b, k) <= 0)
                return false;
        }
        return true;
    }

    /// Of the part i, i + 1, .., k: the piece beside the segment is a chain from i to k.
    size_t Fewest(size_t i, size_t k) {
        size_t &known = m_fewest[i * m_count + k];
        if (known != kUnknown)
            return known;
        size_t fewest = kNever;
        for (const size_t first : m_ahead[i])
            if (first < k && IsConvex(k, i, first))
                fewest = std::min(fewest, ByChain(i, first, k, fewest));
        return m_fewest[i * m_count + k] = fewest;
    }

    size_t Beside(size_t a, size_t b) { return b == a + 1 ? 0 : Fewest(a, b); }

    /// Of chains that begin with one link, the fewest, if that is less than `limit`.
    size_t ByChain(size_t i, size_t first, size_t k, size_t limit) {
        std::vector<std::vector<std::pair<size_t, size_t>>> reached(m_count); // from where, at what cost
        reached[first].emplace_back(i, Beside(i, first));
        size_t least = limit;
        for (size_t a = first; a < k; ++a) {
            if (reached[a].empty())
                continue;
            for (const size_t b : m_ahead[a]) {
                size_t cost = kNever;
                for (const auto &[from, before] : reached[a])
                    if (before < cost && before + 1 < least && IsConvex(from, a, b))
                        cost = before;
                if (b > k || cost + 1 >= least || (b == k && !IsConvex(a, k, i)))
                    continue;
                cost += Beside(a, b);
                if (b == k)
                    least = std::min(least, cost + 1);
                else
                    reached[b].emplace_back(a, cost);
            }
        }
        return std::min(least, kNever);
    }

    std::vector<bmr_vec2> m_corners;
    size_t m_count;
    std::vector<std::vector<size_t>> m_ahead;
    std::vector<size_t> m_fewest;
};

} // namespace outlines

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
    const size_t notches = Notches(outline);
    CHECK(made->piece_count <= 2 * notches + Parts(*made.pieces));
    if (!HasDistinctPoints(outline) ||
        made->edge_count - 2 * (made->piece_count + outline.counts.size() - 2) != outline.points.size())
        return; // it touches itself
    CHECK(made->piece_count + outline.counts.size() <= 2 * notches + 2);
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
    // 101,000 outlines; at a tenth, 100.
    const size_t rounds = test_scaled(10) * test_scaled(10) * test_scaled(101);
    for (size_t round = 0; round < rounds; ++round) {
        test_random random = test_random_from(round);
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
    test_random random = test_random_from(7);
    CheckExact(Fan(static_cast<uint32_t>(test_scaled(3000))));
    CheckExact(Spiral(static_cast<uint32_t>(2 * test_scaled(5000))));
    CheckExact(Region(&random, 100, static_cast<uint32_t>(test_scaled(9000)), 0.4).Rings(true));
}

TEST_CASE("small outlines without holes have the fewest pieces that there are") {
    const size_t rounds = test_scaled(1000);
    for (size_t round = 0; round < rounds; ++round) {
        test_random random = test_random_from(round + 1000);
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
    const size_t rounds = test_scaled(10);
    double sum = 0.0;
    for (size_t round = 0; round < rounds; ++round) {
        test_random random = test_random_from(round);
        const uint32_t count = BMR_OUTLINE_OPTIMAL_POINTS + 2;
        const Outline outline = round % 2 == 0 ? Silhouette(&random, count) : Star(&random, count);
        const Pieces made(outline);
        REQUIRE(made.error == BMR_OK);
        sum += static_cast<double>(made->piece_count) / static_cast<double>(OptimumOf(outline));
    }
    const double mean = sum / static_cast<double>(rounds);
    MESSAGE("mean of pieces / optimum: ", mean);
    CHECK(mean <= 1.5);
    CHECK(mean >= 1.0);
}

namespace {

std::vector<std::vector<bmr_vec2>> RingsOf(const Outline &outline) {
    std::vector<std::vector<bmr_vec2>> rings;
    size_t begin = 0;
    for (const uint32_t count : outline.counts) {
        rings.emplace_back(outline.points.begin() + static_cast<std::ptrdiff_t>(begin),
                           outline.points.begin() + static_cast<std::ptrdiff_t>(begin + count));
        begin += count;
    }
    return rings;
}

/// 0 inside and on the boundary.
long double DistanceToSolid(bmr_vec2 p, const std::vector<std::vector<bmr_vec2>> &rings) {
    bool inside = false;
    long double least = INFINITY;
    for (const auto &ring : rings) {
        least = std::min(least, exact::DistanceToRing(p, ring));
        for (size_t i = 0; i < ring.size(); ++i) {
            const bmr_vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
            if ((a.y <= p.y) != (b.y <= p.y) && exact::Orientation(a, b, p) * (a.y <= p.y ? 1 : -1) > 0)
                inside = !inside;
        }
    }
    return inside ? 0.0L : least;
}

/// The farthest that a point of some rings, sampled, is from others.
long double FarthestOf(const std::vector<bmr_vec2> &ring, const std::vector<bmr_vec2> &other) {
    long double most = 0.0L;
    for (size_t i = 0; i < ring.size(); ++i)
        for (int k = 0; k < 4; ++k) {
            const bmr_vec2 along = bmr_sub(ring[(i + 1) % ring.size()], ring[i]);
            most = std::max(most, exact::DistanceToRing(bmr_add(ring[i], bmr_scale(0.25 * k, along)), other));
        }
    return most;
}

struct Simplified {
    Outline outline;
    std::vector<uint32_t> counts; ///< of the rings that were given

    Simplified(const Outline &given, double tolerance) : counts(given.counts.size()) {
        std::vector<uint32_t> kept(given.points.size());
        const bmr_rings rings = given.Rings();
        REQUIRE(bmr_outline_simplify(&rings, tolerance, nullptr, kept.data(), counts.data(), nullptr) ==
                BMR_OK);
        size_t at = 0;
        for (const uint32_t count : counts) {
            for (uint32_t i = 0; i < count; ++i)
                outline.points.push_back(given.points[kept[at++]]);
            if (count > 0)
                outline.counts.push_back(count);
        }
    }
};

/// What doubles make of a distance of this file, in outlines whose coordinates are at most 32.
constexpr double kRounding = 1e-12;

void CheckWithin(test_random *random, const Outline &given, double tolerance) {
    const Simplified simple(given, tolerance);
    const bmr_rings rings = simple.outline.Rings();
    REQUIRE(bmr_outline_check(&rings, nullptr, nullptr) == BMR_OK);
    const auto before = RingsOf(given), after = RingsOf(simple.outline);
    size_t ring = 0;
    for (size_t r = 0; r < before.size(); ++r) {
        if (simple.counts[r] == 0) {
            CHECK(r > 0);
            continue;
        }
        CHECK(FarthestOf(before[r], after[ring]) <= tolerance + kRounding);
        CHECK(FarthestOf(after[ring], before[r]) <= tolerance + kRounding);
        ++ring;
    }
    for (int i = 0; i < 50; ++i) {
        const bmr_vec2 near =
            given.points[test_random_below(random, static_cast<uint32_t>(given.points.size()))];
        const bmr_vec2 p = {near.x + test_random_uniform(random, -3.0, 3.0) * tolerance,
                            near.y + test_random_uniform(random, -3.0, 3.0) * tolerance};
        const long double to_given = DistanceToSolid(p, before), to_simple = DistanceToSolid(p, after);
        CHECK((to_given > 0.0 || to_simple <= tolerance + kRounding));
        CHECK((to_simple > 0.0 || to_given <= tolerance + kRounding));
    }
}

} // namespace

TEST_CASE("simplified outlines are outlines, within the tolerance both ways") {
    const size_t rounds = test_scaled(120);
    for (size_t round = 0; round < rounds; ++round) {
        test_random random = test_random_from(round);
        const auto size = static_cast<uint32_t>(round % 40);
        CAPTURE(round);
        for (const double tolerance : {1e-3, 0.1, 0.5, 2.0}) {
            CheckWithin(&random, Shuffled(&random, Region(&random, 10, 30 + 3 * size, 0.4).Rings(true)),
                        tolerance);
            CheckWithin(&random, Shuffled(&random, Region(&random, 10, 30 + 3 * size, 0.0).Rings(true)),
                        tolerance);
            CheckWithin(&random, Silhouette(&random, 100 + size), tolerance);
            CheckWithin(&random, Spiral(10 + 4 * size), 0.1 * tolerance);
        }
    }
}

TEST_CASE("what is in the way of a point keeps it, and a hole wider than twice the tolerance stays") {
    // Without the bump at (5, 10.4) the outer ring would cross the hole.
    Outline bump;
    bump.Add({{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}, {5.0, 10.4}, {0.0, 10.0}});
    bump.Add({{4.0, 8.0}, {6.0, 8.0}, {5.0, 10.2}});
    CHECK(Simplified(bump, 0.5).outline.counts == std::vector<uint32_t>{5, 3});
    bump.points[7] = {5.0, 9.8};
    CHECK(Simplified(bump, 0.5).outline.counts == std::vector<uint32_t>{4, 3});

    Outline window;
    window.Add({{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}, {0.0, 10.0}});
    window.Add({{4.0, 4.0}, {5.0, 4.0}, {5.0, 5.0}, {4.0, 5.0}});
    CHECK(Simplified(window, 0.49).outline.counts == std::vector<uint32_t>{4, 4});
    CHECK(Simplified(window, 0.51).outline.counts == std::vector<uint32_t>{4});
}

TEST_CASE("where rings touch twice, no edge comes to lie on another") {
    // The hole has an edge from one point of the outer ring to the next but one: these stay three.
    Outline outline;
    outline.Add({{0.0, 0.0}, {2.0, -0.1}, {4.0, 0.0}, {4.0, 4.0}, {0.0, 4.0}});
    outline.Add({{0.0, 0.0}, {4.0, 0.0}, {2.0, 2.0}});
    test_random random = test_random_from(1);
    CheckExact(outline);
    CheckWithin(&random, outline, 0.5);
    // The hole touches the outer ring in one point, which need not stay; then it is filled.
    outline.points[5] = {1.0, 1.0};
    CHECK(Simplified(outline, 0.2).outline.counts == std::vector<uint32_t>{4, 3});
    CHECK(Simplified(outline, 1.5).outline.counts == std::vector<uint32_t>{4});
}

TEST_CASE("without a tolerance a simplified outline loses what is within straight stretches, and no more") {
    const size_t rounds = test_scaled(40);
    for (size_t round = 0; round < rounds; ++round) {
        test_random random = test_random_from(round);
        const Outline all = Region(&random, 8, 20 + static_cast<uint32_t>(round), 0.0).Rings(true);
        random = test_random_from(round);
        const Outline without = Region(&random, 8, 20 + static_cast<uint32_t>(round), 0.0).Rings(false);
        const Simplified simple(all, 0.0);
        CHECK(simple.outline.counts == without.counts);
        CHECK(std::equal(without.points.begin(), without.points.end(), simple.outline.points.begin(),
                         simple.outline.points.end(), Same));
    }
}

TEST_CASE("silhouettes of 500 points become at most 12 pieces in the mean, those of the simplified outline") {
    const size_t rounds = test_scaled(20);
    size_t pieces = 0;
    for (size_t round = 0; round < rounds; ++round) {
        test_random random = test_random_from(round);
        const Outline scanned = Silhouette(&random, 500);
        const auto by_x = [](bmr_vec2 a, bmr_vec2 b) { return a.x < b.x; };
        const auto by_y = [](bmr_vec2 a, bmr_vec2 b) { return a.y < b.y; };
        const auto x = std::minmax_element(scanned.points.begin(), scanned.points.end(), by_x);
        const auto y = std::minmax_element(scanned.points.begin(), scanned.points.end(), by_y);
        const double tolerance = 0.01 * std::max(x.second->x - x.first->x, y.second->y - y.first->y);
        const Pieces made(scanned, tolerance);
        REQUIRE(made.error == BMR_OK);
        pieces += made->piece_count;
        CheckWithin(&random, scanned, tolerance); // (whose pieces they are: tests/random/fuzz_outline.cpp)
    }
    MESSAGE("pieces in the mean: ", static_cast<double>(pieces) / static_cast<double>(rounds));
    CHECK(pieces <= 12 * rounds);
}

TEST_CASE("an outline weighs what its pieces weigh") {
    const size_t rounds = test_scaled(200);
    for (size_t round = 0; round < rounds; ++round) {
        test_random random = test_random_from(round);
        const Outline outline =
            Shuffled(&random, Region(&random, 8, 20 + static_cast<uint32_t>(round % 60), 0.4).Rings(true));
        const bmr_rings rings = outline.Rings();
        const Pieces made(outline);
        REQUIRE(made.error == BMR_OK);
        bmr_mass whole;
        REQUIRE(bmr_outline_mass(&rings, &whole) == BMR_OK);
        double area = 0.0, inertia = 0.0;
        bmr_vec2 moment = {0.0, 0.0};
        for (uint32_t p = 0; p < made->piece_count; ++p) {
            std::vector<bmr_vec2> corners;
            for (uint32_t e = made->first[p]; e < made->first[p + 1]; ++e)
                corners.push_back(made->points[made->edges[e].point]);
            bmr_polygon *polygon = nullptr;
            bmr_mass mass;
            REQUIRE(bmr_polygon_create(corners.data(), corners.size(), nullptr, &polygon) == BMR_OK);
            REQUIRE(bmr_polygon_mass(polygon, &mass) == BMR_OK);
            const bmr_vec2 arm = bmr_sub(mass.centroid, whole.centroid);
            area += mass.area;
            moment = bmr_add(moment, bmr_scale(mass.area, arm));
            inertia += mass.inertia + mass.area * bmr_dot(arm, arm);
            bmr_polygon_destroy(polygon, nullptr);
        }
        CHECK(whole.area == doctest::Approx(area).epsilon(1e-12));
        CHECK(whole.inertia == doctest::Approx(inertia).epsilon(1e-12));
        CHECK(std::hypot(moment.x, moment.y) <= 1e-10 * area);
    }
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

TEST_CASE("where edges cross that are longer than a double is a finite place") {
    constexpr double kFar = 1.5e308;
    for (const bool upright : {false, true}) {
        std::vector<bmr_vec2> ring = {{-kFar, 0.0}, {kFar, 0.0}, {1e300 - kFar, 1.0}, {1e300 - kFar, -1.0}};
        for (bmr_vec2 &p : ring)
            p = upright ? bmr_vec2{p.y, p.x} : p;
        Outline outline;
        outline.Add(ring);
        const bmr_rings rings = outline.Rings();
        bmr_outline_fault fault;
        REQUIRE(bmr_outline_check(&rings, nullptr, &fault) == BMR_ERROR_CROSSING_EDGES);
        CHECK(Same(fault.where, ring[0]));
    }
}
