// SPDX-License-Identifier: MIT
// See names.h.
#define b2TimeOfImpact BmrStockTimeOfImpact
#include BMR_BOX2D_SOURCE
#undef b2TimeOfImpact

namespace bmr {
namespace stock {

void TimeOfImpact(b2TOIOutput *output, const b2TOIInput *input);

void TimeOfImpact(b2TOIOutput *output, const b2TOIInput *input) {
    BmrStockTimeOfImpact(output, input);
}

} // namespace stock
} // namespace bmr
