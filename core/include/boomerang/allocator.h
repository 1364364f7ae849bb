// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_ALLOCATOR_H
#define BOOMERANG_ALLOCATOR_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Where core takes its memory from. Each object (polygon, hierarchy, compass table) is ONE block, so a
/// program can place it. A NULL `const bmr_allocator *` means malloc and free.
typedef struct bmr_allocator {
    /// Returns `size` bytes aligned for any type, or NULL. `size` is never 0.
    void *(*allocate)(void *context, size_t size);
    /// Takes back a block. `size` is the size that was asked for.
    void (*release)(void *context, void *block, size_t size);
    void *context;
} bmr_allocator;

#ifdef __cplusplus
}
#endif
#endif
