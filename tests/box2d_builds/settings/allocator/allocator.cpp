// SPDX-License-Identifier: MIT
// The memory of the Box2D that has an allocator of its own; compiled into its library.
#include <cstdio>
#include <cstdlib>

#include <box2d/b2_settings.h>

namespace {

/// Before each block. 16 bytes: what Box2D gets is aligned as malloc's is.
struct alignas(16) Header {
    unsigned long long mark;
};
constexpr unsigned long long kInUse = 0x626f783264206f6eu, kFreed = 0x626f783264206f66u;

} // namespace

unsigned long box2dBlocks = 0;

void *b2AllocOwn(int32 size) {
    Header *header = static_cast<Header *>(std::malloc(sizeof(Header) + static_cast<std::size_t>(size)));
    if (header == nullptr)
        std::abort();
    header->mark = kInUse;
    ++box2dBlocks;
    return header + 1;
}

void b2FreeOwn(void *memory) {
    if (memory == nullptr)
        return;
    Header *header = static_cast<Header *>(memory) - 1;
    if (header->mark != kInUse) {
        std::fprintf(stderr, "b2Free: a block that is not b2Alloc's\n");
        std::abort();
    }
    header->mark = kFreed;
    std::free(header);
}
