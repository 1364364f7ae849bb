// SPDX-License-Identifier: MIT
// See b2_world.cpp. (SetFilterData calls Refilter. Both have hooks, which do the same afterwards.)
#include "box2d/b2_body.h"

class b2BroadPhase;
class b2Fixture;
struct b2Filter;

namespace bmr {
namespace stock {

BMR_HOOKS_OF_b2_fixture(BMR_DECLARE_STOCK)

} // namespace stock
} // namespace bmr

#define Refilter BmrStockRefilter
#define SetFilterData BmrStockSetFilterData
// It is protected.
#define Synchronize(...)                                                                                     \
    BmrStockSynchronize(__VA_ARGS__);                                                                        \
    friend void ::bmr::stock::Synchronize(b2Fixture *, b2BroadPhase *, const b2Transform &,                  \
                                          const b2Transform &)
#include "box2d/b2_fixture.h"
#undef Synchronize

#define Synchronize BmrStockSynchronize
#include BMR_BOX2D_SOURCE
#undef Refilter
#undef SetFilterData
#undef Synchronize
