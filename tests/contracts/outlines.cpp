// SPDX-License-Identifier: MIT
// Outlines that are none, and bad arguments of what is asked of them.
#include "boomerang/outline.h"
#include "stage.h"

using namespace contracts;

namespace {

/// A star of many notches, with a square hole.
struct Star {
    std::vector<bmr_vec2> points;
    std::vector<uint32_t> counts = {BMR_OUTLINE_OPTIMAL_POINTS, 4};

    Star() {
        points = Ellipse(counts[0]);
        for (uint32_t i = 0; i < counts[0]; ++i) {
            const double radius = 1.0 + 0.5 * ((i * 7919 + 3) % 101) / 100.0;
            points[i] = {points[i].x * radius, points[i].y * radius};
        }
        for (const bmr_vec2 &p : Ellipse(4, 0.5, -0.5))
            points.push_back(p);
    }
};

const Star &TheStar() {
    static const Star star;
    return star;
}

const bmr_outline_fault kNoFault = {BMR_ERROR_COUNT, {0, 0}, {0, 0}, {0.0, 0.0}};

std::string Check(const Given &g) {
    const Star &star = TheStar();
    const bmr_rings rings = {g.Or(1, star.points.data()), g.Or(2, star.counts.data()), 2};
    bmr_outline_fault fault = kNoFault;
    const bmr_error error = bmr_outline_check(g.Or(0, &rings), g.allocator, g.Or(3, &fault));
    g.Made(&fault.error, sizeof fault.error);
    return Said(error, fault.error != BMR_ERROR_COUNT);
}

std::string Simplify(const Given &g) {
    const Star &star = TheStar();
    const bmr_rings rings = {star.points.data(), star.counts.data(), 2};
    std::vector<uint32_t> kept(star.points.size(), 77), counts = {77, 77};
    bmr_outline_fault fault = kNoFault;
    const bmr_error error = bmr_outline_simplify(g.Or(0, &rings), g[1], g.allocator, g.Or(2, kept.data()),
                                                 g.Or(3, counts.data()), g.Or(4, &fault));
    if (error != BMR_OK)
        return Said(error, kept[0] != 77 || counts[0] != 77 || fault.error != BMR_ERROR_COUNT);
    g.Made(counts.data(), sizeof counts[0] * 2);
    g.Made(kept.data(), (counts[0] + counts[1]) * sizeof kept[0]);
    return Said(error);
}

/// With the hole, without, and with a tolerance.
std::string Decompose(const Given &g) {
    const Star &star = TheStar();
    for (uint32_t i = 0; i < (g.allocator != nullptr ? 3 : 1); ++i) {
        const bmr_rings rings = {star.points.data(), star.counts.data(), 2 - i % 2};
        const bmr_outline_def def = {i == 2 ? 0.1 : g[1]};
        bmr_outline_pieces *made = Untouched<bmr_outline_pieces>();
        bmr_outline_fault fault = kNoFault;
        const bmr_error error = bmr_outline_decompose(g.Or(0, &rings), g.Or(2, &def), g.allocator,
                                                      g.Or(3, &made), g.Or(4, &fault));
        if (error != BMR_OK)
            return Said(error, made != Untouched<bmr_outline_pieces>() || fault.error != BMR_ERROR_COUNT);
        if (g[3] == kNull)
            return "OK, without a place for the result";
        g.Made(made->edges, made->edge_count * sizeof *made->edges);
        g.Made(made->first, (made->piece_count + 1) * sizeof *made->first);
        bmr_outline_pieces_destroy(made, g.allocator);
    }
    return "OK";
}

const Table kCalls("boomerang/outline.h", [] {
    const Rules tolerance = kNotNegative + Says("NOT_FINITE", {kNaN, kInfinity});
    Makes("bmr_outline_check",
          {{"rings", kNotNull}, {"points", kNotNull}, {"counts", kNotNull}, {"fault", kMayBeNull}}, Check);
    Makes("bmr_outline_simplify",
          {{"rings", kNotNull},
           {"tolerance", 0.1, tolerance},
           {"place of the points", kNotNull},
           {"place of the counts", kNotNull},
           {"fault", kMayBeNull}},
          Simplify);
    Makes("bmr_outline_decompose",
          {{"rings", kNotNull},
           {"tolerance", 0, tolerance},
           {"def", kMayBeNull},
           {"result", kNotNull},
           {"fault", kMayBeNull}},
          Decompose);
    Refuses("bmr_outline_mass",
            {{"rings", kNotNull},
             {"result", kNotNull},
             {"half width of a hole in a square", 0.5, Says("OUT_OF_RANGE", {1})}},
            [](const Given &g) {
                std::vector<bmr_vec2> points = Ellipse(4);
                for (const bmr_vec2 &p : Ellipse(4, g[2], g[2]))
                    points.push_back(p);
                const uint32_t counts[] = {4, 4};
                const bmr_rings rings = {points.data(), counts, 2};
                bmr_mass mass = {-77.0, {}, 0.0};
                const bmr_error error = bmr_outline_mass(g.Or(0, &rings), g.Or(1, &mass));
                return Said(error, mass.area != -77.0);
            });
    Refuses("bmr_outline_pieces_audit, bmr_outline_pieces_destroy", {{"pieces", kNotNull}},
            [](const Given &g) {
                const bmr_rings rings = {TheStar().points.data(), TheStar().counts.data(), 2};
                bmr_outline_pieces *made = nullptr;
                bmr_outline_decompose(&rings, nullptr, nullptr, &made, nullptr);
                const bmr_error error = bmr_outline_pieces_audit(g.Or(0, made));
                bmr_outline_pieces_destroy(made, nullptr);
                bmr_outline_pieces_destroy(nullptr, nullptr);
                return Said(error);
            });
});

// --- outlines that are none ---

/// All three questions about one outline must refuse it the same way, and write nothing but the fault.
std::string AskedOf(const std::vector<bmr_vec2> &points, const std::vector<uint32_t> &counts) {
    const bmr_rings rings = {points.data(), counts.data(), static_cast<uint32_t>(counts.size())};
    std::vector<uint32_t> kept(points.size() + 1, 77), left(counts.size() + 1, 77);
    bmr_outline_pieces *pieces = nullptr;
    bmr_outline_fault faults[3] = {};
    const bmr_error error = bmr_outline_decompose(&rings, nullptr, nullptr, &pieces, &faults[0]),
                    again = bmr_outline_simplify(&rings, 0.0, nullptr, kept.data(), left.data(), &faults[1]),
                    checked = bmr_outline_check(&rings, nullptr, &faults[2]);
    if (again != error || checked != error || error == BMR_OK)
        return Said(error) + ", " + Said(again) + " and " + Said(checked);
    if (pieces != nullptr || kept[0] != 77 || left[0] != 77 || faults[0].edge[1] != faults[1].edge[1])
        return Said(error, true);
    const auto name = [](uint32_t edge) { return edge == BMR_OUTLINE_NONE ? "none" : std::to_string(edge); };
    return faults[0].error == BMR_OK
               ? Said(error)
               : Said(error) + ", edges " + name(faults[0].edge[0]) + " and " + name(faults[0].edge[1]);
}

struct BadOutline {
    const char *name;
    std::vector<bmr_vec2> points; ///< behind those of a square of side 4, where it has a hole
    std::vector<uint32_t> counts;
};

std::vector<bmr_vec2> InSquare(const std::vector<bmr_vec2> &hole) {
    std::vector<bmr_vec2> points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    points.insert(points.end(), hole.begin(), hole.end());
    return points;
}

const std::vector<BadOutline> &BadOutlines() {
    static const std::vector<BadOutline> outlines = {
        {"no rings", InSquare({}), {}},
        {"a ring without points", InSquare({}), {4, 0}},
        {"a ring of two points", InSquare({{1, 1}, {2, 2}}), {4, 2}},
        {"65,536 points", Ellipse(65536), {65536}},
        {"2^32 - 1 points, and two more", InSquare({}), {UINT32_MAX, 2}},
        {"a coordinate of NaN", {{0, 0}, {4, 0}, {4, kNaN}}, {3}},
        {"a coordinate of infinity", {{0, 0}, {kInfinity, 0}, {4, 4}}, {3}},
        {"its last point is its first", InSquare({{0, 0}}), {5}},
        {"like an 8", {{0, 0}, {4, 4}, {4, 0}, {0, 4}}, {4}},
        {"like an 8, through one point twice", {{0, 0}, {2, 2}, {4, 4}, {4, 0}, {2, 2}, {0, 4}}, {6}},
        {"a spike", {{0, 0}, {4, 0}, {6, 0}, {4, 0}, {4, 4}}, {5}},
        {"points on one line", {{0, 0}, {1, 1}, {2, 2}}, {3}},
        {"a hole that crosses it", InSquare({{1, 1}, {6, 2}, {1, 3}}), {4, 3}},
        {"a hole along one of its edges", InSquare({{1, 0}, {2, 0}, {2, 2}}), {4, 3}},
        {"a hole beside it", InSquare({{6, 1}, {7, 1}, {7, 2}}), {4, 3}},
        {"a hole in a hole",
         InSquare({{1, 1}, {3, 1}, {3, 3}, {1, 3}, {1.5, 1.5}, {2, 1.5}, {2, 2}}),
         {4, 4, 3}},
        {"in its own hole", {{1, 1}, {2, 1}, {2, 2}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}, {3, 4}},
    };
    return outlines;
}

const Table kBadOutlines("outlines that are none", [] {
    Matrix matrix;
    matrix.columns = {"check, simplify and decompose"};
    for (const BadOutline &outline : BadOutlines())
        matrix.rows.emplace_back(outline.name);
    matrix.answer = [](size_t row, size_t) {
        return AskedOf(BadOutlines()[row].points, BadOutlines()[row].counts);
    };
    return matrix;
});

} // namespace
