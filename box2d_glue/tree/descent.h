// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TREE_DESCENT_H
#define BOOMERANG_TREE_DESCENT_H

#include <box2d/b2_dynamic_tree.h>

#include "tree/box.h"

/// @file
/// A descent of Box2D's tree of boxes with the boxes in registers, in the order of b2DynamicTree::Query.

namespace bmr::tree {

/// The private members of a tree: b2DynamicTree::Query is instantiated for this, and hands them out.
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

} // namespace bmr::tree

template <> inline void b2DynamicTree::Query(bmr::tree::TreeNodes *out, const b2AABB &) const {
    *out = {m_nodes, m_root};
}

#endif
