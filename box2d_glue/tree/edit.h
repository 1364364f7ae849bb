// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TREE_EDIT_H
#define BOOMERANG_TREE_EDIT_H

#include <initializer_list>
#include <utility>

#include <box2d/b2_dynamic_tree.h>

#include "base/compiler.h"
#include "base/private_members.h"
#include "exact32/float4.h"

class b2Body;

/// @file
/// A leaf of a b2DynamicTree is moved as Box2D does it: every field of every node and the tree's own members
/// are left with the same bits.
///
/// Boxes of nodes are in lanes. Operations and operands are Box2D's, also where a number is none: b2Min(a, b)
/// is `a < b ? a : b`, and so are lanes.

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

/// A node on the way down, the perimeter of its box, and that of the box around it and the leaf.
///
/// Box2D computes both twice: for a child, and again once it is there. Here they are computed once. They are
/// the same numbers, but for the sign of a zero, which no comparison sees, and but for a box that has a NaN
/// in it: b2Min and b2Max give their second operand there, which is the leaf's in one of the two. But then
/// the perimeter of the node's own box is NaN both times, with it both costs of going on are, and Box2D goes
/// on to the second child for any `around`.
struct Place {
    int32 id;
    float area, around;
};

/// The costs that InsertLeaf compares at a node.
class Costs {
public:
    explicit Costs(const Place &place)
        : m_here(2.0f * place.around), m_inherited(2.0f * (place.around - place.area)) {}

    /// Of going on to a child. The leaf's new parent takes a leaf's place: all of its perimeter counts. (What
    /// zero is taken from stays as it is.)
    float Below(const Place &child, const b2TreeNode &node) const {
        return (child.around - (node.IsLeaf() ? 0.0f : child.area)) + m_inherited;
    }

    bool EndHere(float cost1, float cost2) const { return m_here < cost1 && m_here < cost2; }

private:
    float m_here, m_inherited;
};

/// What b2DynamicTree does to its nodes.
class TreeEdit {
public:
    explicit TreeEdit(b2DynamicTree *tree) : m_tree(*tree), m_nodes(tree->*Named(TreeNodes())) {}

    /// Is this a leaf that is in the tree? Box2D asserts that it is one. (A node that is free has a height
    /// below 0.)
    bool HasLeaf(int32 id) const {
        return 0 <= id && id < m_tree.*Named(TreeCapacity()) && m_nodes[id].IsLeaf() &&
               m_nodes[id].height == 0;
    }

    /// The rest of b2DynamicTree::MoveProxy of a leaf that is in the tree; `fat` is finite. Box2D frees the
    /// leaf's parent, and the first free node, which is that one, becomes its parent again.
    void Move(int32 leaf, const b2AABB &fat) {
        b2TreeNode &node = m_nodes[leaf];
        node.aabb = fat;
        node.moved = true;
        ++(m_tree.*Named(TreeInsertions()));
        if (leaf == m_tree.*Named(TreeRoot()))
            return;
        const int32 parent = node.parent;
        Refit(TakeOut(leaf));
        const LeafBox box(BoxOf(fat));
        Insert(leaf, parent, FindSibling(box, Root(box)));
    }

private:
    /// `parent` has `now` for a child, where it had `before`; without a parent that is the tree's root.
    void Replace(int32 parent, int32 before, int32 now) {
        if (parent == b2_nullNode) {
            m_tree.*Named(TreeRoot()) = now;
            return;
        }
        b2TreeNode &node = m_nodes[parent];
        (node.child1 == before ? node.child1 : node.child2) = now;
    }

    /// From a place on, down to whom b2DynamicTree::InsertLeaf makes the leaf's sibling.
    /// (Nodes in between are asked for two levels ahead, both ways.)
    int32 FindSibling(const LeafBox &leaf, Place place) const {
        while (!m_nodes[place.id].IsLeaf()) {
            const int32 id1 = m_nodes[place.id].child1, id2 = m_nodes[place.id].child2;
            const b2TreeNode &child1 = m_nodes[id1], &child2 = m_nodes[id2];
            for (const int32 next : {child1.child1, child1.child2, child2.child1, child2.child2})
                PrefetchNode(m_nodes, next);
            const Perimeters of = leaf.With(BoxOf(child1.aabb), BoxOf(child2.aabb));
            const Place first = {id1, of.first, of.aroundFirst}, second = {id2, of.second, of.aroundSecond};
            const Costs costs(place);
            const float cost1 = costs.Below(first, child1), cost2 = costs.Below(second, child2);
            if (costs.EndHere(cost1, cost2))
                break;
            place = cost1 < cost2 ? first : second;
        }
        return place.id;
    }

    Place Root(const LeafBox &leaf) const {
        const int32 root = m_tree.*Named(TreeRoot());
        const Box box = BoxOf(m_nodes[root].aabb);
        const Perimeters of = leaf.With(box, box);
        return {root, of.first, of.aroundFirst};
    }

    void Insert(int32 leaf, int32 parent, int32 sibling) {
        const int32 above = m_nodes[sibling].parent;
        b2TreeNode &node = m_nodes[parent];
        node.parent = above;
        node.height = m_nodes[sibling].height + 1;
        node.child1 = sibling;
        node.child2 = leaf; // its box comes with Refit
        Replace(above, sibling, parent);
        m_nodes[sibling].parent = parent;
        m_nodes[leaf].parent = parent;
        Refit(parent);
    }

