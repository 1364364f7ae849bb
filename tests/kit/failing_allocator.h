// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_FAILING_ALLOCATOR_H
#define BMR_TEST_FAILING_ALLOCATOR_H

#include "boomerang/allocator.h"

#ifdef __cplusplus
extern "C" {
#endif

/// An allocator that fails on demand and keeps books.
typedef struct test_heap {
    bmr_allocator allocator; ///< hand this to core
    size_t fail_at;          ///< the number, from 0, of the allocation that fails; SIZE_MAX: none
    size_t asked;            ///< allocations so far, failed ones too
    size_t blocks;           ///< blocks out now
    size_t bytes;            ///< bytes out now
    size_t wrong_sizes;      ///< blocks that came back with another size than they were asked with
} test_heap;

/// In place: the allocator's context is the heap's own address.
void test_heap_init(test_heap *heap, size_t fail_at);

#ifdef __cplusplus
}
#endif
#endif
