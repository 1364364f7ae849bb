// SPDX-License-Identifier: MIT
// See b2_world.cpp.
#define CreateProxy BmrStockCreateProxy
#define DestroyProxy BmrStockDestroyProxy
#define MoveProxy BmrStockMoveProxy
#include BMR_BOX2D_SOURCE
#undef CreateProxy
#undef DestroyProxy
#undef MoveProxy

namespace bmr {
namespace stock {

BMR_HOOKS_OF_b2_dynamic_tree(BMR_DECLARE_STOCK) BMR_HOOKS_OF_b2_dynamic_tree(BMR_DEFINE_STOCK)

} // namespace stock
} // namespace bmr
