// SPDX-License-Identifier: MIT
// See b2_world.cpp.
#define b2TimeOfImpact BmrStockTimeOfImpact
#include BMR_BOX2D_SOURCE
#undef b2TimeOfImpact

namespace bmr {

[[noreturn]] void FailAsAssert(const char *assertion, const char *function);

namespace stock {

BMR_HOOKS_OF_b2_time_of_impact(BMR_DECLARE_STOCK) BMR_HOOKS_OF_b2_time_of_impact(BMR_DEFINE_STOCK)

    bool Asserts();
void Fails(const char *assertion);

bool Asserts() {
    bool asked = false;
    b2Assert((asked = true));
    return asked;
}

// What b2Assert is, unless it is the game's own.
#undef assert
#define assert(A) FailAsAssert(assertion, "Box2D")

void Fails(const char *assertion) {
    (void)assertion;
    b2Assert(assertion == nullptr);
}

} // namespace stock
} // namespace bmr
