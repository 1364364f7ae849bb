// SPDX-License-Identifier: MIT
#ifndef BMR_GEOMETRY_MEMORY_H
#define BMR_GEOMETRY_MEMORY_H

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

#endif
