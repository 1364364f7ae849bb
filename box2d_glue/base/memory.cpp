// SPDX-License-Identifier: MIT
#include "base/memory.h"

#include <cstdio>
#include <cstdlib>

namespace bmr {

void *TakeMemory(void *block, std::size_t bytes) {
    void *const taken = std::realloc(block, bytes);
    if (taken == nullptr)
        EndWithoutMemory();
    return taken;
}

void EndWithoutMemory() {
    std::fputs("boomerang: there is no memory\n", stderr);
    std::abort();
}

} // namespace bmr
