// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_BENCH_RIVALS_H
#define BOOMERANG_BENCH_RIVALS_H

#include <cstdint>

#include "boomerang/polygon.h"

/// What others do for "are these two still apart?", written here in the same style and precision as our own,
/// so that the comparison is between methods.
namespace rival {

/// One remembered edge, re-tested first against the other polygon's support vertex, which is climbed to from
/// the last one (ReactPhysics3D keeps the last separating axis like this). When it fails, every edge of both
/// polygons is tried.
class CachedEdge {
public:
    bool Apart(const bmr_polygon &a, const bmr_polygon &b, const bmr_pose &bInA);

private:
    bool ofB_ = false, known_ = false;
    bmr_vec2 normal_ = {0, 0}; // of the remembered edge, in its owner's frame
    double offset_ = 0;
    uint32_t vertex_ = 0; // of the other polygon: its last support
};

/// GJK distance with hill-climbing supports, started from the last simplex's vertices.
class WarmGjk {
public:
    double Distance(const bmr_polygon &a, const bmr_polygon &b, const bmr_pose &bInA);

private:
    uint32_t a_ = 0, b_ = 0;
};

} // namespace rival

#endif
