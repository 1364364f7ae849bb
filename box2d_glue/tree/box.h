// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TREE_BOX_H
#define BOOMERANG_TREE_BOX_H

#include <box2d/b2_dynamic_tree.h>

#include "exact32/float4.h"

/// @file
/// The boxes of a b2DynamicTree's nodes, in lanes. Operations and operands are Box2D's, also where a number
/// is none: b2Min(a, b) is `a < b ? a : b`, and so are lanes.

namespace bmr::tree {

/// Lower x, lower y, upper x, upper y.
using Box = float4;

inline Box BoxOf(const b2AABB &aabb) {
    return load4(&aabb.lowerBound.x);
}

/// b2TestOverlap, by the same differences.
inline bool Overlap(Box a, Box b) {
    const float4 lower = lows4(b, a), upper = highs4(a, b); // of b and a; of a and b
    return !any4(less4(zero4(), sub4(lower, upper)));
}

inline Box Around(Box a, Box b) {
    return low_high4(min4(a, b), max4(a, b));
}

inline bool HasNumbers(Box a) {
    return !any4(unordered4(a, a));
}

} // namespace bmr::tree

#endif