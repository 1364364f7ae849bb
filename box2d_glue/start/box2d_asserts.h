// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_BOX2D_ASSERTS_H
#define BOOMERANG_GLUE_BOX2D_ASSERTS_H

namespace bmr {

/// Was this process's Box2D compiled with its assertions? Until it is set: no.
bool Box2DAsserts();
/// Set by who knows how Box2D was compiled, ahead of Install.
void SetBox2DAsserts(bool asserts);

/// Ends the process as Box2D's b2Assert does.
[[noreturn]] void FailAsBox2D(const char *assertion, const char *function);

} // namespace bmr

/// Box2D's assertion at this place. Ends the process if it does not hold and Box2D's assertions are on.
/// `assertion`: the words that Box2D's own ends with.
#define BMR_BOX2D_ASSERTS(condition, assertion)                                                              \
    do {                                                                                                     \
        if (!(condition) && ::bmr::Box2DAsserts())                                                           \
            ::bmr::FailAsBox2D(assertion, __func__);                                                         \
    } while (false)

#endif
