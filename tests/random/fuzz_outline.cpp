// SPDX-License-Identifier: MIT
// Outlines: rings of places on a grid, or of numbers of any kind. What is wrong with them is found by looking
// at all pairs of edges in rational arithmetic; what is an outline has pieces that are exactly its solid, and
// so has what is left of it within a tolerance.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "boomerang/outline.h"
#include "bytes.h"
#include "harness.h"
#include "outline_faults.h"
#include "outline_oracle.h"

namespace {

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
            if (!outlines::Same(point(i), point(i + count - 1)))
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

/// Of an answer, the error that it should be.
void CheckError(const Outline &outline, bmr_error error) {
    if (!IsFinite(outline)) {
        FUZZ_CHECK(error == BMR_ERROR_NOT_FINITE, "not finite, and the answer is %d", error);
        return;
    }
    const bmr_error too_short = ShortOf(outline);
    if (too_short != BMR_OK) {
        FUZZ_CHECK(error == too_short, "a ring that is none, and the answer is %d", error);
        return;
    }
    const std::set<bmr_error> faults = outlines::FaultsOf(outline.Rings());
    FUZZ_CHECK(faults.empty() ? error == BMR_OK : faults.count(error) == 1,
               "%zu faults, and the answer is %d", faults.size(), error);
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
    FUZZ_CHECK(ShortOf(simple) == BMR_OK && outlines::FaultsOf(simple.Rings()).empty(),
               "a simplified outline is none");
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
    FUZZ_CHECK(bmr_outline_check(&rings, nullptr, nullptr) == error, "check and decompose do not agree");
    if (fuzz_control("missed") && error == BMR_ERROR_CROSSING_EDGES)
        error = BMR_OK;
    if (fuzz_control("refused") && error == BMR_OK)
        error = BMR_ERROR_CROSSING_EDGES;
    CheckError(outline, error);
    if (error == BMR_OK) {
        CheckPieces(outline, pieces);
        if (std::isfinite(tolerance))
            CheckTolerance(outline, tolerance);
    }
    bmr_outline_pieces_destroy(pieces, nullptr);
    return 0;
}
