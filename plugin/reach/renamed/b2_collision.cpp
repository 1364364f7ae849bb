// SPDX-License-Identifier: MIT
// See names.h. (The inline overload of b2TestOverlap on boxes has the new name in this file, too.)
#define b2TestOverlap BmrStockTestOverlap
#include BMR_BOX2D_SOURCE
#undef b2TestOverlap

namespace bmr {
namespace stock {

bool TestOverlap(const b2Shape *shapeA, int32 indexA, const b2Shape *shapeB, int32 indexB,
                 const b2Transform &xfA, const b2Transform &xfB);

bool TestOverlap(const b2Shape *shapeA, int32 indexA, const b2Shape *shapeB, int32 indexB,
                 const b2Transform &xfA, const b2Transform &xfB) {
    return BmrStockTestOverlap(shapeA, indexA, shapeB, indexB, xfA, xfB);
}

} // namespace stock
} // namespace bmr
