// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TREE_PROXIES_H
#define BOOMERANG_TREE_PROXIES_H

#include <cmath>

#include "base/compiler.h"
#include "tree/edit.h"

/// @file
/// b2DynamicTree::CreateProxy, DestroyProxy and MoveProxy: the same tree by the same arithmetic, with boxes
/// in registers and without a call for each node that is balanced. `box2d()` is Box2D's own function, which
/// is asked for ids that are none of a leaf in the tree, on which it asserts; for boxes that are not finite;
/// and where Box2D's array of nodes must grow. Rounding is to nearest, as Box2D's.

namespace bmr::tree {

inline bool IsFinite(const b2AABB &box) {
    return std::isfinite(box.lowerBound.x) && std::isfinite(box.lowerBound.y) &&
           std::isfinite(box.upperBound.x) && std::isfinite(box.upperBound.y);
}

inline b2AABB Larger(const b2AABB &aabb, const b2Vec2 &margin) {
    b2AABB larger;
    larger.lowerBound = aabb.lowerBound - margin;
    larger.upperBound = aabb.upperBound + margin;
    return larger;
}

/// The box of a new leaf.
inline b2AABB Fat(const b2AABB &aabb) {
    return Larger(aabb, b2Vec2(b2_aabbExtension, b2_aabbExtension));
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

// Each of these says whether it did it. Where it did not, nothing was written.

inline bool CreateHere(const b2DynamicTree &tree, const b2AABB &aabb, void *userData, int32 *id) {
    TreeEdit edit(MembersOf(tree));
    const b2AABB fat = Fat(aabb);
    if (!IsFinite(fat) || !edit.HasRoom())
        return false;
    *id = edit.Create(fat, userData);
    return true;
}

inline bool DestroyHere(const b2DynamicTree &tree, int32 id) {
    TreeEdit edit(MembersOf(tree));
    if (!edit.HasLeaf(id))
        return false;
    edit.Destroy(id);
    return true;
}

BMR_NOINLINE inline void MoveLeaf(const b2DynamicTree &tree, int32 id, const b2AABB &fat) {
    TreeEdit(MembersOf(tree)).Move(id, fat);
}

inline bool MoveHere(const b2DynamicTree &tree, int32 id, const b2AABB &aabb, const b2Vec2 &displacement,
                     bool *moved) {
    const TreeMembers members = MembersOf(tree);
    b2AABB fat = Fat(aabb);
    Foretell(displacement.x, &fat.lowerBound.x, &fat.upperBound.x);
    Foretell(displacement.y, &fat.lowerBound.y, &fat.upperBound.y);
    if (!IsFinite(fat) || !TreeEdit(members).HasLeaf(id))
        return false;
    *moved = !Stays(members.nodes[id].aabb, aabb, fat);
    if (*moved) // most stay, and need no edit
        MoveLeaf(tree, id, fat);
    return true;
}

template <typename Box2D>
int32 CreateProxy(const b2DynamicTree &tree, const b2AABB &aabb, void *userData, const Box2D &box2d) {
    int32 id;
    return CreateHere(tree, aabb, userData, &id) ? id : box2d();
}

template <typename Box2D> void DestroyProxy(const b2DynamicTree &tree, int32 id, const Box2D &box2d) {
    if (!DestroyHere(tree, id))
        box2d();
}

template <typename Box2D>
bool MoveProxy(const b2DynamicTree &tree, int32 id, const b2AABB &aabb, const b2Vec2 &displacement,
               const Box2D &box2d) {
    bool moved;
    return MoveHere(tree, id, aabb, displacement, &moved) ? moved : box2d();
}

} // namespace bmr::tree

#endif
