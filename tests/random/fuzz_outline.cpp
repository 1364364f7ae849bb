// SPDX-License-Identifier: MIT
// Outlines: rings of places on a grid, or of numbers of any kind. What is wrong with them is found by looking
// at all pairs of edges in rational arithmetic, and the edges that are named are those; what is an outline
// has pieces that are exactly its solid, and so has what is left of it within a tolerance.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "boomerang/outline.h"
#include "bytes.h"
#include "harness.h"
#include "outline_oracle.h"

namespace {

using outlines::Before, outlines::Same;

// --- what is wrong with an outline, by looking at all pairs of edges, in rational arithmetic. Rings have at
// least three points, and no two equal ones behind each other ---

struct Edge {
    bmr_vec2 a, b;
};

/// Of a point on the edge's line: in the closed edge?
bool IsWithin(const Edge &e, bmr_vec2 p) {
    return Same(e.a, p) || Same(e.b, p) || Before(e.a, p) == Before(p, e.b);
}

bool IsOn(const Edge &e, bmr_vec2 p) {
    return exact::Orientation(e.a, e.b, p) == 0 && IsWithin(e, p);
}

bool CrossInside(const Edge &e, const Edge &f) {
    return exact::Orientation(e.a, e.b, f.a) * exact::Orientation(e.a, e.b, f.b) < 0 &&
           exact::Orientation(f.a, f.b, e.a) * exact::Orientation(f.a, f.b, e.b) < 0;
}

bool Meet(const Edge &e, const Edge &f) {
    return IsOn(e, f.a) || IsOn(e, f.b) || IsOn(f, e.a) || IsOn(f, e.b) || CrossInside(e, f);
}

bool Overlap(const Edge &e, const Edge &f) {
    if (exact::Orientation(e.a, e.b, f.a) != 0 || exact::Orientation(e.a, e.b, f.b) != 0)
        return false;
    const auto low = [](const Edge &g) { return Before(g.a, g.b) ? g.a : g.b; };
    const auto high = [](const Edge &g) { return Before(g.a, g.b) ? g.b : g.a; };
    const bmr_vec2 from = Before(low(e), low(f)) ? low(f) : low(e);
    const bmr_vec2 to = Before(high(e), high(f)) ? high(e) : high(f);
    return Before(from, to);
}

/// Rings with all that has to be known of them.
struct Rings {
    std::vector<Edge> edges;
    std::vector<uint32_t> ring, before; ///< of each edge: its ring, and the edge that ends where it begins

