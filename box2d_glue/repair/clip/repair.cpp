// SPDX-License-Identifier: MIT
#include "boomerang/repair.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <new>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include <polyclipping/clipper.hpp>

#include "boomerang/vector.h"

namespace bmr {

namespace {

/// Places of the grid, in its steps; the clipper's own types. Paths are closed.
using Place = ClipperLib::IntPoint;
using Path = ClipperLib::Path;
using Paths = ClipperLib::Paths;

/// Up to here products of differences fit 64 bits, the clipper's and ours.
constexpr double kMostSteps = static_cast<double>(ClipperLib::loRange);

/// From below; beside each other from right to left.
bool Before(const Place &a, const Place &b) {
    return std::tie(a.Y, b.X) < std::tie(b.Y, a.X);
}

bmr_vec2 Vector(const Place &place) {
    return {static_cast<double>(place.X), static_cast<double>(place.Y)};
}

/// 1 where a, b, c turn left, -1 where they turn right, 0 on a line. Exact: a difference has 31 bits.
int Orientation(const Place &a, const Place &b, const Place &c) {
    const auto left = (b.X - a.X) * (c.Y - a.Y), right = (b.Y - a.Y) * (c.X - a.X);
    return (left > right) - (left < right);
}

/// An outer ring, counter-clockwise, and the holes of its solid, clockwise.
using Solid = Paths;

/// Where paths cross the clipper rounds to the grid, and what was rounded may cross anew. Then it is clipped
/// again: one in a hundred times with random rings, and never a third time.
constexpr int kMostClips = 3;
/// Points go to others, and edges bend to points, that are not farther than this, in snaps.
constexpr double kReach = 0.2;
/// In steps: edges that pass through a place's square bend to the place. So edges that meet at a small angle,
/// where the clipper takes a crossing for an end, have that end in common.
constexpr double kSquare = 0.75;
/// A step is at most snap / 16. A point is rounded once, by sqrt(1/2) steps; and at each clipping, first of
/// its own outline and then of all, it is rounded and bent.
static_assert(2.0 * kReach + (0.7072 + 2 * kMostClips * (0.7072 + kSquare)) / 16.0 < 1.0,
              "nothing moves farther than snap");
/// Input that takes seconds, and less than a gigabyte.
constexpr size_t kMostPoints = size_t{1} << 20;
/// Less than a gigabyte in the clipper.
constexpr size_t kMostPlaces = size_t{1} << 22;

// Points go to others, and edges bend to points.

/// All places of some paths, in the order of Before.
std::vector<Place> PlacesOf(const Paths &paths) {
    std::vector<Place> places;
    for (const Path &path : paths)
        places.insert(places.end(), path.begin(), path.end());
    std::sort(places.begin(), places.end(), Before);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
}

/// A place beside an edge, and how far along it that is, 0 to 1.
struct Stop {
    double along;
    Place place;
};

bool IsBeside(const Place &a, const Place &b, const Place &place, double reach, double *along) {
    const bmr_vec2 edge = bmr_sub(Vector(b), Vector(a)), way = bmr_sub(Vector(place), Vector(a));
    const double square = bmr_dot(edge, edge);
    *along = bmr_dot(way, edge) / square;
    if (place == a || place == b || !(*along > 0.0 && *along < 1.0))
        return false;
    if (reach == 0.0)
        return Orientation(a, b, place) == 0;
    const double turn = bmr_cross(edge, way);
    return turn * turn <= reach * reach * square;
}

/// The places that points (in steps of the grid) go to: each point to the first one before it that went to
/// its own place and is not farther than `reach`, else to its own place, rounded. O(n log n).
std::vector<Place> Gather(const std::vector<bmr_vec2> &points, double reach) {
    std::map<std::pair<int64_t, int64_t>, std::vector<uint32_t>> firsts; // by cell of the size of `reach`
    std::vector<Place> places(points.size());
    for (uint32_t i = 0; i < points.size(); ++i) {
        const bmr_vec2 point = points[i];
        const auto column = static_cast<int64_t>(std::floor(point.x / reach)),
                   row = static_cast<int64_t>(std::floor(point.y / reach));
        uint32_t first = i;
        for (int64_t x = column - 1; x <= column + 1; ++x)
            for (int64_t y = row - 1; y <= row + 1; ++y) {
                const auto near = firsts.find({x, y});
                if (near == firsts.end())
                    continue;
                for (const uint32_t other : near->second) {
                    const bmr_vec2 way = bmr_sub(points[other], point);
                    if (other < first && bmr_dot(way, way) <= reach * reach)
                        first = other;
                }
            }
        if (first == i) {
            places[i] = Place(std::llround(point.x), std::llround(point.y));
            firsts[{column, row}].push_back(i);
        } else {
            places[i] = places[first];
        }
    }
    return places;
}

/// Bends each edge to the places of all paths that are not farther than `reach` from it, between its ends;
/// with reach 0 to those that lie exactly on it. So paths that meet in a place have it in common. Each edge
/// looks at the places of its height. False where there would be more than kMostPlaces, as of edges that lie
/// on each other by the thousand; then paths are bent in part.
bool Bend(Paths *paths, double reach) {
    const std::vector<Place> places = PlacesOf(*paths);
    size_t left = kMostPlaces;
    std::vector<Stop> stops;
    for (Path &path : *paths) {
        Path bent;
        for (size_t i = 0; i < path.size(); ++i) {
            const Place &a = path[i], &b = path[i + 1 < path.size() ? i + 1 : 0];
            bent.push_back(a);
            stops.clear();
            const double bottom = static_cast<double>(std::min(a.Y, b.Y)) - reach,
                         top = static_cast<double>(std::max(a.Y, b.Y)) + reach;
            auto place = std::partition_point(places.begin(), places.end(), [bottom](const Place &p) {
                return static_cast<double>(p.Y) < bottom;
            });
            for (; place != places.end() && static_cast<double>(place->Y) <= top; ++place) {
                double along;
                if (IsBeside(a, b, *place, reach, &along))
                    stops.push_back({along, *place});
            }
            std::sort(stops.begin(), stops.end(), [](const Stop &s, const Stop &t) {
                return s.along != t.along ? s.along < t.along : Before(s.place, t.place);
            });
            for (const Stop &stop : stops)
                bent.push_back(stop.place);
            if (bent.size() > left)
                return false;
        }
        left -= bent.size();
        path.swap(bent);
    }
    return true;
}

// The clipper finds where edges cross; its rings may still run along each other, and it may hang a hole on
// the wrong ring. So rings are made here, of its edges alone. Edges that lie on each other cancel in pairs.
// The edges at the right of a corner, counted, say which of the sectors above it are solid. A walk that keeps
// the solid on its left then finds the rings, and turns off into the nearest edge at each corner, so that
// solids that touch stay apart.

constexpr uint32_t kNone = UINT32_MAX;

struct Edge {
    Place low, high; ///< in the order of Before
};

bool operator==(const Edge &a, const Edge &b) {
    return a.low == b.low && a.high == b.high;
}

bool EdgeBefore(const Edge &a, const Edge &b) {
    return a.low == b.low ? Before(a.high, b.high) : Before(a.low, b.low);
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
    return Orientation(e.low, e.high, f.low) * Orientation(e.low, e.high, f.high) < 0 &&
           Orientation(f.low, f.high, e.low) * Orientation(f.low, f.high, e.high) < 0;
}

/// Of edges in order: each looks at those that begin before it and end above its low end.
bool AnyCross(const std::vector<Edge> &edges) {
    std::vector<Edge> active;
    for (const Edge &edge : edges) {
        const auto [left, right] = std::minmax(edge.low.X, edge.high.X);
        size_t kept = 0;
        for (const Edge &other : active) {
            if (other.high.Y <= edge.low.Y)
                continue;
            if (std::min(other.low.X, other.high.X) < right && std::max(other.low.X, other.high.X) > left &&
                Cross(edge, other))
                return true;
            active[kept++] = other;
        }
        active.resize(kept);
        active.push_back(edge);
    }
    return false;
}

/// Is edge e at the left of edge f, where a horizontal line meets both? They do not cross, and are not the
/// same.
bool IsLeftOf(const Edge &e, const Edge &f) {
    if (Before(e.low, f.low))
        return !IsLeftOf(f, e);
    const int side = Orientation(f.low, f.high, e.low);
    return (side != 0 ? side : Orientation(f.low, f.high, e.high)) > 0;
}

/// Half 2e of edge e goes from its low end to its high end, half 2e + 1 back.
class Arrangement {
public:
    explicit Arrangement(std::vector<Edge> edges)
        : m_edges(std::move(edges)), m_ring(2 * m_edges.size(), kNone) {
        MakeCorners();
    }

