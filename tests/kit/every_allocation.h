// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_EVERY_ALLOCATION_H
#define BMR_TEST_EVERY_ALLOCATION_H

#include <stdint.h>

#include "boomerang/error.h"
#include "failing_allocator.h"

#ifdef __cplusplus
extern "C" {
#endif

/// One public function that allocates.
typedef struct test_attempt {
    const char *name;
    /// Calls it with this allocator and gives back its error. Where there is none, `*bits` becomes a hash of
    /// what was made, which is destroyed; where there is one, BMR_ERROR_COUNT for an output that was written.
    bmr_error (*run)(const bmr_allocator *allocator, uint64_t *bits);
} test_attempt;

/// Lets allocation 0, 1, 2, ... fail until none is left to fail: each time NO_MEMORY comes back, nothing is
/// out, and the same call once more, with memory, makes the same bits. NULL, or what is wrong.
const char *test_every_allocation(const test_attempt *attempt);

/// FNV-1a of some bytes, put to `*bits`.
void test_hash(uint64_t *bits, const void *bytes, size_t size);
#define TEST_HASH_START UINT64_C(14695981039346656037)

#ifdef __cplusplus
}
#endif
#endif
