// SPDX-License-Identifier: MIT
// b2DynamicTree::CreateProxy, DestroyProxy and MoveProxy, in steps and outside of them, for every caller.
#include "base/rounding_mode.h"
#include "reach/stock.h"
#include "start/settings.h"
#include "tree/proxies.h"

namespace bmr::hooks {

namespace {

bool IsOurs() {
    return PassesRun(HookOf::MoveProxy) && RoundsToNearest();
}

BMR_NOINLINE bool MoveInstalled(b2DynamicTree *tree, int32 id, const b2AABB &aabb,
                                const b2Vec2 &displacement) {
    const auto box2d = [&] { return stock::MoveProxy(tree, id, aabb, displacement); };
    return IsOurs() ? tree::MoveProxy(*tree, id, aabb, displacement, box2d) : box2d();
}

} // namespace

} // namespace bmr::hooks

using namespace bmr;
using namespace bmr::hooks;

BMR_FOR_LOADERS("_ZN13b2DynamicTree11CreateProxyERK6b2AABBPv");
BMR_FOR_LOADERS("_ZN13b2DynamicTree12DestroyProxyEi");
BMR_FOR_LOADERS("_ZN13b2DynamicTree9MoveProxyEiRK6b2AABBRK6b2Vec2");

int32 b2DynamicTree::CreateProxy(const b2AABB &aabb, void *userData) {
    const auto box2d = [&] { return stock::CreateProxy(this, aabb, userData); };
    return IsOurs() ? tree::CreateProxy(*this, aabb, userData, box2d) : box2d();
}

void b2DynamicTree::DestroyProxy(int32 id) {
    const auto box2d = [&] { stock::DestroyProxy(this, id); };
    if (IsOurs())
        tree::DestroyProxy(*this, id, box2d);
    else
        box2d();
}

bool b2DynamicTree::MoveProxy(int32 id, const b2AABB &aabb, const b2Vec2 &displacement) {
    return NothingIsInstalled() ? stock::MoveProxy(this, id, aabb, displacement)
                                : MoveInstalled(this, id, aabb, displacement);
}