    std::vector<Solid> Find() {
        for (uint32_t corner = 0; corner + 1 < m_first.size(); ++corner)
            FindRings(m_first[corner], m_first[corner + 1]);
        return std::move(m_solids);
    }

private:
    const Place &From(uint32_t half) const {
        const Edge &edge = m_edges[half / 2];
        return half % 2 == 0 ? edge.low : edge.high;
    }
    const Place &To(uint32_t half) const { return From(half ^ 1); }

    /// By angle from straight right, counter-clockwise.
    bool TurnsBefore(uint32_t a, uint32_t b) const {
        const bool downA = a % 2 == 1, downB = b % 2 == 1;
        return downA != downB ? downB : Orientation(From(a), To(a), To(b)) > 0;
    }

    /// Halves by the corner that they begin at, corners from below, halves around each.
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

    /// From here on m_active has the edges that begin at the height of a place or below it, and end above
    /// that. To be called for places in the order of Before.
    void GoUpTo(const Place &place) {
        while (m_met < m_edges.size() && m_edges[m_met].low.Y <= place.Y)
            m_active.push_back(m_edges[m_met++]);
        const auto ends = [&place](const Edge &edge) { return edge.high.Y <= place.Y; };
        m_active.erase(std::remove_if(m_active.begin(), m_active.end(), ends), m_active.end());
    }
    static bool IsAtRight(const Edge &edge, const Place &place) {
        return std::max(edge.low.X, edge.high.X) > place.X && Orientation(edge.low, edge.high, place) > 0;
    }
    /// Of the edges at the right of a place the nearest; there is one.
    uint32_t FindNearest(const Place &place) const {
        const Edge *nearest = nullptr;
        for (const Edge &edge : m_active)
            if (IsAtRight(edge, place) && (nearest == nullptr || IsLeftOf(edge, *nearest)))
                nearest = &edge;
        return static_cast<uint32_t>(std::lower_bound(m_edges.begin(), m_edges.end(), *nearest, EdgeBefore) -
                                     m_edges.begin());
    }

