// SPDX-License-Identifier: MIT
// Box2D cuts its small blocks out of chunks of 16 KB. Here each of them is overwritten as it is freed and as
// it is handed out, with the byte BMR_ACTOR_POISON: what a world reads of a block that is gone, or that
// nothing was written to, is another in two runs of two bytes. Of a program under the address sanitizer such
// a block is poisoned from when it is freed until it is handed out again, and beyond the bytes that were
// asked for.
//
// These stand in front of Box2D's functions, preloaded or in the program. A block that was never handed out
// is as it is. Where they are preloaded, what Box2D's stack allocator hands out is overwritten, too: a step's
// own arrays.
#include "plugin.h"

#include <cstdlib>
#include <cstring>

#include <box2d/b2_block_allocator.h>
#include <box2d/b2_stack_allocator.h>
#include <dlfcn.h>
#if defined(BOOMERANG_FUZZ_POISON)
#    include <sanitizer/asan_interface.h>
#endif

namespace {

constexpr int32 kBlockSizes[] = {16, 32, 64, 96, 128, 160, 192, 224, 256, 320, 384, 448, 512, 640};
constexpr int32 kLargest = 640;

int32 BlockOf(int32 size) {
    for (const int32 block : kBlockSizes)
        if (size <= block)
            return block;
    return size;
}

template <typename Function> Function *Real(const char *mangled) {
    return reinterpret_cast<Function *>(dlsym(RTLD_NEXT, mangled));
}

const void *lastFreed;

} // namespace

namespace actor {

const void *LastFreed() {
    return lastFreed;
}

} // namespace actor

#if defined(BOOMERANG_FUZZ_POISON)
namespace {
void HandOut(void *memory, int32 size) {
    __asan_unpoison_memory_region(memory, static_cast<size_t>(size));
    __asan_poison_memory_region(static_cast<char *>(memory) + size,
                                static_cast<size_t>(BlockOf(size) - size));
}
void TakeBack(void *memory, int32 size) {
    __asan_poison_memory_region(memory, static_cast<size_t>(BlockOf(size)));
}
} // namespace
#else
namespace {
int Byte() {
    static const char *const given = std::getenv("BMR_ACTOR_POISON");
    return given != nullptr ? std::atoi(given) : 0xa5;
}
void HandOut(void *memory, int32 size) {
    std::memset(memory, Byte(), static_cast<size_t>(size));
}
/// Box2D keeps the next free block in the first bytes.
void TakeBack(void *memory, int32 size) {
    std::memset(static_cast<char *>(memory) + sizeof(void *), Byte(),
                static_cast<size_t>(BlockOf(size)) - sizeof(void *));
}
} // namespace

void *b2StackAllocator::Allocate(int32 size) {
    static auto *const real = Real<void *(b2StackAllocator *, int32)>("_ZN16b2StackAllocator8AllocateEi");
    void *memory = real(this, size);
    HandOut(memory, size);
    return memory;
}
#endif

void *b2BlockAllocator::Allocate(int32 size) {
    static auto *const real = Real<void *(b2BlockAllocator *, int32)>("_ZN16b2BlockAllocator8AllocateEi");
    void *memory = real(this, size);
    if (memory != nullptr && size > 0 && size <= kLargest)
        HandOut(memory, size);
    if (lastFreed == memory)
        lastFreed = nullptr;
    return memory;
}

void b2BlockAllocator::Free(void *memory, int32 size) {
    static auto *const real = Real<void(b2BlockAllocator *, void *, int32)>("_ZN16b2BlockAllocator4FreeEPvi");
    real(this, memory, size);
    if (memory == nullptr || size == 0 || size > kLargest)
        return;
    TakeBack(memory, size);
    lastFreed = memory;
}
