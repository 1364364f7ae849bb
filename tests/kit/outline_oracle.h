// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_OUTLINE_ORACLE_H
#define BMR_TEST_OUTLINE_ORACLE_H

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "boomerang/outline.h"
#include "exact.h"

/// @file
/// Are these pieces the solid of this outline, exactly? In rational arithmetic, with nothing of core's.
///
/// Each piece is convex, so its boundary winds once around every point inside and not at all around any
/// other. Boundaries are added up as chains of directed edges: inner edges have to cancel each other, and the
/// others to tile the rings, each in the direction that has the solid on its left. Then the sum of the
/// pieces' boundaries is the boundary of the solid, and so is the sum of their winding numbers: one piece is
/// around every point of the solid's inside, none around any other. That is: no two overlap, and all together
/// are the solid.

namespace outlines {

inline bool Same(bmr_vec2 a, bmr_vec2 b) {
    return a.x == b.x && a.y == b.y;
}

inline bool Before(bmr_vec2 a, bmr_vec2 b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

/// Convex and counter-clockwise, once around, with an area; it may go straight on at a corner.
inline bool IsPiece(const std::vector<bmr_vec2> &v) {
    const size_t n = v.size();
    size_t turns = 0, rises = 0;
    for (size_t i = 0; i < n; ++i) {
        const bmr_vec2 a = v[i], b = v[(i + 1) % n], c = v[(i + 2) % n];
        const int turn = exact::Orientation(a, b, c);
        if (turn < 0 || Same(a, b) || (turn == 0 && Before(a, b) != Before(b, c)))
            return false;
        turns += turn > 0 ? 1 : 0;
        rises += !Before(a, b) && Before(b, c) ? 1 : 0;
    }
    return turns >= 3 && rises == 1;
}

/// The direction of a ring that crosses and overlaps nothing: 1 counter-clockwise, -1 clockwise.
inline int DirectionOf(const std::vector<bmr_vec2> &ring) {
    const size_t n = ring.size();
    const size_t first =
        static_cast<size_t>(std::min_element(ring.begin(), ring.end(), Before) - ring.begin());
    if (std::count_if(ring.begin(), ring.end(), [&](bmr_vec2 p) { return Same(p, ring[first]); }) == 1)
        return exact::Orientation(ring[(first + n - 1) % n], ring[first], ring[(first + 1) % n]);
    mpq_class area = 0;
    for (size_t i = 0; i < n; ++i) {
        const bmr_vec2 a = ring[i], b = ring[(i + 1) % n];
        area += mpq_class(a.x) * mpq_class(b.y) - mpq_class(a.y) * mpq_class(b.x);
    }
    return sgn(area);
}

/// One edge of the outline and the pieces' edges that lie on it: joined, they lead from its one end to the
/// other.
inline bool IsTiled(bmr_vec2 from, bmr_vec2 to, std::vector<std::pair<bmr_vec2, bmr_vec2>> parts) {
    const bool ahead = Before(from, to);
    std::sort(parts.begin(), parts.end(), [&](const auto &a, const auto &b) {
        return ahead ? Before(a.first, b.first) : Before(b.first, a.first);
    });
    bmr_vec2 at = from;
    for (const auto &part : parts) {
        if (!Same(part.first, at) || exact::Orientation(from, to, part.second) != 0 ||
            Before(part.first, part.second) != ahead || Same(part.first, part.second))
            return false;
        at = part.second;
    }
    return Same(at, to);
}

/// Is a point of the outline inside of an inner edge? Each is to be a corner of the pieces that it touches.
inline bool IsOnInnerEdge(const bmr_outline_pieces &o, bmr_vec2 begin, bmr_vec2 end) {
    const bmr_vec2 low = Before(begin, end) ? begin : end, high = Before(begin, end) ? end : begin;
    for (uint32_t i = 0; i < o.point_count; ++i)
        if (Before(low, o.points[i]) && Before(o.points[i], high) &&
            exact::Orientation(begin, end, o.points[i]) == 0)
            return true;
    return false;
}

/// Beyond so many points it would take too long to look at them all for each edge.
constexpr uint32_t kMostForAllPairs = 256;

/// What is wrong with the pieces of an outline without faults; empty: nothing.
inline std::string Complaint(const bmr_rings &rings, const bmr_outline_pieces &o) {
    const uint32_t none = BMR_OUTLINE_NONE;
    std::vector<uint32_t> ring_begin = {0};
    for (uint32_t r = 0; r < rings.ring_count; ++r)
        ring_begin.push_back(ring_begin.back() + rings.counts[r]);
    if (o.point_count != ring_begin.back() || o.first[0] != 0 || o.first[o.piece_count] != o.edge_count)
        return "counts";
    for (uint32_t i = 0; i < o.point_count; ++i)
        if (!Same(o.points[i], rings.points[i]))
            return "a point has moved";
    std::vector<bmr_vec2> begin, end;
    for (uint32_t p = 0; p < o.piece_count; ++p) {
        std::vector<bmr_vec2> piece;
        for (uint32_t e = o.first[p]; e < o.first[p + 1]; ++e) {
            if (o.edges[e].point >= o.point_count || o.edges[e].piece != p)
                return "an index";
            piece.push_back(o.points[o.edges[e].point]);
        }
        if (!IsPiece(piece))
            return "a piece is not convex";
        for (size_t i = 0; i < piece.size(); ++i) {
            begin.push_back(piece[i]);
            end.push_back(piece[(i + 1) % piece.size()]);
        }
    }
    std::vector<std::vector<std::pair<bmr_vec2, bmr_vec2>>> parts(o.point_count);
    for (uint32_t e = 0; e < o.edge_count; ++e) {
        const bmr_outline_edge &edge = o.edges[e];
        if ((edge.outline == none) == (edge.twin == none))
            return "an edge is inner and outer, or neither";
        if (edge.outline != none) {
            if (edge.outline >= o.point_count)
                return "an index of an outline's edge";
            parts[edge.outline].emplace_back(begin[e], end[e]);
        } else if (edge.twin >= o.edge_count || o.edges[edge.twin].twin != e ||
                   !Same(begin[edge.twin], end[e]) || !Same(end[edge.twin], begin[e]))
            return "a twin";
        else if (o.point_count <= kMostForAllPairs && IsOnInnerEdge(o, begin[e], end[e]))
            return "a point inside of an inner edge";
    }
    for (uint32_t r = 0; r < rings.ring_count; ++r) {
        const uint32_t first = ring_begin[r], count = rings.counts[r];
        const std::vector<bmr_vec2> ring(rings.points + first, rings.points + first + count);
        const bool along = (DirectionOf(ring) > 0) == (r == 0);
        for (uint32_t i = 0; i < count; ++i) {
            const bmr_vec2 a = ring[i], b = ring[(i + 1) % count];
            if (!IsTiled(along ? a : b, along ? b : a, parts[first + i]))
                return "an edge of the outline is not covered once";
        }
    }
    return {};
}

} // namespace outlines

#endif
