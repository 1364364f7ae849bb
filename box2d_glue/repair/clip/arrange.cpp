// SPDX-License-Identifier: MIT
#include "clip/clip.h"

#include <algorithm>
#include <cstdint>

/// @file
/// The clipper finds where edges cross; its rings may still run along each other, and it may hang a hole on
/// the wrong ring. So rings are made here, of its edges alone. Edges that lie on each other cancel in pairs.
/// Around each corner the sectors between the edges that are left are solid and void in turn: one search from
/// the leftmost corner of each connected part says which. A walk that keeps the solid on its left then finds
/// the rings, and turns off into the nearest edge at each corner, so that solids that touch stay apart.

namespace bmr::repair {

namespace {

constexpr uint32_t kNone = UINT32_MAX;

struct Edge {
    Place left, right; ///< in the order of Before
};

bool operator==(const Edge &a, const Edge &b) {
    return a.left == b.left && a.right == b.right;
}

bool EdgeBefore(const Edge &a, const Edge &b) {
    return a.left == b.left ? Before(a.right, b.right) : Before(a.left, b.left);
}

/// The edges that an odd number of paths runs along, in order.
std::vector<Edge> OddEdges(const Paths &paths) {
    std::vector<Edge> all, odd;
    for (const Path &path : paths)
        for (size_t i = 0; i < path.size(); ++i) {
            const Place &a = path[i], &b = path[i + 1 < path.size() ? i + 1 : 0];
            if (a != b)
                all.push_back(Before(a, b) ? Edge{a, b} : Edge{b, a});
        }
    std::sort(all.begin(), all.end(), EdgeBefore);
    for (size_t i = 0; i < all.size();) {
        const size_t first = i;
        while (i < all.size() && all[i] == all[first])
            ++i;
        if ((i - first) % 2 == 1)
            odd.push_back(all[first]);
    }
    return odd;
}

bool Cross(const Edge &e, const Edge &f) {
    return Orientation(e.left, e.right, f.left) * Orientation(e.left, e.right, f.right) < 0 &&
           Orientation(f.left, f.right, e.left) * Orientation(f.left, f.right, e.right) < 0;
}

/// Of edges in order: each looks at those that begin before it and end behind its left end.
bool AnyCross(const std::vector<Edge> &edges) {
    std::vector<Edge> active;
    for (const Edge &edge : edges) {
        const auto [low, high] = std::minmax(edge.left.Y, edge.right.Y);
        size_t kept = 0;
        for (const Edge &other : active) {
            if (other.right.X <= edge.left.X)
                continue;
            if (std::min(other.left.Y, other.right.Y) < high && std::max(other.left.Y, other.right.Y) > low &&
                Cross(edge, other))
                return true;
            active[kept++] = other;
        }
        active.resize(kept);
        active.push_back(edge);
    }
    return false;
}

/// Is edge e above edge f, where a vertical line meets both? They do not cross, and are not the same.
bool IsAbove(const Edge &e, const Edge &f) {
    if (Before(e.left, f.left))
        return !IsAbove(f, e);
    const int side = Orientation(f.left, f.right, e.left);
    return (side != 0 ? side : Orientation(f.left, f.right, e.right)) > 0;
}

/// Half 2e of edge e goes from its left end to its right end, half 2e + 1 back.
class Arrangement {
public:
    explicit Arrangement(std::vector<Edge> edges)
        : m_edges(std::move(edges)), m_solid(2 * m_edges.size(), Side::Unknown),
          m_ring(2 * m_edges.size(), kNone) {
        MakeCorners();
    }

    std::vector<Solid> Find() {
        for (uint32_t corner = 0; corner + 1 < m_first.size(); ++corner)
            if (m_solid[m_out[m_first[corner]]] == Side::Unknown)
                FindPart(corner);
        return std::move(m_solids);
    }

private:
    enum class Side : uint8_t { Unknown, Void, Solid };

    const Place &From(uint32_t half) const {
        const Edge &edge = m_edges[half / 2];
        return half % 2 == 0 ? edge.left : edge.right;
    }
    const Place &To(uint32_t half) const { return From(half ^ 1); }

    /// By angle from straight below, counter-clockwise.
    bool TurnsBefore(uint32_t a, uint32_t b) const {
        const bool leftA = a % 2 == 1, leftB = b % 2 == 1;
        return leftA != leftB ? leftB : Orientation(From(a), To(a), To(b)) > 0;
    }

    /// Halves by the corner that they begin at, corners from left to right, halves around each.
    void MakeCorners() {
        m_out.resize(2 * m_edges.size());
        m_place.resize(m_out.size());
        for (uint32_t half = 0; half < m_out.size(); ++half)
            m_out[half] = half;
        std::sort(m_out.begin(), m_out.end(), [this](uint32_t a, uint32_t b) {
            return From(a) == From(b) ? TurnsBefore(a, b) : Before(From(a), From(b));
        });
        for (uint32_t i = 0; i < m_out.size(); ++i) {
            m_place[m_out[i]] = i;
            if (i == 0 || From(m_out[i]) != From(m_out[i - 1]))
                m_first.push_back(i);
            m_corner.push_back(static_cast<uint32_t>(m_first.size() - 1));
        }
        m_first.push_back(static_cast<uint32_t>(m_out.size()));
    }
    uint32_t CornerOf(uint32_t half) const { return m_corner[m_place[half]]; }

