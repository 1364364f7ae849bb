// SPDX-License-Identifier: MIT
#include "real.h"

#include <cstdio>
#include <cstdlib>

#include <dlfcn.h>

void *bmr::FindReal(const char *mangled) {
    void *found = dlsym(RTLD_NEXT, mangled);
    if (found == nullptr) {
        std::fprintf(stderr, "boomerang: %s is called, but no library behind this one has it\n", mangled);
        std::abort();
    }
    return found;
}
