// SPDX-License-Identifier: MIT
#include "start/box2d_asserts.h"

#include <atomic>
#include <cassert>
#include <cstdio>
#include <cstdlib>

#include "base/compiler.h"

#if defined(__GLIBC__) && defined(NDEBUG) // as <cassert> has it
extern "C" [[noreturn]] void __assert_fail(const char *, const char *, unsigned, const char *) noexcept;
#endif

namespace bmr {

namespace {

std::atomic<bool> box2dAsserts{false};
std::atomic<void (*)(const char *)> box2dFails{nullptr};

} // namespace

bool Box2DAsserts() {
    return box2dAsserts.load(std::memory_order_relaxed);
}

void SetBox2DAsserts(bool asserts) {
    box2dAsserts.store(asserts, std::memory_order_relaxed);
}

void SetBox2DFails(void (*fails)(const char *assertion)) {
    box2dFails.store(fails, std::memory_order_relaxed);
}

BMR_COLD void FailAsBox2D(const char *assertion, const char *function) {
    const auto fails = box2dFails.load(std::memory_order_relaxed);
    if (fails == nullptr)
        FailAsAssert(assertion, function);
    fails(assertion);
}

BMR_COLD void FailAsAssert(const char *assertion, const char *function) {
#if defined(__GLIBC__)
    __assert_fail(assertion, "Box2D", 0, function);
#endif
    std::fprintf(stderr, "Box2D, in boomerang's %s: Assertion `%s' failed.\n", function, assertion);
    std::fflush(stderr);
    std::abort();
}

} // namespace bmr
