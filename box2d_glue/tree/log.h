// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TREE_LOG_H
#define BOOMERANG_TREE_LOG_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "tree/edit.h"

/// @file
/// What a TreeEdit does to a tree, to be undone, done again by Box2D, and compared: Mode::Verify. A tree is
/// too large to be copied for each leaf that moves.

namespace bmr::tree {

/// All fields, to the bit.
inline bool SameNode(const b2TreeNode &a, const b2TreeNode &b) {
    uint32_t boxA[4], boxB[4];
    std::memcpy(boxA, &a.aabb, sizeof boxA);
    std::memcpy(boxB, &b.aabb, sizeof boxB);
    return std::equal(boxA, boxA + 4, boxB) && a.userData == b.userData && a.parent == b.parent &&
           a.child1 == b.child1 && a.child2 == b.child2 && a.height == b.height && a.moved == b.moved;
}

class TreeLog {
public:
    explicit TreeLog(const b2DynamicTree &tree) : m_tree(tree), m_before(MembersOf(tree)) {}

    /// Called by TreeEdit before it writes a node. May throw std::bad_alloc; then call Undo() all the same.
    void Before(int32 id, const b2TreeNode &node) { m_written.push_back({id, node}); }

    /// Keeps what the edit made of the tree, and of the nodes around those that it has written: as they are,
    /// for it has not written them. Throws std::bad_alloc.
    void Keep() {
        m_after = Scalars(MembersOf(m_tree));
        const size_t written = m_written.size();
        for (size_t i = 0; i < written; ++i)
            KeepNode(m_written[i].id);
        for (size_t i = 0; i < written; ++i) {
            const b2TreeNode before = m_written[i].node;
            KeepAround(before);
            KeepAround(m_before.nodes[m_written[i].id]);
        }
    }

    /// Writes back all that the edit changed. The log keeps its entries.
    void Undo() {
        for (size_t i = m_written.size(); i-- > 0;)
            m_before.nodes[m_written[i].id] = m_written[i].node;
        *m_before.root = m_start.root;
        *m_before.nodeCount = m_start.nodeCount;
        *m_before.freeList = m_start.freeList;
        *m_before.insertionCount = m_start.insertionCount;
    }

    /// Compares what was kept with a tree on which Box2D did the same. Returns a node that differs, the null
    /// node where the tree's own members differ, and less than that where all is the same.
    int32 Difference() const {
        const TreeMembers now = MembersOf(m_tree);
        if (now.nodes != m_before.nodes || now.capacity != m_before.capacity || !(Scalars(now) == m_after))
            return b2_nullNode;
        const auto other = std::find_if(m_kept.begin(), m_kept.end(), [&now](const Written &kept) {
            return !SameNode(now.nodes[kept.id], kept.node);
        });
        return other == m_kept.end() ? kNone : other->id;
    }
    static constexpr int32 kNone = b2_nullNode - 1;

private:
    struct Written {
        int32 id;
        b2TreeNode node;
    };

    struct Scalars {
        int32 root = 0, nodeCount = 0, freeList = 0, insertionCount = 0;

        Scalars() = default;
        explicit Scalars(const TreeMembers &tree)
            : root(*tree.root), nodeCount(*tree.nodeCount), freeList(*tree.freeList),
              insertionCount(*tree.insertionCount) {}
        bool operator==(const Scalars &other) const {
            return root == other.root && nodeCount == other.nodeCount && freeList == other.freeList &&
                   insertionCount == other.insertionCount;
        }
    };

    void KeepNode(int32 id) {
        if (id != b2_nullNode)
            m_kept.push_back({id, m_before.nodes[id]});
    }

    /// All that Box2D can write because of a node: its parent, its children and theirs.
    /// (A node that is free has none of these, though it may name some.)
    void KeepAround(const b2TreeNode &node) {
        if (node.height < 0)
            return;
        KeepNode(node.parent);
        if (node.IsLeaf())
            return;
        for (const int32 child : {node.child1, node.child2}) {
            KeepNode(child);
            KeepNode(m_before.nodes[child].child1);
            KeepNode(m_before.nodes[child].child2);
        }
    }

    const b2DynamicTree &m_tree;
    const TreeMembers m_before;
    const Scalars m_start = Scalars(m_before);
    Scalars m_after;
    std::vector<Written> m_written, m_kept;
};

} // namespace bmr::tree

#endif
