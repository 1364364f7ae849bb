// SPDX-License-Identifier: MIT
// See b2_world.cpp.
#define b2TimeOfImpact BmrStockTimeOfImpact
#include BMR_BOX2D_SOURCE
#undef b2TimeOfImpact

namespace bmr {
namespace stock {

BMR_HOOKS_OF_b2_time_of_impact(BMR_DECLARE_STOCK) BMR_HOOKS_OF_b2_time_of_impact(BMR_DEFINE_STOCK)

} // namespace stock
} // namespace bmr
