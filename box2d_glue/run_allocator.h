// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_RUN_ALLOCATOR_H
#define BOOMERANG_GLUE_RUN_ALLOCATOR_H

#include <cstddef>

#include "boomerang/allocator.h"

class b2BlockAllocator;

namespace bmr {

/// Blocks of up to kLongestRun bytes out of a world's own block allocator.
///
/// A world's death frees its block allocator and tells nobody; what lives in it cannot leak. But the
/// allocator's largest block has 640 bytes (more goes to malloc, and would leak). It cuts its chunks into
/// neighbouring blocks, though, so a run of them is found by asking for blocks until enough of them lie side
/// by side; the others are given back.
constexpr size_t kLongestRun = 25 * 640;

/// nullptr if `bytes` is too long, or if no run came up in a bounded number of tries.
void *AllocateRun(b2BlockAllocator *allocator, size_t bytes);
void FreeRun(b2BlockAllocator *allocator, void *run, size_t bytes);

/// The same as core's allocator interface.
bmr_allocator RunAllocator(b2BlockAllocator *allocator);

} // namespace bmr

#endif
