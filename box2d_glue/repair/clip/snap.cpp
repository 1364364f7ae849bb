// SPDX-License-Identifier: MIT
#include "clip/clip.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace bmr::repair {

namespace {

/// All places of some paths, in rows; in each row from left to right.
class Rows {
public:
    explicit Rows(const Paths &paths) {
        std::vector<Place> places;
        for (const Path &path : paths)
            places.insert(places.end(), path.begin(), path.end());
        if (places.empty())
            return;
        std::sort(places.begin(), places.end(), Before);
        places.erase(std::unique(places.begin(), places.end()), places.end());
        const auto ends = std::minmax_element(places.begin(), places.end(),
                                              [](const Place &a, const Place &b) { return a.Y < b.Y; });
        m_bottom = static_cast<double>(ends.first->Y);
        const double height = static_cast<double>(ends.second->Y) - m_bottom + 1.0;
        m_rows.resize(static_cast<size_t>(std::sqrt(static_cast<double>(places.size()))) + 1);
        m_rowHeight = height / static_cast<double>(m_rows.size());
        for (const Place &place : places)
            m_rows[RowOf(static_cast<double>(place.Y))].push_back(place);
    }

    /// Calls function(place) with every place within `reach` of the segment, and others.
    template <typename Function>
    void ForEachNear(const Place &a, const Place &b, double reach, Function function) const {
        const bmr_vec2 low = Vector(a.Y < b.Y ? a : b), high = Vector(a.Y < b.Y ? b : a);
        const size_t last = RowOf(high.y + reach);
        for (size_t row = RowOf(low.y - reach); row <= last; ++row) {
            // The part of the segment beside the row, from left to right; a step more for rounding.
            const double begin = m_bottom + m_rowHeight * static_cast<double>(row) - reach - 1.0;
            const double x0 = AtHeight(low, high, begin),
                         x1 = AtHeight(low, high, begin + m_rowHeight + 2.0 * (reach + 1.0));
            const double left = std::min(x0, x1) - reach - 1.0, right = std::max(x0, x1) + reach + 1.0;
            const std::vector<Place> &places = m_rows[row];
            auto place = std::partition_point(places.begin(), places.end(), [left](const Place &p) {
                return static_cast<double>(p.X) < left;
            });
            for (; place != places.end() && static_cast<double>(place->X) <= right; ++place)
                function(*place);
        }
    }

private:
    size_t RowOf(double y) const {
        const double row = std::floor((y - m_bottom) / m_rowHeight);
        return static_cast<size_t>(std::clamp(row, 0.0, static_cast<double>(m_rows.size() - 1)));
    }
    static double AtHeight(const bmr_vec2 &low, const bmr_vec2 &high, double y) {
        if (y <= low.y)
            return low.x;
        return y >= high.y ? high.x : low.x + (high.x - low.x) * ((y - low.y) / (high.y - low.y));
    }

    std::vector<std::vector<Place>> m_rows;
    double m_bottom = 0.0, m_rowHeight = 1.0;
};

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

} // namespace

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

bool Bend(Paths *paths, double reach) {
    const Rows rows(*paths);
    size_t left = kMostPlaces;
    std::vector<Stop> stops;
    for (Path &path : *paths) {
        Path bent;
        for (size_t i = 0; i < path.size(); ++i) {
            const Place &a = path[i], &b = path[i + 1 < path.size() ? i + 1 : 0];
            bent.push_back(a);
            stops.clear();
            rows.ForEachNear(a, b, reach, [&](const Place &place) {
                double along;
                if (IsBeside(a, b, place, reach, &along))
                    stops.push_back({along, place});
            });
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

} // namespace bmr::repair
