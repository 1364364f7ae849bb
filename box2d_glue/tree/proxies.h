// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TREE_PROXIES_H
#define BOOMERANG_TREE_PROXIES_H

#include <cmath>
#include <new>

#include "start/settings.h"
#include "tell/verify.h"
#include "tree/log.h"

/// @file
/// b2DynamicTree::CreateProxy, DestroyProxy and MoveProxy: the same tree by the same arithmetic, with boxes
/// in registers and without a call for each node that is balanced. `box2d()` is Box2D's own function, which
/// is asked for ids that are none of a leaf in the tree, on which it asserts; for boxes that are not finite;
/// and where Box2D's array of nodes must grow. Rounding is to nearest, as Box2D's. In Mode::Verify Box2D does
/// it again, and the two trees are compared.

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

/// Does what `ours(log, result)` does, undoes it and has Box2D do it. The comparison is left out where there
/// is no memory for it.
template <typename Ours, typename Box2D>
BMR_NOINLINE auto Compare(const b2DynamicTree &tree, const Ours &ours, const Box2D &box2d) {
    TreeLog log(tree);
    bool done = false;
    decltype(box2d()) result = {};
    try {
        done = ours(&log, &result);
        log.Keep();
    } catch (const std::bad_alloc &) {
        done = false;
    }
    log.Undo();
    const auto expected = box2d();
    if (done) {
        CountVerified();
        const int32 node = log.Difference();
        if (node != TreeLog::kNone || result != expected)
            ReportDifference("tree updates", nullptr, nullptr, "node %d is another", node);
    }
    return expected;
}

template <typename Ours, typename Box2D>
auto DoHere(const b2DynamicTree &tree, const Ours &ours, const Box2D &box2d) {
    if (Verifying())
        return Compare(tree, ours, box2d);
    NoLog log;
    decltype(box2d()) result;
    return ours(&log, &result) ? result : box2d();
}

template <typename Box2D>
int32 CreateProxy(const b2DynamicTree &tree, const b2AABB &aabb, void *userData, const Box2D &box2d) {
    return DoHere(
        tree, [&](auto *log, int32 *id) { return CreateHere(tree, aabb, userData, log, id); }, box2d);
}

/// `box2d()` returns true.
template <typename Box2D> void DestroyProxy(const b2DynamicTree &tree, int32 id, const Box2D &box2d) {
    DoHere(
        tree, [&](auto *log, bool *done) { return *done = DestroyHere(tree, id, log); }, box2d);
}

template <typename Box2D>
bool MoveProxy(const b2DynamicTree &tree, int32 id, const b2AABB &aabb, const b2Vec2 &displacement,
               const Box2D &box2d) {
    return DoHere(
        tree, [&](auto *log, bool *moved) { return MoveHere(tree, id, aabb, displacement, log, moved); },
        box2d);
}

} // namespace bmr::tree

#endif
