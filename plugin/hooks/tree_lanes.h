// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_HOOKS_TREE_LANES_H
#define BOOMERANG_HOOKS_TREE_LANES_H

#include "hooks/tree_descent.h"
#include "start/compiler.h"

/// @file
/// What b2DynamicTree::InsertLeaf computes of boxes, with two boxes in registers at once. Operations and
/// operands are Box2D's, also where a number is none: b2Min(a, b) is `a < b ? a : b`, and so are the
/// processor's lanes.

namespace bmr::hooks {

/// Perimeters of two boxes, and those of the boxes around each of the two and a leaf's box.
struct Perimeters {
    float first, second, aroundFirst, aroundSecond;
};

#if defined(__SSE2__)

inline void StoreBox(b2AABB *aabb, Box box) {
    _mm_storeu_ps(&aabb->lowerBound.x, box);
}

/// A leaf's box, held against others.
class LeafBox {
public:
    explicit LeafBox(Box box) : m_lower(_mm_movelh_ps(box, box)), m_upper(_mm_movehl_ps(box, box)) {}

    /// Of the boxes that b2AABB::Combine(leaf, box) makes, by b2AABB::GetPerimeter.
    Perimeters With(Box first, Box second) const {
        const __m128 lower = _mm_movelh_ps(first, second), upper = _mm_movehl_ps(second, first);
        const __m128 sizes = _mm_sub_ps(upper, lower);
        const __m128 around = _mm_sub_ps(_mm_max_ps(m_upper, upper), _mm_min_ps(m_lower, lower));
        const __m128 half = _mm_add_ps(_mm_shuffle_ps(sizes, around, _MM_SHUFFLE(2, 0, 2, 0)),
                                       _mm_shuffle_ps(sizes, around, _MM_SHUFFLE(3, 1, 3, 1)));
        float perimeters[4];
        _mm_storeu_ps(perimeters, _mm_add_ps(half, half));
        return {perimeters[0], perimeters[1], perimeters[2], perimeters[3]};
    }

private:
    __m128 m_lower, m_upper; ///< x, y, x, y
};

#else

inline void StoreBox(b2AABB *aabb, const Box &box) {
    *aabb = box;
}

class LeafBox {
public:
    explicit LeafBox(const Box &box) : m_box(box) {}

    Perimeters With(const Box &first, const Box &second) const {
        b2AABB aroundFirst, aroundSecond;
        aroundFirst.Combine(m_box, first);
        aroundSecond.Combine(m_box, second);
        return {first.GetPerimeter(), second.GetPerimeter(), aroundFirst.GetPerimeter(),
                aroundSecond.GetPerimeter()};
    }

private:
    Box m_box;
};

#endif

/// Asks for a node's memory ahead of its use. There need be no such node: then for the first.
inline void PrefetchNode(const b2TreeNode *nodes, int32 id) {
    BMR_PREFETCH(nodes + b2Max(id, 0));
}

} // namespace bmr::hooks

#endif
