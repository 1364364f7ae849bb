// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_CLIP_ARRANGE_H
#define BOOMERANG_CLIP_ARRANGE_H

#include <vector>

#include "clip/grid.h"

namespace bmr::repair {

/// An outer ring, counter-clockwise, and the holes of its solid, clockwise.
using Solid = Paths;

/// Writes what an odd number of paths goes around, as solids. No place of a path may lie inside of an edge
/// (Bend). No two edges of what results have more than a corner in common, and rings do not cross in corners
/// that they share. False, and nothing written, where two edges cross.
bool Arrange(const Paths &paths, std::vector<Solid> *solids);

} // namespace bmr::repair

#endif
