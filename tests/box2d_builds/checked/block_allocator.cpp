// SPDX-License-Identifier: MIT
// Box2D's allocator of small blocks, with each block from malloc and given back to it, so that the address
// sanitizer sees who uses a contact or a body that is gone. Box2D's own keeps such memory readable.
#include <cstdlib>

#include <box2d/b2_block_allocator.h>

b2BlockAllocator::b2BlockAllocator() : m_chunks(nullptr), m_chunkCount(0), m_chunkSpace(0) {}
b2BlockAllocator::~b2BlockAllocator() = default; // what a world still has when it ends is not looked for

void *b2BlockAllocator::Allocate(int32 size) {
    return size == 0 ? nullptr : std::malloc(static_cast<std::size_t>(size));
}

void b2BlockAllocator::Free(void *memory, int32) {
    std::free(memory);
}

void b2BlockAllocator::Clear() {}
