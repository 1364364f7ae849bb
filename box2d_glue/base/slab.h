// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_SLAB_H
#define BOOMERANG_GLUE_SLAB_H

#include <cstddef>

#include "boomerang/allocator.h"

class b2BlockAllocator;

namespace bmr {

/// A piece of a world's own block allocator, handed out from front to back and freed as a whole.
///
/// When a world ends it frees its block allocator without a call that we could see; a slab in it cannot leak.
/// But the allocator's largest block has 640 bytes (more goes to malloc, and would leak). It cuts chunks of
/// 16 KB into 25 such neighbours, though, so a slab of more is a run of 5, 10, ... 25 of them: such sizes
/// leave no odd blocks behind, and as runs are given back in order, the next one is found at once.
struct Slab {
    char *memory; ///< nullptr: none
    size_t size, used;
};

/// A slab of at least `bytes`; without memory if that is over 16,000 or if no run came up in a bounded number
/// of tries.
Slab AllocateSlab(b2BlockAllocator *allocator, size_t bytes);
void FreeSlab(b2BlockAllocator *allocator, Slab *slab);

/// The next `bytes` of the slab, aligned for any type; nullptr where it is full.
void *TakeFromSlab(Slab *slab, size_t bytes);
/// The same as core's allocator interface; releasing does nothing.
bmr_allocator SlabAllocator(Slab *slab);

} // namespace bmr

#endif