    /// Not of the leaf that alone is the tree. Returns the node above its parent, if there is one.
    int32 TakeOut(int32 leaf) {
        const int32 parent = m_nodes[leaf].parent, above = m_nodes[parent].parent;
        const int32 sibling =
            m_nodes[parent].child1 == leaf ? m_nodes[parent].child2 : m_nodes[parent].child1;
        Replace(above, parent, sibling);
        m_nodes[sibling].parent = above;
        return above;
    }

    /// From here up to the root, nodes are balanced and given the boxes and heights that their children say.
    void Refit(int32 id) {
        while (id != b2_nullNode) {
            b2TreeNode *node = &m_nodes[id];
            const int32 balance = m_nodes[node->child2].height - m_nodes[node->child1].height;
            if ((balance > 1 || balance < -1) && node->height >= 2) {
                id = balance > 1 ? RaiseSecond(id) : RaiseFirst(id);
                node = &m_nodes[id];
            }
            Combine(node, m_nodes[node->child1], m_nodes[node->child2]);
            id = node->parent;
        }
    }

    // Balance: a node's higher child takes its place, and the node becomes that one's first child. The higher
    // one of its children stays with it, the other one goes to the node.

    int32 RaiseSecond(int32 idA) {
        b2TreeNode &a = m_nodes[idA];
        const int32 idC = a.child2;
        b2TreeNode &c = m_nodes[idC];
        int32 stays = c.child1, goes = c.child2;
        Raise(idA, idC, &stays, &goes);
        a.child2 = goes;
        Combine(&a, m_nodes[a.child1], m_nodes[goes]);
        Combine(&c, a, m_nodes[stays]);
        return idC;
    }

    int32 RaiseFirst(int32 idA) {
        b2TreeNode &a = m_nodes[idA];
        const int32 idB = a.child1;
        b2TreeNode &b = m_nodes[idB];
        int32 stays = b.child1, goes = b.child2;
        Raise(idA, idB, &stays, &goes);
        a.child1 = goes;
        Combine(&a, m_nodes[a.child2], m_nodes[goes]); // in this order
        Combine(&b, a, m_nodes[stays]);
        return idB;
    }

    void Raise(int32 id, int32 raised, int32 *stays, int32 *goes) {
        b2TreeNode &node = m_nodes[id], &higher = m_nodes[raised];
        if (!(m_nodes[*stays].height > m_nodes[*goes].height))
            std::swap(*stays, *goes);
        higher.parent = node.parent;
        higher.child1 = id;
        higher.child2 = *stays;
        node.parent = raised;
        Replace(higher.parent, id, raised);
        m_nodes[*goes].parent = id;
    }

    static void Combine(b2TreeNode *node, const b2TreeNode &first, const b2TreeNode &second) {
        store4(&node->aabb.lowerBound.x, Around(BoxOf(first.aabb), BoxOf(second.aabb)));
        node->height = 1 + b2Max(first.height, second.height);
    }

    b2DynamicTree &m_tree;
    b2TreeNode *m_nodes;
};

// b2DynamicTree::MoveProxy: the same tree by the same arithmetic, with boxes in registers and without a call
// for each node that is balanced. Box2D's own function is to be asked for ids that are none of a leaf in the
// tree, on which it asserts, and for boxes that are not finite. Rounding is to nearest, as Box2D's.

inline b2AABB Larger(const b2AABB &aabb, const b2Vec2 &margin) {
    b2AABB larger;
    larger.lowerBound = aabb.lowerBound - margin;
    larger.upperBound = aabb.upperBound + margin;
    return larger;
}

/// Along one axis a box is made longer by what the displacement foretells.
inline void Foretell(float displacement, float *lower, float *upper) {
    const float d = b2_aabbMultiplier * displacement;
    if (d < 0.0f)
        *lower += d;
    else
        *upper += d;
}

/// Does the leaf's box hold the proxy's, and is it not much too large?
inline bool Stays(const b2AABB &leaf, const b2AABB &aabb, const b2AABB &fat) {
    return leaf.Contains(aabb) &&
           Larger(fat, 4.0f * b2Vec2(b2_aabbExtension, b2_aabbExtension)).Contains(leaf);
}

BMR_NOINLINE inline void MoveLeaf(b2DynamicTree *tree, int32 id, const b2AABB &fat) {
    TreeEdit(tree).Move(id, fat);
}

/// Says whether it did it. If it did not, nothing was written.
inline bool MoveHere(b2DynamicTree *tree, int32 id, const b2AABB &aabb, const b2Vec2 &displacement,
                     bool *moved) {
    b2AABB fat = Larger(aabb, b2Vec2(b2_aabbExtension, b2_aabbExtension));
    Foretell(displacement.x, &fat.lowerBound.x, &fat.upperBound.x);
    Foretell(displacement.y, &fat.lowerBound.y, &fat.upperBound.y);
    if (!fat.lowerBound.IsValid() || !fat.upperBound.IsValid() || !TreeEdit(tree).HasLeaf(id))
        return false;
    *moved = !Stays((tree->*Named(TreeNodes()))[id].aabb, aabb, fat);
    if (*moved) // most stay, and need no edit
        MoveLeaf(tree, id, fat);
    return true;
}

/// b2Body::SynchronizeFixtures: after a step the box of each fixture of the body is set anew, around where it
/// was and where it is, and its leaf of the tree moves if it must. In any rounding.
void SynchronizeBoxes(b2Body *body);

} // namespace bmr::tree

#endif
