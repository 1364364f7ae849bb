// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TREE_PAIR_DESCENT_H
#define BOOMERANG_TREE_PAIR_DESCENT_H

#include <box2d/b2_broad_phase.h>
#include <box2d/b2_dynamic_tree.h>
#include <box2d/b2_fixture.h>

#include "base/columns.h"
#include "base/private_members.h"
#include "tree/edit.h"

/// @file
/// Which leaves of the tree overlap proxies that were moved, in the order in which Box2D finds them.
///
/// Box2D lets each proxy go down the tree alone. Here all go down together. Those of one body that were moved
/// one after the other are a group, which has the box around them; a node is read once, and held against the
/// boxes of all groups that have come to its parent. At a leaf each proxy of a group is held against it. A
/// leaf's box lies in those of the nodes above it, so a proxy finds the leaves that it would find alone, in
/// the order of the descent. That is not so where a box is not a number: then each proxy is a group.

namespace bmr::tree {

inline const b2Body *BodyOf(const void *proxy) {
    return static_cast<const b2FixtureProxy *>(proxy)->fixture->GetBody();
}

/// Does the proxy report this leaf? Not itself; and where both were moved, one of the two does.
inline bool Reports(int32 proxy, int32 leaf, bool moved) {
    return leaf != proxy && !(moved && leaf > proxy);
}

/// Groups of proxies on their way down, and what they have found. A thread keeps the memory.
struct DescentScratch {
    struct Group {
        Box box;
        const b2Body *body;
        uint32_t begin, end; ///< its proxies
    };
    struct Proxy {
        Box box;
        int32 id;
        uint32_t end; ///< of what it found, in `leaves`
    };
    struct Found {
        uint32_t proxy;
        int32 leaf;
    };

