// SPDX-License-Identifier: MIT
// See names.h.
#define b2TimeOfImpact BmrStockTimeOfImpact
#include BMR_BOX2D_SOURCE
#undef b2TimeOfImpact

namespace bmr {

[[noreturn]] void FailAsAssert(const char *assertion, const char *function);

namespace stock {

void TimeOfImpact(b2TOIOutput *output, const b2TOIInput *input);
bool Asserts();
void Fails(const char *assertion);

void TimeOfImpact(b2TOIOutput *output, const b2TOIInput *input) {
    BmrStockTimeOfImpact(output, input);
}

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
