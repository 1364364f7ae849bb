// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_CLIP_CLIP_H
#define BOOMERANG_CLIP_CLIP_H

#include <cstddef>
#include <tuple>
#include <vector>

#include <polyclipping/clipper.hpp>

#include "boomerang/vector.h"

namespace bmr::repair {

/// Places of the grid, in its steps; the clipper's own types. Paths are closed.
using Place = ClipperLib::IntPoint;
using Path = ClipperLib::Path;
using Paths = ClipperLib::Paths;

/// Up to here products of differences fit 64 bits, the clipper's and ours.
constexpr double kMostSteps = static_cast<double>(ClipperLib::loRange);

/// From left to right; above each other from below.
inline bool Before(const Place &a, const Place &b) {
    return std::tie(a.X, a.Y) < std::tie(b.X, b.Y);
}

inline bmr_vec2 Vector(const Place &place) {
    return {static_cast<double>(place.X), static_cast<double>(place.Y)};
}

/// 1 where a, b, c turn left, -1 where they turn right, 0 on a line. Exact: a difference has 31 bits.
inline int Orientation(const Place &a, const Place &b, const Place &c) {
    const auto left = (b.X - a.X) * (c.Y - a.Y), right = (b.Y - a.Y) * (c.X - a.X);
    return (left > right) - (left < right);
}

/// The places that points (in steps of the grid) go to: each point to the first one before it that went to
/// its own place and is not farther than `reach`, else to its own place, rounded. O(n log n).
std::vector<Place> Gather(const std::vector<bmr_vec2> &points, double reach);

/// Less than a gigabyte in the clipper.
constexpr size_t kMostPlaces = size_t{1} << 22;

/// Bends each edge to the places of all paths that are not farther than `reach` from it, between its ends;
/// with reach 0 to those that lie exactly on it. So paths that meet in a place have it in common. Each edge
/// looks at the places in the rows of the grid's box that it passes. False where there would be more than
/// kMostPlaces, as of edges that lie on each other by the thousand; then paths are bent in part.
bool Bend(Paths *paths, double reach);

/// An outer ring, counter-clockwise, and the holes of its solid, clockwise.
using Solid = Paths;

/// Writes what an odd number of paths goes around, as solids. No place of a path may lie inside of an edge
/// (Bend). No two edges of what results have more than a corner in common, and rings do not cross in corners
/// that they share. False, and nothing written, where two edges cross.
bool Arrange(const Paths &paths, std::vector<Solid> *solids);

} // namespace bmr::repair

#endif
