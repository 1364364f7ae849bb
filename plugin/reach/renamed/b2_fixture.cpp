// SPDX-License-Identifier: MIT
// See names.h. (SetFilterData calls Refilter. Both have hooks, which do the same afterwards.)
#include "box2d/b2_body.h"

class b2BroadPhase;
class b2Fixture;
struct b2Filter;

namespace bmr {
namespace stock {

void Refilter(b2Fixture *fixture);
void SetFilterData(b2Fixture *fixture, const b2Filter &filter);
void Synchronize(b2Fixture *fixture, b2BroadPhase *broadPhase, const b2Transform &xf1,
                 const b2Transform &xf2);

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

void bmr::stock::Refilter(b2Fixture *fixture) {
    fixture->BmrStockRefilter();
}

void bmr::stock::SetFilterData(b2Fixture *fixture, const b2Filter &filter) {
    fixture->BmrStockSetFilterData(filter);
}

void bmr::stock::Synchronize(b2Fixture *fixture, b2BroadPhase *broadPhase, const b2Transform &xf1,
                             const b2Transform &xf2) {
    fixture->BmrStockSynchronize(broadPhase, xf1, xf2);
}
