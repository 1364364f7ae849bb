// SPDX-License-Identifier: MIT
#include "run_allocator.h"

#include <algorithm>
#include <cstdint>

#include <box2d/b2_block_allocator.h>

namespace bmr {

namespace {

constexpr size_t kBlock = 640; // the allocator's largest class
// A fresh chunk is one run of 25 blocks. What is handed out before a fresh chunk is opened is what was freed
// earlier, in any order: this many blocks are looked at before giving up.
constexpr int kMostTries = 64;

size_t BlocksFor(size_t bytes) {
    return (bytes + kBlock - 1) / kBlock;
}

} // namespace

void *AllocateRun(b2BlockAllocator *allocator, size_t bytes) {
    if (bytes <= kBlock)
        return allocator->Allocate(static_cast<int32>(bytes));
    if (bytes > kLongestRun)
        return nullptr;
    const size_t wanted = BlocksFor(bytes);
    uintptr_t blocks[kMostTries];
    int count = 0;
    uintptr_t run = 0;
    while (run == 0 && count < kMostTries) {
        blocks[count++] = reinterpret_cast<uintptr_t>(allocator->Allocate(static_cast<int32>(kBlock)));
        std::inplace_merge(blocks, blocks + count - 1, blocks + count); // sorted by insertion
        size_t length = 1;
        for (int i = 1; i < count && run == 0; ++i) {
            length = blocks[i] == blocks[i - 1] + kBlock ? length + 1 : 1;
            if (length == wanted)
                run = blocks[i] - (wanted - 1) * kBlock;
        }
    }
    for (int i = count; i-- > 0;) {
        if (run == 0 || blocks[i] < run || blocks[i] >= run + wanted * kBlock)
            allocator->Free(reinterpret_cast<void *>(blocks[i]), static_cast<int32>(kBlock));
    }
    return reinterpret_cast<void *>(run);
}

void FreeRun(b2BlockAllocator *allocator, void *run, size_t bytes) {
    if (run == nullptr)
        return;
    if (bytes <= kBlock) {
        allocator->Free(run, static_cast<int32>(bytes));
        return;
    }
    char *block = static_cast<char *>(run);
    // Last block first: the free list then hands them out in order again, and the next run is found at once.
    for (size_t i = BlocksFor(bytes); i-- > 0;)
        allocator->Free(block + i * kBlock, static_cast<int32>(kBlock));
}

bmr_allocator RunAllocator(b2BlockAllocator *allocator) {
    bmr_allocator interface;
    interface.allocate = [](void *context, size_t size) {
        return AllocateRun(static_cast<b2BlockAllocator *>(context), size);
    };
    interface.release = [](void *context, void *block, size_t size) {
        FreeRun(static_cast<b2BlockAllocator *>(context), block, size);
    };
    interface.context = allocator;
    return interface;
}

} // namespace bmr
