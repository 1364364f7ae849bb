// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_FAILING_ALLOCATOR_H
#define BMR_TEST_FAILING_ALLOCATOR_H

#include <stddef.h>
#include <stdlib.h>

#include "boomerang/allocator.h"

/// An allocator that fails on demand and keeps books.
typedef struct test_heap {
    bmr_allocator allocator; ///< hand this to core
    size_t fail_at;          ///< the number, from 0, of the allocation that fails; SIZE_MAX: none
    size_t asked;            ///< allocations so far, failed ones too
    size_t blocks;           ///< blocks out now
    size_t bytes;            ///< bytes out now
    size_t wrong_sizes;      ///< blocks that came back with another size than they were asked with
} test_heap;

/// Before each block: its size, in as many bytes as keep the block aligned for any type.
typedef union test_heap_header {
    size_t size;
    max_align_t alignment;
} test_heap_header;

static inline void *test_heap_allocate(void *context, size_t size) {
    test_heap *heap = (test_heap *)context;
    if (heap->asked++ == heap->fail_at)
        return NULL;
    test_heap_header *block = (test_heap_header *)malloc(sizeof *block + size);
    if (!block)
        return NULL;
    block->size = size;
    ++heap->blocks;
    heap->bytes += size;
    return block + 1;
}

static inline void test_heap_release(void *context, void *memory, size_t size) {
    test_heap *heap = (test_heap *)context;
    test_heap_header *block = (test_heap_header *)memory - 1;
    heap->wrong_sizes += block->size != size ? 1 : 0;
    --heap->blocks;
    heap->bytes -= block->size;
    free(block);
}

/// In place: the allocator's context is the heap's own address.
static inline void test_heap_init(test_heap *heap, size_t fail_at) {
    const test_heap fresh = {{test_heap_allocate, test_heap_release, heap}, fail_at, 0, 0, 0, 0};
    *heap = fresh;
}

#endif
