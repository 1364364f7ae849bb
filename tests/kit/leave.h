// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_LEAVE_H
#define BOOMERANG_TEST_LEAVE_H

#include <unistd.h>

#ifdef __cplusplus
extern "C" {
#endif

// Of the compiler's runtime, where the lines that run are counted; nowhere else.
int __llvm_profile_write_file(void) __attribute__((weak));

/// Ends a forked child as _exit does, without its parent's exit handlers; but what it ran is written down.
__attribute__((noreturn)) static inline void test_leave(int status) {
    if (__llvm_profile_write_file)
        __llvm_profile_write_file();
    _exit(status);
}

#ifdef __cplusplus
}
#endif
#endif
