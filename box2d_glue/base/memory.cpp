// SPDX-License-Identifier: MIT
#include "base/memory.h"

#include <cstdio>
#include <cstdlib>

namespace bmr {

void *TakeMemory(void *block, std::size_t bytes) {
    void *const taken = std::realloc(block, bytes);
    if (taken == nullptr) {
        std::fputs("boomerang: there is no memory for a step of Box2D\n", stderr);
        std::abort();
    }
    return taken;
}

} // namespace bmr