    Column<Proxy> proxies;
    Column<Group> groups;
    Column<uint32_t> lists; ///< of groups: those that have come to a node
    Column<Found> found;    ///< in the order of the descent
    Column<int32> leaves;   ///< the same, proxy by proxy
};

/// Calls `keep(proxy, leaf)` for the pairs that Box2D would find, but for none of two fixtures of one body.
template <typename Keep> class PairDescent {
public:
    PairDescent(const b2DynamicTree &tree, DescentScratch *scratch, const Keep &keep)
        : m_tree(tree), m_nodes(tree.*Named(TreeNodes())), m_scratch(*scratch), m_keep(keep) {}

    void Run(const int32 *moves, int32 count) {
        if (m_tree.*Named(TreeRoot()) == b2_nullNode)
            return;
        // More at a time would not stay in the processor's caches.
        constexpr int32 kAtATime = 1024, kMostOfGroup = 16;
        for (int32 i = 0; i < count; i += kAtATime) {
            const int32 some = b2Min(kAtATime, count - i);
            if (!Group(moves + i, some, kMostOfGroup) || !Descend()) {
                Group(moves + i, some, 1);
                Descend();
            }
            Report();
        }
    }

private:
    /// A node, and the part of the lists that says which groups have come there.
    struct Visit {
        int32 node;
        uint32_t begin, end;
    };

    /// False where a box is not a number.
    bool Group(const int32 *moves, int32 count, uint32_t most) {
        m_proxyCount = m_groupCount = 0;
        m_scratch.proxies.Reserve(static_cast<uint32_t>(count));
        m_scratch.groups.Reserve(static_cast<uint32_t>(count));
        const b2Body *last = nullptr;
        bool haveNumbers = true;
        for (int32 i = 0; i < count; ++i) {
            if (moves[i] == b2BroadPhase::e_nullProxy)
                continue;
            const Box box = BoxOf(m_tree.GetFatAABB(moves[i]));
            const b2Body *const body = BodyOf(m_tree.GetUserData(moves[i]));
            haveNumbers = haveNumbers && HasNumbers(box);
            m_scratch.proxies[m_proxyCount++] = {box, moves[i], 0};
            DescentScratch::Group *group = m_groupCount > 0 ? &m_scratch.groups[m_groupCount - 1] : nullptr;
            if (body == last && group->end - group->begin < most) {
                group->box = Around(group->box, box);
                group->end = m_proxyCount;
            } else
                m_scratch.groups[m_groupCount++] = {box, body, m_proxyCount - 1, m_proxyCount};
            last = body;
        }
        m_single = most == 1;
        return haveNumbers;
    }

    /// False where groups come to a box that is not a number.
    bool Descend() {
        m_found = 0;
        b2GrowableStack<Visit, 64> waiting;
        waiting.Push(Root());
        while (waiting.GetCount() > 0) {
            // Down one branch, which is the second child's where there are two; the others wait.
            Visit visit = waiting.Pop();
            while (visit.begin < visit.end && !m_nodes[visit.node].IsLeaf()) {
                const Visit first = Divide(&visit);
                if (first.begin < first.end)
                    waiting.Push(first);
            }
            if (visit.begin < visit.end)
                Take(visit);
        }
        return m_single || m_numbers;
    }

    Visit Root() {
        const int32 root = m_tree.*Named(TreeRoot());
        const Box box = BoxOf(m_nodes[root].aabb);
        m_numbers = HasNumbers(box);
        Visit visit = {root, 0, 0};
        m_scratch.lists.Reserve(m_groupCount);
        for (uint32_t i = 0; i < m_groupCount; ++i) {
            m_scratch.lists[visit.end] = i;
            visit.end += Overlap(m_scratch.groups[i].box, box) ? 1 : 0;
        }
        return visit;
    }

    /// Goes on to the second child, whose list comes behind the node's. Returns the first child, whose list
    /// takes the node's place.
    Visit Divide(Visit *visit) {
        const b2TreeNode &node = m_nodes[visit->node];
        const Box box1 = BoxOf(m_nodes[node.child1].aabb), box2 = BoxOf(m_nodes[node.child2].aabb);
        m_numbers = m_numbers && HasNumbers(box1) && HasNumbers(box2);
        const uint32_t begin = visit->begin, end = visit->end;
        m_scratch.lists.Reserve(2 * end - begin);
        uint32_t *const lists = m_scratch.lists.Data();
        uint32_t end1 = begin, end2 = end;
        for (uint32_t i = begin; i < end; ++i) {
            const uint32_t group = lists[i];
            const Box box = m_scratch.groups[group].box;
            lists[end1] = group;
            end1 += Overlap(box, box1) ? 1 : 0;
            lists[end2] = group;
            end2 += Overlap(box, box2) ? 1 : 0;
        }
        *visit = {node.child2, end, end2};
        return {node.child1, begin, end1};
    }

    void Take(const Visit &leaf) {
        const b2TreeNode &node = m_nodes[leaf.node];
        const b2Body *const body = BodyOf(node.userData);
        const Box box = BoxOf(node.aabb);
        for (uint32_t i = leaf.begin; i < leaf.end; ++i) {
            const DescentScratch::Group &group = m_scratch.groups[m_scratch.lists[i]];
            if (group.body == body)
                continue;
            m_scratch.found.Reserve(m_found + (group.end - group.begin));
            for (uint32_t j = group.begin; j < group.end; ++j)
                if (Overlap(m_scratch.proxies[j].box, box) &&
                    Reports(m_scratch.proxies[j].id, leaf.node, node.moved)) {
                    m_scratch.found[m_found++] = {j, leaf.node};
                    ++m_scratch.proxies[j].end;
                }
        }
    }

    /// Proxy by proxy, as they were moved.
    void Report() {
        uint32_t sum = 0;
        for (uint32_t i = 0; i < m_proxyCount; ++i) {
            const uint32_t found = m_scratch.proxies[i].end;
            m_scratch.proxies[i].end = sum; // its beginning, which moves on to its end
            sum += found;
        }
        m_scratch.leaves.Reserve(m_found);
        for (uint32_t i = 0; i < m_found; ++i)
            m_scratch.leaves[m_scratch.proxies[m_scratch.found[i].proxy].end++] = m_scratch.found[i].leaf;
        for (uint32_t i = 0, next = 0; i < m_proxyCount; ++i)
            for (; next < m_scratch.proxies[i].end; ++next)
                m_keep(m_scratch.proxies[i].id, m_scratch.leaves[next]);
    }

    const b2DynamicTree &m_tree;
    const b2TreeNode *m_nodes;
    DescentScratch &m_scratch;
    const Keep &m_keep;
    uint32_t m_proxyCount = 0, m_groupCount = 0, m_found = 0;
    bool m_single = false;  ///< each group is one proxy
    bool m_numbers = false; ///< all boxes that groups came to
};

} // namespace bmr::tree

#endif
