// SPDX-License-Identifier: MIT
#ifndef BMR_GEOMETRY_MEMORY_H
#define BMR_GEOMETRY_MEMORY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include "boomerang/allocator.h"

/// `size` > 0 bytes from the allocator, or from malloc when it is NULL.
static inline void *bmr_allocate(const bmr_allocator *allocator, size_t size) {
    return allocator ? allocator->allocate(allocator->context, size) : malloc(size);
}

static inline void bmr_release(const bmr_allocator *allocator, void *block, size_t size) {
    if (allocator)
        allocator->release(allocator->context, block, size);
    else
        free(block);
}

/// @file
/// Sizes that are made of a caller's counts. Where size_t has 32 bits, a few thousand bodies are enough to
/// wrap a product, and a block that is too small is then written past its end.

/// a * b, where that is a size_t; else false, and *product as it was.
static inline bool bmr_size_product(size_t a, size_t b, size_t *product) {
    if (b != 0 && a > SIZE_MAX / b)
        return false;
    *product = a * b;
    return true;
}

#endif
