// SPDX-License-Identifier: MIT
// b2DynamicTree::CreateProxy, DestroyProxy and MoveProxy: the same tree by the same arithmetic (tree_edit.h),
// with boxes in registers and without a call for each node that is balanced. In steps and outside of them,
// for whoever calls.
#include <new>

#include "hooks/tree_log.h"
#include "hooks/tree_proxies.h"
#include "reach/stock.h"
#include "start/rounding_mode.h"
#include "start/settings.h"
#include "tell/verify.h"

namespace bmr::hooks {

namespace {

bool IsOurs() {
    return HookIsOn(Hook::TreeUpdates) && RoundsToNearest();
}

/// Does what `ours(log)` does, which says whether it did it and gives its result, undoes it and has Box2D do
/// it. The comparison is left out where there is no memory for it.
template <typename Ours, typename Box2D>
auto Compare(b2DynamicTree *tree, const Ours &ours, const Box2D &box2d) {
    TreeLog log(*tree);
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

BMR_NOINLINE bool CompareMove(b2DynamicTree *tree, int32 id, const b2AABB &aabb, const b2Vec2 &displacement) {
    return Compare(
        tree, [&](auto *log, bool *moved) { return MoveHere(*tree, id, aabb, displacement, log, moved); },
        [&] { return stock::MoveProxy(tree, id, aabb, displacement); });
}

BMR_NOINLINE bool MoveInstalled(b2DynamicTree *tree, int32 id, const b2AABB &aabb,
                                const b2Vec2 &displacement) {
    if (!IsOurs())
        return stock::MoveProxy(tree, id, aabb, displacement);
    if (Verifying())
        return CompareMove(tree, id, aabb, displacement);
    NoLog log;
    bool moved;
    return MoveHere(*tree, id, aabb, displacement, &log, &moved)
               ? moved
               : stock::MoveProxy(tree, id, aabb, displacement);
}

} // namespace

} // namespace bmr::hooks

using namespace bmr;
using namespace bmr::hooks;

BMR_FOR_LOADERS("_ZN13b2DynamicTree11CreateProxyERK6b2AABBPv");
BMR_FOR_LOADERS("_ZN13b2DynamicTree12DestroyProxyEi");
BMR_FOR_LOADERS("_ZN13b2DynamicTree9MoveProxyEiRK6b2AABBRK6b2Vec2");

int32 b2DynamicTree::CreateProxy(const b2AABB &aabb, void *userData) {
    b2DynamicTree *const tree = this;
    const auto box2d = [=, &aabb] { return stock::CreateProxy(tree, aabb, userData); };
    const auto ours = [=, &aabb](auto *log, int32 *id) { return CreateHere(*tree, aabb, userData, log, id); };
    if (!IsOurs())
        return box2d();
    if (Verifying())
        return Compare(tree, ours, box2d);
    NoLog log;
    int32 id;
    return ours(&log, &id) ? id : box2d();
}

void b2DynamicTree::DestroyProxy(int32 id) {
    b2DynamicTree *const tree = this;
    const auto box2d = [=] {
        stock::DestroyProxy(tree, id);
        return true;
    };
    const auto ours = [=](auto *log, bool *done) { return *done = DestroyHere(*tree, id, log); };
    NoLog log;
    bool done;
    if (IsOurs() && Verifying())
        Compare(tree, ours, box2d);
    else if (!IsOurs() || !ours(&log, &done))
        box2d();
}

bool b2DynamicTree::MoveProxy(int32 id, const b2AABB &aabb, const b2Vec2 &displacement) {
    return NothingIsInstalled() ? stock::MoveProxy(this, id, aabb, displacement)
                                : MoveInstalled(this, id, aabb, displacement);
}
