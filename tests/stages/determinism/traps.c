// SPDX-License-Identifier: MIT
// Preloaded: an operation without a result that is a number, a division by zero, or a result too large ends
// the process (SIGFPE), as some games have it in their debug builds.
#define _GNU_SOURCE
#include <fenv.h>

__attribute__((constructor)) static void set_traps(void) {
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
}
