// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_HOOKS_TREE_DESCENT_H
#define BOOMERANG_HOOKS_TREE_DESCENT_H

#include <box2d/b2_dynamic_tree.h>

#if defined(__SSE2__)
#    include <emmintrin.h>
#endif

/// @file
/// A descent of Box2D's tree of boxes with the boxes in registers, in the order of b2DynamicTree::Query.

namespace bmr::hooks {

#if defined(__SSE2__)

/// Lower x, lower y, upper x, upper y.
using Box = __m128;

inline Box BoxOf(const b2AABB &aabb) {
    return _mm_loadu_ps(&aabb.lowerBound.x);
}

/// b2TestOverlap, by the same differences.
inline bool Overlap(Box a, Box b) {
    const __m128 lower = _mm_movelh_ps(b, a), upper = _mm_movehl_ps(b, a); // of b and a; of a and b
    return _mm_movemask_ps(_mm_cmpgt_ps(_mm_sub_ps(lower, upper), _mm_setzero_ps())) == 0;
}

inline Box Around(Box a, Box b) {
    return _mm_shuffle_ps(_mm_min_ps(a, b), _mm_max_ps(a, b), _MM_SHUFFLE(3, 2, 1, 0));
}

inline bool HasNumbers(Box a) {
    return _mm_movemask_ps(_mm_cmpunord_ps(a, a)) == 0;
}

#else

using Box = b2AABB;

inline Box BoxOf(const b2AABB &aabb) {
    return aabb;
}

inline bool Overlap(const Box &a, const Box &b) {
    return b2TestOverlap(a, b);
}

inline Box Around(Box a, const Box &b) {
    a.Combine(b);
    return a;
}

inline bool HasNumbers(const Box &a) {
    return a.lowerBound.x == a.lowerBound.x && a.lowerBound.y == a.lowerBound.y &&
           a.upperBound.x == a.upperBound.x && a.upperBound.y == a.upperBound.y;
}

#endif

/// What a tree shows its members alone: b2DynamicTree::Query is instantiated for this, and hands it out.
struct TreeNodes {
    const b2TreeNode *nodes;
    int32 root;
};

/// Calls `visitor->Visit(box)` for each node whose box, and whose ancestors' boxes, overlap `box`, and
/// `visitor->Take(id, node)` for the leaves among them, until one returns false; then returns false.
template <typename Visitor> bool Descend(const TreeNodes &tree, Box box, Visitor *visitor) {
    b2GrowableStack<int32, 256> stack;
    const auto overlaps = [&tree, &box](int32 id) { return Overlap(box, BoxOf(tree.nodes[id].aabb)); };
    if (tree.root != b2_nullNode && overlaps(tree.root))
        stack.Push(tree.root);
    while (stack.GetCount() > 0) {
        // Down one branch, which is the second child's where there are two; the others wait.
        int32 id = stack.Pop();
        while (id != b2_nullNode) {
            const b2TreeNode &node = tree.nodes[id];
            if (!visitor->Visit(BoxOf(node.aabb)))
                return false;
            if (node.IsLeaf()) {
                if (!visitor->Take(id, node))
                    return false;
                break;
            }
            const bool first = overlaps(node.child1), second = overlaps(node.child2);
            if (first && second)
                stack.Push(node.child1);
            id = second ? node.child2 : first ? node.child1 : b2_nullNode;
        }
    }
    return true;
}

} // namespace bmr::hooks

template <> inline void b2DynamicTree::Query(bmr::hooks::TreeNodes *out, const b2AABB &) const {
    *out = {m_nodes, m_root};
}

#endif
