// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_CLIP_GRID_H
#define BOOMERANG_CLIP_GRID_H

#include <tuple>

#include <polyclipping/clipper.hpp>

#include "geometry/predicates.h"

namespace bmr::repair {

/// Places of the grid, in its steps; the clipper's own types. Paths are closed.
using Place = ClipperLib::IntPoint;
using Path = ClipperLib::Path;
using Paths = ClipperLib::Paths;

/// Up to here the clipper's products fit 64 bits.
constexpr double kMostSteps = static_cast<double>(ClipperLib::loRange);

/// From left to right; above each other from below.
inline bool Before(const Place &a, const Place &b) {
    return std::tie(a.X, a.Y) < std::tie(b.X, b.Y);
}

inline bmr_vec2 Vector(const Place &place) {
    return {static_cast<double>(place.X), static_cast<double>(place.Y)};
}

/// Exact.
inline int Orientation(const Place &a, const Place &b, const Place &c) {
    return bmr_orientation(Vector(a), Vector(b), Vector(c));
}

} // namespace bmr::repair

#endif