    explicit Rings(const bmr_rings &rings) {
        uint32_t begin = 0;
        for (uint32_t r = 0; r < rings.ring_count; ++r) {
            const uint32_t count = rings.counts[r];
            for (uint32_t i = 0; i < count; ++i) {
                edges.push_back({rings.points[begin + i], rings.points[begin + (i + 1) % count]});
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
};

/// Turning counter-clockwise around a place from the direction to a: does p come before b? All different.
bool ComesFirst(bmr_vec2 place, bmr_vec2 a, bmr_vec2 p, bmr_vec2 b) {
    const auto past_half = [&](bmr_vec2 q) {
        const int turn = exact::Orientation(place, a, q);
        return turn < 0 || (turn == 0 && Before(place, a) == Before(place, q));
    };
    if (past_half(p) != past_half(b))
        return past_half(b);
    return exact::Orientation(place, p, b) > 0;
}

/// Do two passages through a place cross, which leave it in four directions? (Where two directions are one,
/// edges overlap.)
bool CrossInPlace(const Rings &rings, bmr_vec2 place) {
    const std::vector<Edge> passages = rings.Passages(place);
    std::vector<bmr_vec2> ends;
    for (const Edge &e : passages)
        for (const bmr_vec2 end : {e.a, e.b}) {
            for (const bmr_vec2 other : ends)
                if (exact::Orientation(place, end, other) == 0 && Before(place, end) == Before(place, other))
                    return false;
            ends.push_back(end);
        }
    for (const Edge &e : passages)
        for (const Edge &f : passages)
            if (&e != &f && ComesFirst(place, e.a, f.a, e.b) != ComesFirst(place, e.a, f.b, e.b))
                return true;
    return false;
}

/// Right above the lowest edge at its leftmost place a hole is void: below are an even number of edges, that
/// one among them.
bool IsHoleOutside(const Rings &rings, uint32_t ring) {
    const Edge *any = nullptr;
    bmr_vec2 place = {0.0, 0.0}, lowest = {0.0, 0.0};
    for (size_t i = 0; i < rings.edges.size(); ++i)
        if (rings.ring[i] == ring && (any == nullptr || Before(rings.edges[i].a, place))) {
            any = &rings.edges[i];
            place = any->a;
        }
    any = nullptr;
    for (size_t i = 0; i < rings.edges.size(); ++i) {
        const Edge &e = rings.edges[i];
        if (rings.ring[i] != ring || (!Same(e.a, place) && !Same(e.b, place)))
            continue;
        const bmr_vec2 end = Same(e.a, place) ? e.b : e.a;
        if (any == nullptr || exact::Orientation(place, lowest, end) < 0) {
            any = &e;
            lowest = end;
        }
    }
    size_t below = 0;
    for (const Edge &e : rings.edges) {
        const bmr_vec2 left = Before(e.a, e.b) ? e.a : e.b, right = Before(e.a, e.b) ? e.b : e.a;
        if (Before(place, left) || !Before(place, right))
            continue; // it does not go on beyond the place
        const int side = exact::Orientation(left, right, place);
        below += side > 0 || (side == 0 && exact::Orientation(place, lowest, right) <= 0) ? 1 : 0;
    }
    return below % 2 == 1;
}

/// All kinds of faults that there are but for the two that a ring has for itself.
std::set<bmr_error> FaultsOf(const bmr_rings &given) {
    std::set<bmr_error> faults;
    const Rings rings(given);
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
    for (uint32_t r = 1; r < given.ring_count; ++r)
        if (IsHoleOutside(rings, r))
            faults.insert(BMR_ERROR_HOLE_OUTSIDE);
    return faults;
}

// --- the outlines ---

/// The oracle looks at all pairs.
constexpr uint32_t kMostPoints = 48, kMostRings = 6;

struct Outline {
    std::vector<bmr_vec2> points;
    std::vector<uint32_t> counts;
    bmr_rings Rings() const { return {points.data(), counts.data(), static_cast<uint32_t>(counts.size())}; }
};

double Coordinate(fuzz_bytes *bytes, uint32_t how) {
    return how < 6 ? static_cast<double>(fuzz_below(bytes, 2u << how)) : fuzz_number(bytes);
}

Outline ReadOutline(fuzz_bytes *bytes) {
    Outline outline;
    const uint32_t how = fuzz_below(bytes, 8), rings = 1 + fuzz_below(bytes, kMostRings);
    // A frame that may make holes of the rings behind it.
    if (fuzz_u8(bytes) % 2 == 1 && how < 6) {
        const double s = static_cast<double>((2u << how) - 1);
        outline.points = {{0.0, 0.0}, {s, 0.0}, {s, s}, {0.0, s}};
        outline.counts = {4};
    }
    for (uint32_t r = 0; r < rings; ++r) {
        const uint32_t count = fuzz_below(bytes, kMostPoints / 2);
        uint32_t made = 0;
        for (; made < count && outline.points.size() < kMostPoints && !fuzz_done(bytes); ++made) {
            const double x = Coordinate(bytes, how);
            outline.points.push_back({x, Coordinate(bytes, how)});
        }
        outline.counts.push_back(made);
    }
    return outline;
}

bool IsFinite(const Outline &outline) {
    return std::all_of(outline.points.begin(), outline.points.end(),
                       [](bmr_vec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}

/// Without points that repeat the next one of their ring; `kept` are the indices of the others.
Outline WithoutRepeated(const Outline &outline, std::vector<uint32_t> *kept) {
    Outline distinct;
    uint32_t begin = 0;
    for (const uint32_t count : outline.counts) {
        const auto point = [&](uint32_t i) { return outline.points[begin + i % count]; };
        std::vector<uint32_t> firsts; // of each run, which may begin at the end of the ring
        for (uint32_t i = 0; i < count; ++i)
            if (!Same(point(i), point(i + count - 1)))
                firsts.push_back(begin + i);
        if (firsts.empty() && count > 0)
            firsts.push_back(begin);
        // The run that goes on from the end of the ring to its beginning is known by its lowest index.
        if (count > 0 && !firsts.empty() && firsts.front() != begin) {
            firsts.pop_back();
            firsts.insert(firsts.begin(), begin);
        }
        for (const uint32_t first : firsts) {
            kept->push_back(first);
            distinct.points.push_back(outline.points[first]);
        }
        distinct.counts.push_back(static_cast<uint32_t>(firsts.size()));
        begin += count;
    }
    return distinct;
}

/// TOO_FEW_POINTS where a ring has too few; BMR_OK.
bmr_error ShortOf(const Outline &outline) {
    return std::all_of(outline.counts.begin(), outline.counts.end(),
                       [](uint32_t count) { return count >= 3; })
               ? BMR_OK
               : BMR_ERROR_TOO_FEW_POINTS;
}

/// Does the fault name edges, and their rings, where it is?
void CheckFault(const Rings &rings, const bmr_outline_fault &fault) {
    const uint32_t first = fault.edge[0] + (fuzz_control("fault") ? 1 : 0);
    FUZZ_CHECK(first < rings.edges.size() && fault.ring[0] == rings.ring[first], "edge %u of ring %u", first,
               fault.ring[0]);
    if (fault.error == BMR_ERROR_HOLE_OUTSIDE) {
        FUZZ_CHECK(IsHoleOutside(rings, fault.ring[0]), "ring %u is inside", fault.ring[0]);
        return;
    }
    const uint32_t second = fault.edge[1];
    FUZZ_CHECK(first < second && second < rings.edges.size() && fault.ring[1] == rings.ring[second],
               "edges %u and %u of ring %u", first, second, fault.ring[1]);
    const Edge &e = rings.edges[first], &f = rings.edges[second];
    FUZZ_CHECK(fault.error == BMR_ERROR_OVERLAPPING_EDGES ? Overlap(e, f) : Meet(e, f),
               "fault %d is not of the edges %u and %u", fault.error, first, second);
}

/// Of an answer, the error that it should be.
void CheckError(const Outline &outline, bmr_error error, const bmr_outline_fault &fault) {
    if (!IsFinite(outline)) {
        FUZZ_CHECK(error == BMR_ERROR_NOT_FINITE, "not finite, and the answer is %d", error);
        return;
    }
    const bmr_error too_short = ShortOf(outline);
    if (too_short != BMR_OK) {
        FUZZ_CHECK(error == too_short, "a ring that is none, and the answer is %d", error);
        return;
    }
    const std::set<bmr_error> faults = FaultsOf(outline.Rings());
    FUZZ_CHECK(faults.empty() ? error == BMR_OK : faults.count(error) == 1,
               "%zu faults, and the answer is %d", faults.size(), error);
    FUZZ_CHECK(fault.error == error, "answer %d, fault %d", error, fault.error);
    if (!faults.empty())
        CheckFault(Rings(outline.Rings()), fault);
}

void CheckPieces(const Outline &outline, bmr_outline_pieces *pieces) {
    std::vector<bmr_outline_edge> edges(pieces->edges, pieces->edges + pieces->edge_count);
    bmr_outline_pieces falsified = *pieces;
    falsified.edges = edges.data();
    if (fuzz_control("corner"))
        edges[0].point = edges[1].point;
    if (fuzz_control("edge"))
        for (bmr_outline_edge &edge : edges)
            if (edge.outline != BMR_OUTLINE_NONE)
                edge.outline = 0;
    if (fuzz_control("piece")) {
        --falsified.piece_count;
        falsified.edge_count = falsified.first[falsified.piece_count];
    }
    const std::string complaint = outlines::Complaint(outline.Rings(), falsified);
    FUZZ_CHECK(complaint.empty(), "%s", complaint.c_str());
    FUZZ_CHECK(bmr_outline_pieces_audit(pieces) == BMR_OK, "the audit fails");
}

/// Pieces within a tolerance are those of the outline that is left, which is one.
void CheckTolerance(const Outline &outline, double tolerance) {
    const bmr_rings rings = outline.Rings();
    std::vector<uint32_t> kept(outline.points.size()), counts(outline.counts.size());
    FUZZ_CHECK(bmr_outline_simplify(&rings, tolerance, nullptr, kept.data(), counts.data(), nullptr) ==
                   BMR_OK,
               "an outline is not simplified");
    Outline simple;
    for (const uint32_t count : counts) {
        for (uint32_t i = 0; i < count; ++i)
            simple.points.push_back(outline.points[kept[simple.points.size()]]);
        if (count > 0)
            simple.counts.push_back(count);
    }
    if (fuzz_control("simplify"))
        std::swap(simple.points[0], simple.points[1]);
    FUZZ_CHECK(ShortOf(simple) == BMR_OK && FaultsOf(simple.Rings()).empty(), "a simplified outline is none");
    const bmr_rings left = simple.Rings();
    const bmr_outline_def def = {tolerance};
    bmr_outline_pieces *pieces = nullptr, *same = nullptr;
    FUZZ_CHECK(bmr_outline_decompose(&rings, &def, nullptr, &pieces, nullptr) == BMR_OK &&
                   bmr_outline_decompose(&left, nullptr, nullptr, &same, nullptr) == BMR_OK,
               "no pieces within a tolerance");
    CheckPieces(simple, same);
    // Without a tolerance nothing is left out before it is cut.
    FUZZ_CHECK(tolerance == 0.0 ||
                   (pieces->piece_count == same->piece_count && pieces->edge_count == same->edge_count),
               "not the pieces of the simplified outline");
    for (uint32_t e = 0; e < pieces->edge_count && tolerance > 0.0; ++e)
        FUZZ_CHECK(pieces->edges[e].point == kept[same->edges[e].point], "not the points of the pieces");
    bmr_outline_pieces_destroy(pieces, nullptr);
    bmr_outline_pieces_destroy(same, nullptr);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fuzz_bytes bytes = fuzz_bytes_make(data, size);
    const double tolerance = std::fabs(fuzz_number(&bytes));
    const Outline drawn = ReadOutline(&bytes);
    std::vector<uint32_t> kept;
    const Outline outline = WithoutRepeated(drawn, &kept);
    const bmr_rings given = drawn.Rings(), rings = outline.Rings();
    bmr_outline_fault fault = {};
    bmr_outline_pieces *pieces = nullptr;
    bmr_error error = bmr_outline_decompose(&rings, nullptr, nullptr, &pieces, &fault);
    bmr_outline_pieces *same = nullptr;
    FUZZ_CHECK(bmr_outline_decompose(&given, nullptr, nullptr, &same, nullptr) == error,
               "repeated points are not left out");
    for (uint32_t e = 0; error == BMR_OK && e < pieces->edge_count; ++e)
        FUZZ_CHECK(pieces->edge_count == same->edge_count &&
                       same->edges[e].point == kept[pieces->edges[e].point],
                   "repeated points are in pieces");
    bmr_outline_pieces_destroy(same, nullptr);
    bmr_outline_fault again = {};
    FUZZ_CHECK(bmr_outline_check(&rings, nullptr, &again) == error && again.error == fault.error &&
                   again.edge[0] == fault.edge[0],
               "check and decompose do not agree");
    if (fuzz_control("missed") && error == BMR_ERROR_CROSSING_EDGES)
        error = fault.error = BMR_OK;
    if (fuzz_control("refused") && error == BMR_OK)
        error = fault.error = BMR_ERROR_CROSSING_EDGES;
    CheckError(outline, error, fault);
    if (error == BMR_OK) {
        CheckPieces(outline, pieces);
        if (std::isfinite(tolerance))
            CheckTolerance(outline, tolerance);
    }
    bmr_outline_pieces_destroy(pieces, nullptr);
    return 0;
}
