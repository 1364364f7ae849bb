// SPDX-License-Identifier: MIT
// Box2D cuts its small blocks out of chunks of 16 KB, which the sanitizer sees as one. Here every block is
// poisoned from when it is freed until it is handed out again, and beyond the bytes that were asked for: what
// the glue reads of a contact that is gone, or past one, is seen. (Box2D's own code is not instrumented.)
//
// These stand in front of Box2D's functions, as the hooks of the plugin do. A block that was never handed out
// is not poisoned; nor is what Box2D's stack allocator frees, for it is told no sizes, and the glue has
// nothing from it.
#include <box2d/b2_block_allocator.h>

#include <dlfcn.h>
#include <sanitizer/asan_interface.h>

#include "poison.h"

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

namespace fuzz {

const void *LastFreed() {
    return lastFreed;
}

} // namespace fuzz

void *b2BlockAllocator::Allocate(int32 size) {
    static auto *const real = Real<void *(b2BlockAllocator *, int32)>("_ZN16b2BlockAllocator8AllocateEi");
    void *memory = real(this, size);
    if (memory != nullptr && size <= kLargest) {
        __asan_unpoison_memory_region(memory, static_cast<size_t>(size));
        __asan_poison_memory_region(static_cast<char *>(memory) + size,
                                    static_cast<size_t>(BlockOf(size) - size));
    }
    if (lastFreed == memory)
        lastFreed = nullptr;
    return memory;
}

void b2BlockAllocator::Free(void *memory, int32 size) {
    static auto *const real = Real<void(b2BlockAllocator *, void *, int32)>("_ZN16b2BlockAllocator4FreeEPvi");
    real(this, memory, size);
    if (memory == nullptr || size == 0 || size > kLargest)
        return;
    __asan_poison_memory_region(memory, static_cast<size_t>(BlockOf(size)));
    lastFreed = memory;
}
