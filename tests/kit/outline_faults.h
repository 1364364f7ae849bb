// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_OUTLINE_FAULTS_H
#define BMR_TEST_OUTLINE_FAULTS_H

#include <cstdint>
#include <set>
#include <vector>

#include "outline_oracle.h"

/// @file
/// What is wrong with an outline, by looking at all pairs of edges, in rational arithmetic. Rings have at
/// least three points, and no two equal ones behind each other.

namespace outlines {

struct Edge {
    bmr_vec2 a, b;
};

/// Of a point on the edge's line: in the closed edge?
inline bool IsWithin(const Edge &e, bmr_vec2 p) {
    return Same(e.a, p) || Same(e.b, p) || Before(e.a, p) == Before(p, e.b);
}

inline bool IsOn(const Edge &e, bmr_vec2 p) {
    return exact::Orientation(e.a, e.b, p) == 0 && IsWithin(e, p);
}

inline bool CrossInside(const Edge &e, const Edge &f) {
    return exact::Orientation(e.a, e.b, f.a) * exact::Orientation(e.a, e.b, f.b) < 0 &&
           exact::Orientation(f.a, f.b, e.a) * exact::Orientation(f.a, f.b, e.b) < 0;
}

inline bool Meet(const Edge &e, const Edge &f) {
    return IsOn(e, f.a) || IsOn(e, f.b) || IsOn(f, e.a) || IsOn(f, e.b) || CrossInside(e, f);
}

inline bool Overlap(const Edge &e, const Edge &f) {
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
inline bool ComesFirst(bmr_vec2 place, bmr_vec2 a, bmr_vec2 p, bmr_vec2 b) {
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
inline bool CrossInPlace(const Rings &rings, bmr_vec2 place) {
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
inline bool IsHoleOutside(const Rings &rings, uint32_t ring) {
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
inline std::set<bmr_error> FaultsOf(const bmr_rings &given) {
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

} // namespace outlines

#endif
