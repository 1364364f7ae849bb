// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_HOOKS_TREE_DESCENT_H
#define BOOMERANG_HOOKS_TREE_DESCENT_H

#include <box2d/b2_dynamic_tree.h>

#include "exact32/float4.h"

/// @file
/// A descent of Box2D's tree of boxes with the boxes in registers, in the order of b2DynamicTree::Query.

namespace bmr::hooks {

#if BMR_FLOAT4_NATIVE

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
