// SPDX-License-Identifier: MIT
// See names.h.
#define CreateProxy BmrStockCreateProxy
#define DestroyProxy BmrStockDestroyProxy
#define MoveProxy BmrStockMoveProxy
#include BMR_BOX2D_SOURCE
#undef CreateProxy
#undef DestroyProxy
#undef MoveProxy

namespace bmr {
namespace stock {

int32 CreateProxy(b2DynamicTree *tree, const b2AABB &aabb, void *userData);
void DestroyProxy(b2DynamicTree *tree, int32 proxy);
bool MoveProxy(b2DynamicTree *tree, int32 proxy, const b2AABB &aabb, const b2Vec2 &displacement);

int32 CreateProxy(b2DynamicTree *tree, const b2AABB &aabb, void *userData) {
    return tree->BmrStockCreateProxy(aabb, userData);
}

void DestroyProxy(b2DynamicTree *tree, int32 proxy) {
    tree->BmrStockDestroyProxy(proxy);
}

bool MoveProxy(b2DynamicTree *tree, int32 proxy, const b2AABB &aabb, const b2Vec2 &displacement) {
    return tree->BmrStockMoveProxy(proxy, aabb, displacement);
}

} // namespace stock
} // namespace bmr
