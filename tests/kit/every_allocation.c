// SPDX-License-Identifier: MIT
#include "every_allocation.h"

/// No function needs nearly so many.
#define MOST_ALLOCATIONS 100000

void test_hash(uint64_t *bits, const void *bytes, size_t size) {
    const unsigned char *at = bytes;
    for (size_t i = 0; i < size; ++i)
        *bits = (*bits ^ at[i]) * UINT64_C(1099511628211);
}

const char *test_every_allocation(const test_attempt *attempt) {
    test_heap heap;
    test_heap_init(&heap, SIZE_MAX);
    uint64_t reference = TEST_HASH_START;
    if (attempt->run(&heap.allocator, &reference) != BMR_OK || reference == TEST_HASH_START)
        return "makes nothing with all the memory";
    const size_t asked = heap.asked;
    if (asked == 0)
        return "allocates nothing";
    if (heap.blocks != 0 || heap.wrong_sizes != 0)
        return "leaks, or gives back other sizes";
    for (size_t fail_at = 0; fail_at < asked && fail_at < MOST_ALLOCATIONS; ++fail_at) {
        test_heap_init(&heap, fail_at);
        uint64_t bits = TEST_HASH_START;
        const bmr_error error = attempt->run(&heap.allocator, &bits);
        if (error == BMR_ERROR_COUNT)
            return "writes an output without memory";
        if (error != BMR_ERROR_NO_MEMORY)
            return "does not say that there is no memory";
        if (heap.asked <= fail_at)
            return "stops before the allocation that is to fail";
        if (heap.blocks != 0 || heap.wrong_sizes != 0)
            return "leaks without memory, or gives back other sizes";
        heap.fail_at = SIZE_MAX;
        bits = TEST_HASH_START;
        if (attempt->run(&heap.allocator, &bits) != BMR_OK || bits != reference)
            return "makes something else at the second attempt";
        if (heap.blocks != 0 || heap.wrong_sizes != 0)
            return "leaks at the second attempt, or gives back other sizes";
    }
    return NULL;
}
