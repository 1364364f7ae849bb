// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_NUMBERS_H
#define BOOMERANG_TESTBED_NUMBERS_H

#include <cstdint>

namespace testbed {

/// The number that a stage, or a game of the tests, gave a body, a fixture or a joint; of a stage fixtures
/// count from 0 within their body.
template <typename Object> uint32_t NumberOf(const Object &object) {
    return static_cast<uint32_t>(const_cast<Object &>(object).GetUserData().pointer); // Box2D's is not const
}

} // namespace testbed

#endif
