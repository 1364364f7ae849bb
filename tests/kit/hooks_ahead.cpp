// SPDX-License-Identifier: MIT
// What the hooks ask of the library that they are in, where they are in a test's own program: it starts when
// the test calls bmr::Install, and there is one Box2D.
#include "boomerang/box2d.h"
#include "hooks/start.h"
#include "start/install.h"

namespace bmr {

std::atomic<bool> internal::startsByItself{false};

void internal::StartNow() {}

bool internal::MeetBox2D(const void *) {
    return true;
}

namespace {
[[maybe_unused]] const bool wayIsSet = (SetWay("ahead of Box2D", nullptr), true);
} // namespace

} // namespace bmr
