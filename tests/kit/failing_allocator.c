// SPDX-License-Identifier: MIT
#include "failing_allocator.h"

#include <stdlib.h>

/// Before each block: its size, in as many bytes as keep the block aligned for any type.
typedef union header {
    size_t size;
    max_align_t alignment;
} header;

static void *heap_allocate(void *context, size_t size) {
    test_heap *heap = context;
    if (heap->asked++ == heap->fail_at)
        return NULL;
    header *block = malloc(sizeof *block + size);
    if (!block)
        return NULL;
    block->size = size;
    ++heap->blocks;
    heap->bytes += size;
    return block + 1;
}

static void heap_release(void *context, void *memory, size_t size) {
    test_heap *heap = context;
    header *block = (header *)memory - 1;
    heap->wrong_sizes += block->size != size;
    --heap->blocks;
    heap->bytes -= block->size;
    free(block);
}

void test_heap_init(test_heap *heap, size_t fail_at) {
    const test_heap fresh = {{heap_allocate, heap_release, heap}, fail_at, 0, 0, 0, 0};
    *heap = fresh;
}