    /// The edges at and to the left of a place that end to the right of it: those below it. Places are asked
    /// from left to right.
    struct Below {
        uint32_t count, topmost;
    };
    Below LookBelow(const Place &place) {
        while (m_met < m_edges.size() && m_edges[m_met].left.X <= place.X)
            m_active.push_back(m_met++);
        m_active.erase(std::remove_if(m_active.begin(), m_active.end(),
                                      [&](uint32_t e) { return m_edges[e].right.X <= place.X; }),
                       m_active.end());
        Below below = {0, kNone};
        for (const uint32_t e : m_active) {
            if (Orientation(m_edges[e].left, m_edges[e].right, place) <= 0)
                continue;
            ++below.count;
            if (below.topmost == kNone || IsAbove(m_edges[e], m_edges[below.topmost]))
                below.topmost = e;
        }
        return below;
    }

    /// A connected part, from its leftmost corner.
    void FindPart(uint32_t corner) {
        const Below below = LookBelow(From(m_out[m_first[corner]]));
        const bool inside = below.count % 2 == 1;
        // The sector around the corner that is outside of the part lies behind its last half.
        const uint32_t outside = m_out[m_first[corner + 1] - 1];
        std::vector<uint32_t> halves = FindSides(outside, inside ? Side::Solid : Side::Void);
        if (inside)
            AddRing(outside, m_ring[2 * below.topmost]);
        std::sort(halves.begin(), halves.end());
        for (const uint32_t half : halves)
            if (m_solid[half] == Side::Solid && m_ring[half] == kNone) {
                m_solids.emplace_back();
                AddRing(half, static_cast<uint32_t>(m_solids.size() - 1));
            }
    }

    /// Says which halves of the part have the solid on their left; returns all of them.
    std::vector<uint32_t> FindSides(uint32_t half, Side side) {
        std::vector<uint32_t> found, open = {half};
        m_solid[half] = side;
        while (!open.empty()) {
            const uint32_t start = open.back(), corner = CornerOf(start), count = CountAt(corner);
            open.pop_back();
            Side now = m_solid[start];
            for (uint32_t i = 0; i < count; ++i) { // around the corner, sector by sector
                const uint32_t out = m_out[m_first[corner] + (m_place[start] - m_first[corner] + i) % count];
                if (i > 0 && m_solid[out] != Side::Unknown)
                    break;
                m_solid[out] = now;
                found.push_back(out);
                now = now == Side::Solid ? Side::Void : Side::Solid;
                if (m_solid[out ^ 1] == Side::Unknown) {
                    m_solid[out ^ 1] = now;
                    open.push_back(out ^ 1);
                }
            }
        }
        return found;
    }
    uint32_t CountAt(uint32_t corner) const { return m_first[corner + 1] - m_first[corner]; }

    /// The half that follows this one on the boundary of the solid on its left: the first one clockwise.
    uint32_t Next(uint32_t half) const {
        const uint32_t back = half ^ 1, corner = CornerOf(back), first = m_first[corner];
        return m_place[back] > first ? m_out[m_place[back] - 1] : m_out[first + CountAt(corner) - 1];
    }

    /// The ring that the half is of, without corners at which it goes straight on.
    void AddRing(uint32_t half, uint32_t solid) {
        Path ring;
        uint32_t here = half;
        do {
            m_ring[here] = solid;
            const uint32_t next = Next(here);
            if (Orientation(From(here), To(here), To(next)) != 0)
                ring.push_back(To(here));
            here = next;
        } while (here != half);
        m_solids[solid].push_back(std::move(ring));
    }

    std::vector<Edge> m_edges;    ///< in the order of EdgeBefore
    std::vector<Side> m_solid;    ///< of each half: what is on its left
    std::vector<uint32_t> m_ring; ///< of each half with a solid on its left: which, once its ring is found
    std::vector<uint32_t> m_out, m_place; ///< halves by corner, and where each is there
    std::vector<uint32_t> m_first;        ///< of each corner, in m_out; and the end
    std::vector<uint32_t> m_corner;       ///< of each of m_out
    uint32_t m_met = 0;
    std::vector<uint32_t> m_active;
    std::vector<Solid> m_solids;
};

} // namespace

bool Arrange(const Paths &paths, std::vector<Solid> *solids) {
    std::vector<Edge> edges = OddEdges(paths);
    if (AnyCross(edges))
        return false;
    *solids = Arrangement(std::move(edges)).Find();
    return true;
}

} // namespace bmr::repair
