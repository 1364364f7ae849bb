// SPDX-License-Identifier: MIT
// What is otherwise in a program that links Box2D statically: the linker's --wrap has led every call from
// another object file here, nothing was preloaded, and Box2D's own functions have the names __real_.
#include <cstdlib>
#include <cstring>

#include "boomerang/box2d.h"
#include "reach/library_check.h"
#include "reach/real.h"
#include "start.h"

#define BMR_WRAPPED(name) extern "C" void __real_##name();
#include "wrapped_symbols.inc"
#undef BMR_WRAPPED

namespace bmr {

namespace {

struct Wrapped {
    const char *name;
    void (*real)();
};

constexpr Wrapped kWrapped[] = {
#define BMR_WRAPPED(name) {#name, __real_##name},
#include "wrapped_symbols.inc"
#undef BMR_WRAPPED
};

} // namespace

void *FindReal(const char *mangled) {
    for (const Wrapped &wrapped : kWrapped)
        if (std::strcmp(wrapped.name, mangled) == 0)
            return reinterpret_cast<void *>(wrapped.real);
    std::abort(); // a hook that CMake has not wrapped: the tests would have seen it
}

bool StepsComeByHere() {
    return true;
}

bool AnyBox2DBehind() {
    return true;
}

bool InitialiseBox2D() {
    return false; // never asked: steps come by
}

bool internal::MeetBox2D(const void *) {
    return true; // there is one, and it is linked with this
}

bool IsPreloaded() {
    return false;
}

const char *WhyLibraryIsUnknown() {
    return nullptr;
}

} // namespace bmr
