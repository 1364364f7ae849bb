// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_CLIP_SNAP_H
#define BOOMERANG_CLIP_SNAP_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "clip/grid.h"

namespace bmr::repair {

/// The places that points (in steps of the grid) go to: each point to the first one before it that went to
/// its own place and is not farther than `reach`, else to its own place, rounded. O(n) expected.
std::vector<Place> Gather(const std::vector<bmr_vec2> &points, double reach);

/// Less than a gigabyte in the clipper.
constexpr size_t kMostPlaces = size_t{1} << 22;

/// Bends each edge to the places of all paths that are not farther than `reach` from it, between its ends;
/// with reach 0 to those that lie exactly on it. So paths that meet in a place have it in common. Each edge
/// looks at the places in the rows of the grid's box that it passes. False where there would be more than
/// kMostPlaces, as of edges that lie on each other by the thousand; then paths are bent in part.
bool Bend(Paths *paths, double reach);

} // namespace bmr::repair

#endif
