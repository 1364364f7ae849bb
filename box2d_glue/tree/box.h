// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TREE_BOX_H
#define BOOMERANG_TREE_BOX_H

#include <box2d/b2_dynamic_tree.h>

#include "base/compiler.h"
#include "exact32/float4.h"

/// @file
/// The boxes of a b2DynamicTree's nodes, in lanes. Operations and operands are Box2D's, also where a number
/// is none: b2Min(a, b) is `a < b ? a : b`, and so are lanes.

namespace bmr::tree {

/// Perimeters of two boxes, and those of the boxes around each of the two and a leaf's box.
struct Perimeters {
    float first, second, aroundFirst, aroundSecond;
};

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

inline void StoreBox(b2AABB *aabb, Box box) {
    store4(&aabb->lowerBound.x, box);
}

/// A leaf's box, held against others.
class LeafBox {
public:
    explicit LeafBox(Box box) : m_lower(lows4(box, box)), m_upper(highs4(box, box)) {}

    /// Of the boxes that b2AABB::Combine(leaf, box) makes, by b2AABB::GetPerimeter.
    Perimeters With(Box first, Box second) const {
        const float4 lower = lows4(first, second), upper = highs4(first, second);
        const float4 sizes = sub4(upper, lower);
        const float4 around = sub4(max4(m_upper, upper), min4(m_lower, lower));
        const float4 half = add4(evens4(sizes, around), odds4(sizes, around));
        float perimeters[4];
        store4(perimeters, add4(half, half));
        return {perimeters[0], perimeters[1], perimeters[2], perimeters[3]};
    }

private:
    float4 m_lower, m_upper; ///< x, y, x, y
};

/// Asks for a node's memory ahead of its use. There need be no such node: then for the first.
inline void PrefetchNode(const b2TreeNode *nodes, int32 id) {
    BMR_PREFETCH(nodes + b2Max(id, 0));
}

} // namespace bmr::tree

#endif