    /// The rings whose lowest corner is this one: the corner of m_out[first] to m_out[end - 1].
    void FindRings(uint32_t first, uint32_t end) {
        const Place &place = From(m_out[first]);
        GoUpTo(place);
        const auto right = static_cast<uint32_t>(std::count_if(
            m_active.begin(), m_active.end(), [&](const Edge &edge) { return IsAtRight(edge, place); }));
        for (uint32_t i = end;
             i-- > first;) { // from the left: the ring of a hole may come back to the corner
            const uint32_t half = m_out[i];
            const bool isSolid = (right + i - first) % 2 == 0; // on the left of a half that goes up
            if (half % 2 != 0 || !isSolid || m_ring[half] != kNone)
                continue;
            if (i + 1 ==
                end) { // solid goes on below the corner: this is a hole in what the nearest edge begins
                AddRing(half, m_ring[2 * FindNearest(place)]);
            } else {
                m_solids.emplace_back();
                AddRing(half, static_cast<uint32_t>(m_solids.size() - 1));
            }
        }
    }

    /// The half that follows this one on the boundary of the solid on its left: the first one clockwise.
    uint32_t Next(uint32_t half) const {
        const uint32_t at = m_place[half ^ 1], corner = m_corner[at];
        return m_out[at > m_first[corner] ? at - 1 : m_first[corner + 1] - 1];
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
    std::vector<uint32_t> m_ring; ///< of each half with a solid on its left: which, once its ring is found
    std::vector<uint32_t> m_out, m_place; ///< halves by corner, and where each is there
    std::vector<uint32_t> m_first;        ///< of each corner, in m_out; and the end
    std::vector<uint32_t> m_corner;       ///< of each of m_out
    uint32_t m_met = 0;
    std::vector<Edge> m_active;
    std::vector<Solid> m_solids;
};

/// Writes what an odd number of paths goes around, as solids. No place of a path may lie inside of an edge
/// (Bend). No two edges of what results have more than a corner in common, and rings do not cross in corners
/// that they share. False, and nothing written, where two edges cross.
bool Arrange(const Paths &paths, std::vector<Solid> *solids) {
    std::vector<Edge> edges = OddEdges(paths);
    if (AnyCross(edges))
        return false;
    *solids = Arrangement(std::move(edges)).Find();
    return true;
}

// Outlines in, outlines out.

struct Grid {
    int exponent; ///< a step is 2 to this
    double reach; ///< in steps
    /// By a quarter: all goes from line to line upwards, and a line across the shorter way meets fewer edges.
    bool turned;
};

bmr_error MakeGrid(double snap, Grid *grid) {
    if (!std::isfinite(snap))
        return BMR_ERROR_NOT_FINITE;
    if (!(snap > 0.0))
        return BMR_ERROR_NEGATIVE;
    if (snap < 64.0 * DBL_MIN) // a step has all bits of a double
        return BMR_ERROR_OUT_OF_RANGE;
    std::frexp(snap, &grid->exponent);
    grid->exponent -= 5;
    grid->reach = kReach * std::ldexp(snap, -grid->exponent);
    return BMR_OK;
}

/// The points of all outlines, in steps of the grid.
bmr_error ReadPoints(const Outline *outlines, size_t count, Grid *grid, std::vector<bmr_vec2> *points) {
    for (size_t i = 0; i < count; ++i) {
        const Outline &outline = outlines[i];
        if (outline.points.size() > kMostPoints - points->size())
            return BMR_ERROR_TOO_MANY_POINTS;
        if (std::accumulate(outline.counts.begin(), outline.counts.end(), uint64_t{0}) !=
            outline.points.size())
            return BMR_ERROR_OUT_OF_RANGE;
        for (const bmr_vec2 &p : outline.points) {
            if (!std::isfinite(p.x) || !std::isfinite(p.y))
                return BMR_ERROR_NOT_FINITE;
            const bmr_vec2 steps = {std::ldexp(p.x, -grid->exponent), std::ldexp(p.y, -grid->exponent)};
            if (std::fabs(steps.x) > kMostSteps || std::fabs(steps.y) > kMostSteps)
                return BMR_ERROR_OUT_OF_RANGE;
            points->push_back(steps);
        }
    }
    if (points->empty())
        return BMR_ERROR_NO_POINTS;
    bmr_vec2 low = points->front(), high = low;
    for (const bmr_vec2 &p : *points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    grid->turned = high.x - low.x > high.y - low.y;
    if (grid->turned)
        for (bmr_vec2 &p : *points)
            p = {-p.y, p.x};
    return BMR_OK;
}

Outline OutlineOf(const Solid &solid, const Grid &grid) {
    Outline outline;
    for (const Path &ring : solid) {
        outline.counts.push_back(static_cast<uint32_t>(ring.size()));
        for (const Place &place : ring) {
            const Place back = grid.turned ? Place(place.Y, -place.X) : place;
            outline.points.push_back({std::ldexp(static_cast<double>(back.X), grid.exponent),
                                      std::ldexp(static_cast<double>(back.Y), grid.exponent)});
        }
    }
    return outline;
}

/// The places that the paths go around by the rule, as solids.
bmr_error Clip(Paths paths, ClipperLib::PolyFillType rule, std::vector<Solid> *solids) {
    for (int i = 0; i < kMostClips; ++i) {
        ClipperLib::Clipper clipper;
        if (!clipper.AddPaths(paths, ClipperLib::ptSubject, true)) { // none goes around anything
            solids->clear();
            return BMR_OK;
        }
        if (!clipper.Execute(ClipperLib::ctUnion, paths, rule, rule))
            return BMR_ERROR_CROSSING_EDGES;
        if (!Bend(&paths, kSquare) || !Bend(&paths, 0.0))
            return BMR_ERROR_TOO_MANY_POINTS;
        if (Arrange(paths, solids))
            return BMR_OK;
        rule = ClipperLib::pftEvenOdd;
    }
    return BMR_ERROR_CROSSING_EDGES;
}

bmr_error Repair(const Outline *outlines, size_t count, FillRule rule, double snap,
                 std::vector<Outline> *repaired) {
    Grid grid;
    bmr_error error = MakeGrid(snap, &grid);
    std::vector<bmr_vec2> points;
    if (error == BMR_OK)
        error = ReadPoints(outlines, count, &grid, &points);
    if (error != BMR_OK)
        return error;
    const std::vector<Place> places = Gather(points, grid.reach);
    Paths paths;
    auto place = places.begin();
    for (size_t i = 0; i < count; ++i)
        for (const uint32_t size : outlines[i].counts) {
            paths.emplace_back(place, place + size);
            place += size;
        }
    if (!Bend(&paths, grid.reach))
        return BMR_ERROR_TOO_MANY_POINTS;

    const auto fill = rule == FillRule::EvenOdd ? ClipperLib::pftEvenOdd : ClipperLib::pftNonZero;
    std::vector<Solid> solids;
    Paths all; // the rings of each outline, which run around its solid once
    auto ring = paths.begin();
    for (size_t i = 0; i < count && error == BMR_OK; ++i) {
        const auto end = ring + static_cast<std::ptrdiff_t>(outlines[i].counts.size());
        error = Clip(Paths(ring, end), fill, &solids);
        for (const Solid &solid : solids)
            all.insert(all.end(), solid.begin(), solid.end());
        ring = end;
    }
    if (error == BMR_OK && count > 1)
        error = Clip(std::move(all), ClipperLib::pftPositive, &solids);
    if (error != BMR_OK)
        return error;
    if (solids.empty())
        return BMR_ERROR_TOO_FEW_POINTS;
    std::vector<Outline> made;
    for (const Solid &solid : solids) {
        made.push_back(OutlineOf(solid, grid));
        const bmr_rings rings = made.back().GetRings();
        error = bmr_outline_check(&rings, nullptr, nullptr);
        if (error != BMR_OK)
            return error;
    }
    repaired->swap(made);
    return BMR_OK;
}

} // namespace

bmr_error MergeOutlines(const Outline *outlines, std::size_t count, FillRule rule, double snap,
                        std::vector<Outline> *merged) {
    if (merged == nullptr || (outlines == nullptr && count > 0))
        return BMR_ERROR_NULL_ARGUMENT;
    try {
        return Repair(outlines, count, rule, snap, merged);
    } catch (const std::bad_alloc &) {
        return BMR_ERROR_NO_MEMORY;
    } catch (const std::length_error &) {
        return BMR_ERROR_NO_MEMORY;
    } catch (const std::exception &) { // the clipper's
        return BMR_ERROR_CROSSING_EDGES;
    }
}

bmr_error RepairOutline(const Outline &rings, FillRule rule, double snap, std::vector<Outline> *repaired) {
    return MergeOutlines(&rings, 1, rule, snap, repaired);
}

} // namespace bmr
