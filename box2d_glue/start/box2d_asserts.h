// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_BOX2D_ASSERTS_H
#define BOOMERANG_GLUE_BOX2D_ASSERTS_H

namespace bmr {

/// Was this process's Box2D compiled with its assertions? Until it is set: no.
bool Box2DAsserts();
/// Set by who knows how Box2D was compiled, ahead of Install.
void SetBox2DAsserts(bool asserts);
/// Likewise: what b2Assert does, where a game may have its own. It may throw, or return.
void SetBox2DFails(void (*fails)(const char *assertion));

/// What Box2D's b2Assert does. Unless it is the game's own, that ends the process.
void FailAsBox2D(const char *assertion, const char *function);
/// As assert does.
[[noreturn]] void FailAsAssert(const char *assertion, const char *function);

} // namespace bmr

/// Box2D's assertion at this place. It fails if it does not hold and Box2D's assertions are on.
/// `assertion`: the words that Box2D's own ends with.
#define BMR_BOX2D_ASSERTS(condition, assertion)                                                              \
    do {                                                                                                     \
        if (!(condition) && ::bmr::Box2DAsserts())                                                           \
            ::bmr::FailAsBox2D(assertion, __func__);                                                         \
    } while (false)

#endif
