// SPDX-License-Identifier: MIT
#include "base/slab.h"

#include <algorithm>

#include <box2d/b2_block_allocator.h>

namespace bmr {

namespace {

constexpr size_t kBlock = 640;  // the allocator's largest class
constexpr size_t kSingle = 512; // up to here one block of a smaller class does
constexpr size_t kRunStep = 5;  // runs are multiples of this many blocks, which divides the 25 of a chunk
constexpr size_t kLongRun = 25; // a whole chunk
constexpr size_t kAlignment = 16;
// Box2D's own blocks of this class (proxies of chains) can break runs; so many are looked at before giving
// up.
constexpr size_t kMostTries = 1024;

size_t RunFor(size_t bytes) {
    return (bytes + kRunStep * kBlock - 1) / (kRunStep * kBlock) * kRunStep;
}

/// `wanted` neighbouring blocks: the first `wanted` that the allocator hands out in a row of rising
/// addresses.
char *AllocateRun(b2BlockAllocator *allocator, size_t wanted) {
    char *blocks[kMostTries];
    size_t count = 0, length = 0;
    do {
        blocks[count] = static_cast<char *>(allocator->Allocate(static_cast<int32>(kBlock)));
        length = count > 0 && blocks[count] == blocks[count - 1] + kBlock ? length + 1 : 1;
        ++count;
    } while (length < wanted && count < kMostTries);
    char *const run = length < wanted ? nullptr : blocks[count - length];
    // Last out, first back: the order is kept.
    for (size_t i = run != nullptr ? count - length : count; i-- > 0;)
        allocator->Free(blocks[i], static_cast<int32>(kBlock));
    return run;
}

} // namespace

Slab AllocateSlab(b2BlockAllocator *allocator, size_t bytes) {
    Slab slab = {nullptr, 0, 0};
    if (bytes <= kSingle) {
        slab.size = std::max(bytes, kAlignment);
        slab.memory = static_cast<char *>(allocator->Allocate(static_cast<int32>(slab.size)));
    } else if (bytes <= kLongRun * kBlock) {
        slab.size = RunFor(bytes) * kBlock;
        slab.memory = AllocateRun(allocator, RunFor(bytes));
    }
    return slab;
}

void FreeSlab(b2BlockAllocator *allocator, Slab *slab) {
    if (slab->memory == nullptr)
        return;
    if (slab->size <= kSingle) {
        allocator->Free(slab->memory, static_cast<int32>(slab->size));
    } else {
        for (size_t i = slab->size / kBlock; i-- > 0;) // the first block comes out first again
            allocator->Free(slab->memory + i * kBlock, static_cast<int32>(kBlock));
    }
    *slab = {nullptr, 0, 0};
}

void *TakeFromSlab(Slab *slab, size_t bytes) {
    const size_t rounded = (bytes + kAlignment - 1) / kAlignment * kAlignment;
    if (slab->memory == nullptr || rounded > slab->size - slab->used)
        return nullptr;
    void *taken = slab->memory + slab->used;
    slab->used += rounded;
    return taken;
}

bmr_allocator SlabAllocator(Slab *slab) {
    bmr_allocator interface;
    interface.allocate = [](void *context, size_t size) {
        return TakeFromSlab(static_cast<Slab *>(context), size);
    };
    interface.release = [](void *, void *, size_t) {};
    interface.context = slab;
    return interface;
}

} // namespace bmr
