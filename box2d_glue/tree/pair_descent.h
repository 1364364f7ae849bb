// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TREE_PAIR_DESCENT_H
#define BOOMERANG_TREE_PAIR_DESCENT_H

#include <box2d/b2_broad_phase.h>
#include <box2d/b2_dynamic_tree.h>
#include <box2d/b2_fixture.h>

#include "tree/box.h"

/// @file
/// Which leaves of the tree overlap proxies that were moved, in the order in which Box2D finds them.
///
///   - Proxies of one body that were moved together descend the tree together, with the box around them all.
///     Each is then held against the few leaves of other bodies that this found. The leaves come in the order
///     of the descent, so each proxy meets them in the order in which its own would have.
///   - The tree is descended with boxes in registers, and a node is looked at before it is put on the stack.

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

namespace bmr::tree {

inline const b2Body *BodyOf(const void *proxy) {
    return static_cast<const b2FixtureProxy *>(proxy)->fixture->GetBody();
}

/// Does the proxy report this leaf? Not itself; and where both were moved, one of the two does.
inline bool Reports(int32 proxy, int32 leaf, bool moved) {
    return leaf != proxy && !(moved && leaf > proxy);
}

/// One proxy's own descent.
template <typename Keep> struct OneProxy {
    const b2Body *passedOver; ///< leaves of this one; nullptr: of none
    int32 proxy;
    const Keep &keep;

    static bool Visit(Box) { return true; }
    bool Take(int32 leaf, const b2TreeNode &node) const {
        if (Reports(proxy, leaf, node.moved) && BodyOf(node.userData) != passedOver)
            keep(proxy, leaf);
        return true;
    }
};

/// The descent of proxies of one body that follow each other among the moved ones.
struct ManyProxies {
    // Descents that are given up are made in vain. In gases and piles of bodies of 10 to 63 pieces these let
    // nearly all of them end.
    static constexpr int32 kMostLeaves = 1024, kVisitsForAProxy = 4096;

    struct Leaf {
        b2AABB box;
        int32 proxy;
        bool moved;
    };

    const b2Body *passedOver; ///< leaves of this one; nullptr: of none
    int32 visitsLeft;
    int32 count = 0;
    Leaf leaves[kMostLeaves];

    // cppcheck-suppress uninitMemberVar ; leaves are written before they are read
    ManyProxies(const b2Body *body, int32 proxies)
        : passedOver(body), visitsLeft(proxies * kVisitsForAProxy) {}

    /// Gives up where too much is near; and at a box that is not a number, because the boxes above it in the
    /// tree need not hold it, so that whether a proxy finds it depends on the way down.
    bool Visit(Box box) { return --visitsLeft >= 0 && HasNumbers(box); }
    bool Take(int32 leaf, const b2TreeNode &node) {
        if (BodyOf(node.userData) == passedOver)
            return true;
        if (count == kMostLeaves)
            return false;
        leaves[count++] = {node.aabb, leaf, node.moved};
        return true;
    }
};

/// Calls `keep(proxy, leaf)` for the pairs that Box2D would find. Without `ownPairs`, for none of two
/// fixtures of one body.
template <typename Keep> class PairDescent {
public:
    PairDescent(const b2DynamicTree &tree, bool ownPairs, const Keep &keep)
        : m_tree(tree), m_ownPairs(ownPairs), m_keep(keep) {
        tree.Query(&m_nodes, b2AABB());
    }
    void Run(const int32 *moves, int32 count) const;

private:
    bool FindTogether(const int32 *moves, int32 count) const;
    const b2Body *PassedOver(const b2Body *body) const { return m_ownPairs ? nullptr : body; }

    const b2DynamicTree &m_tree;
    TreeNodes m_nodes;
    bool m_ownPairs;
    const Keep &m_keep;
};

/// How many of the moves from the first on are of its body; those that were taken back count as such.
inline int32 CountTogether(const b2DynamicTree &tree, const int32 *moves, int32 count) {
    const b2Body *body = BodyOf(tree.GetUserData(moves[0]));
    int32 together = 1;
    while (together < count && (moves[together] == b2BroadPhase::e_nullProxy ||
                                BodyOf(tree.GetUserData(moves[together])) == body))
        ++together;
    return together;
}

template <typename Keep> void PairDescent<Keep>::Run(const int32 *moves, int32 count) const {
    for (int32 i = 0; i < count;) {
        if (moves[i] == b2BroadPhase::e_nullProxy) {
            ++i;
            continue;
        }
        const int32 together = CountTogether(m_tree, moves + i, count - i);
        if (together == 1 || !FindTogether(moves + i, together)) {
            for (int32 j = i; j < i + together; ++j) {
                if (moves[j] == b2BroadPhase::e_nullProxy)
                    continue;
                OneProxy<Keep> one = {PassedOver(BodyOf(m_tree.GetUserData(moves[j]))), moves[j], m_keep};
                Descend(m_nodes, BoxOf(m_tree.GetFatAABB(moves[j])), &one);
            }
        }
        i += together;
    }
}

/// False, and nothing kept, where the proxies are to descend one by one.
template <typename Keep> bool PairDescent<Keep>::FindTogether(const int32 *moves, int32 count) const {
    Box around = BoxOf(m_tree.GetFatAABB(moves[0]));
    for (int32 i = 0; i < count; ++i) {
        if (moves[i] == b2BroadPhase::e_nullProxy)
            continue;
        const Box box = BoxOf(m_tree.GetFatAABB(moves[i]));
        if (!HasNumbers(box))
            return false;
        around = Around(around, box);
    }
    ManyProxies many(PassedOver(BodyOf(m_tree.GetUserData(moves[0]))), count);
    if (!Descend(m_nodes, around, &many))
        return false;
    for (int32 i = 0; i < count; ++i) {
        if (moves[i] == b2BroadPhase::e_nullProxy)
            continue;
        const Box box = BoxOf(m_tree.GetFatAABB(moves[i]));
        for (int32 j = 0; j < many.count; ++j) {
            const ManyProxies::Leaf &leaf = many.leaves[j];
            if (Overlap(BoxOf(leaf.box), box) && Reports(moves[i], leaf.proxy, leaf.moved))
                m_keep(moves[i], leaf.proxy);
        }
    }
    return true;
}

} // namespace bmr::tree

#endif
