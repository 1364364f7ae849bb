// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_CLIP_GRID_H
#define BOOMERANG_CLIP_GRID_H

#include <tuple>

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

} // namespace bmr::repair

#endif
