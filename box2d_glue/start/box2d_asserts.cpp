// SPDX-License-Identifier: MIT
#include "start/box2d_asserts.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>

#include "start/compiler.h"

namespace bmr {

namespace {

std::atomic<bool> box2dAsserts{false};

} // namespace

bool Box2DAsserts() {
    return box2dAsserts.load(std::memory_order_relaxed);
}

void SetBox2DAsserts(bool asserts) {
    box2dAsserts.store(asserts, std::memory_order_relaxed);
}

BMR_COLD void FailAsBox2D(const char *assertion, const char *function) {
    std::fprintf(stderr, "Box2D, in boomerang's %s: Assertion `%s' failed.\n", function, assertion);
    std::fflush(stderr);
    std::abort();
}

} // namespace bmr
