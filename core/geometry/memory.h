// SPDX-License-Identifier: MIT
#ifndef BMR_GEOMETRY_MEMORY_H
#define BMR_GEOMETRY_MEMORY_H

#include <stdbool.h>
#include <stddef.h>
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
/// wrap a product, and a block that is too small is then written past its end. So no such product or sum is
/// taken without its limit: SIZE_MAX in the library, 2^32 - 1 in the tests.

/// a * b, where that is at most `limit`; else false, and *product as it was.
static inline bool bmr_size_product(size_t a, size_t b, size_t limit, size_t *product) {
    if (b != 0 && a > limit / b)
        return false;
    *product = a * b;
    return true;
}

/// Adds an array of `count` elements of `each` bytes to a block of *bytes, at the next multiple of
/// `alignment` (a power of 2), and says where it begins. False where the block would be larger than `limit`:
/// then *bytes and *begin are as they were.
static inline bool bmr_size_add(size_t *bytes, size_t count, size_t each, size_t alignment, size_t limit,
                                size_t *begin) {
    const size_t gap = (alignment - *bytes % alignment) % alignment;
    size_t size;
    if (*bytes > limit || gap > limit - *bytes || !bmr_size_product(count, each, limit, &size) ||
        size > limit - *bytes - gap)
        return false;
    *begin = *bytes + gap;
    *bytes = *begin + size;
    return true;
}

#endif
