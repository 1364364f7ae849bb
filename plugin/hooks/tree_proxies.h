// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_HOOKS_TREE_PROXIES_H
#define BOOMERANG_HOOKS_TREE_PROXIES_H

#include <cmath>

#include "hooks/tree_edit.h"

/// @file
/// b2DynamicTree::CreateProxy, DestroyProxy and MoveProxy. Each says whether it did it; where it did not,
/// nothing was written, and Box2D is to be asked. Those are the ids that are none of a leaf in the tree, on
/// which Box2D asserts; boxes that are not finite; and whatever makes Box2D's array of nodes grow. Rounding
/// is to nearest, as Box2D's.

namespace bmr::hooks {

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

template <typename Log>
bool CreateHere(const b2DynamicTree &tree, const b2AABB &aabb, void *userData, Log *log, int32 *id) {
    TreeEdit<Log> edit(MembersOf(tree), log);
    const b2AABB fat = Fat(aabb);
    if (!IsFinite(fat) || !edit.HasRoom())
        return false;
    *id = edit.Create(fat, userData);
    return true;
}

template <typename Log> bool DestroyHere(const b2DynamicTree &tree, int32 id, Log *log) {
    TreeEdit<Log> edit(MembersOf(tree), log);
    if (!edit.HasLeaf(id))
        return false;
    edit.Destroy(id);
    return true;
}

template <typename Log>
BMR_NOINLINE void MoveLeaf(const b2DynamicTree &tree, int32 id, const b2AABB &fat, Log *log) {
    TreeEdit<Log>(MembersOf(tree), log).Move(id, fat);
}

template <typename Log>
bool MoveHere(const b2DynamicTree &tree, int32 id, const b2AABB &aabb, const b2Vec2 &displacement, Log *log,
              bool *moved) {
    const TreeMembers members = MembersOf(tree);
    b2AABB fat = Fat(aabb);
    Foretell(displacement.x, &fat.lowerBound.x, &fat.upperBound.x);
    Foretell(displacement.y, &fat.lowerBound.y, &fat.upperBound.y);
    if (!IsFinite(fat) || !TreeEdit<Log>(members, log).HasLeaf(id))
        return false;
    *moved = !Stays(members.nodes[id].aabb, aabb, fat);
    if (*moved) // most stay, and need no edit
        MoveLeaf(tree, id, fat, log);
    return true;
}

} // namespace bmr::hooks

#endif
