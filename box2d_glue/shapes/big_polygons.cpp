// SPDX-License-Identifier: MIT
#include "shapes/big_polygons.h"

#include <algorithm>

#include "start/install.h"

namespace bmr {

std::atomic<bool> internal::anyBigPolygon{false};
std::atomic<const void *> internal::convexShapeTable{nullptr};

namespace registry {

std::atomic<Entry *> internal::chunks[kMostChunks] = {};

namespace {

constexpr uint32_t kChunkSize = 1u << kChunkBits;
/// Odd, so that no two serial numbers of the 2^40 give one product: a number is unlike what stands in memory
/// by chance.
constexpr uint64_t kScatter = 0x9e3779b97f4a7c15u;

// Guarded by HoldsProcessLock.
Handle firstFree = 0;
Handle firstUnused = 1;
uint64_t made = 0;
size_t count = 0;
const bmr_allocator *allocator = nullptr;

/// All vertices, or as many as leave the shape room for its handle.
Shown ShownOf(const bmr_convex32 &polygon) {
    Shown shown = {std::min<uint32_t>(kMostShown, polygon.count), {}}; // a piece of an outline may have less
    uint32_t inner[kMostShown];
    bmr_convex32_inner(&polygon, inner, shown.count);
    for (uint32_t i = 0; i < shown.count; ++i)
        shown.vertices[i] = polygon.vertices[inner[i]];
    return shown;
}

/// A handle that is not in use; 0 without memory.
Handle TakeHandle() {
    if (firstFree != 0) {
        const Handle handle = firstFree;
        firstFree = Find(handle).nextFree;
        return handle;
    }
    const uint32_t chunk = firstUnused >> kChunkBits;
    if (chunk == kMostChunks)
        return 0;
    if (internal::chunks[chunk].load(std::memory_order_relaxed) == nullptr) {
        void *memory = bmr_allocate(allocator, kChunkSize * sizeof(Entry));
        if (memory == nullptr)
            return 0;
        auto *entries = static_cast<Entry *>(memory);
        for (uint32_t i = 0; i < kChunkSize; ++i)
            new (entries + i) Entry{};
        internal::chunks[chunk].store(entries, std::memory_order_release);
    }
    return firstUnused++;
}

} // namespace

Handle Add(bmr_convex32_block *block, Group *group) {
    const HoldsProcessLock lock;
    const Handle handle = TakeHandle();
    if (handle == 0)
        return 0;
    Entry &entry = Find(handle);
    entry.references.store(group == nullptr ? 1 : 0, std::memory_order_relaxed);
    entry.group.store(group, std::memory_order_relaxed);
    entry.block.store(block, std::memory_order_relaxed);
    entry.shown = ShownOf(block->polygon);
    entry.number.store((++made * kScatter) << kHandleBits | handle, std::memory_order_release);
    ++count;
    bmr::internal::anyBigPolygon.store(true, std::memory_order_relaxed);
    return handle;
}

void Remove(Handle handle) {
    Entry &entry = Find(handle);
    entry.number.store(0, std::memory_order_relaxed);
    bmr_convex32_destroy(entry.block.load(std::memory_order_relaxed), GetAllocator());
    const HoldsProcessLock lock;
    entry.nextFree = firstFree;
    firstFree = handle;
    --count;
}

void Release(Handle handle) {
    if (handle == 0)
        return;
    Entry &entry = Find(handle);
    if (Group *const group = entry.group.load(std::memory_order_relaxed))
        return ReleaseGroup(group);
    // What others did with the polygon comes before its end.
    if (entry.references.fetch_sub(1, std::memory_order_acq_rel) == 1)
        Remove(handle);
}

void ReleaseGroup(Group *group) {
    if (group->references.fetch_sub(1, std::memory_order_acq_rel) == 1)
        group->end(group);
}

void SetAllocator(const bmr_allocator *newAllocator) {
    const HoldsProcessLock lock;
    allocator = newAllocator;
}

const bmr_allocator *GetAllocator() {
    const HoldsProcessLock lock;
    return allocator;
}

size_t Count() {
    const HoldsProcessLock lock;
    return count;
}

} // namespace registry

const bmr_convex32_block *BigPolygonOf(const b2Shape &shape) {
    const uint32_t handle = internal::ConvexShapeAccess::HandleOf(shape);
    return handle != 0 ? &registry::BlockOf(handle) : nullptr;
}

uint64_t NumberOfBigPolygon(const b2Shape &shape) {
    const uint32_t handle = internal::ConvexShapeAccess::HandleOf(shape);
    return handle != 0 ? registry::Find(handle).number.load(std::memory_order_relaxed) : 0;
}

const bmr_convex32_block *BigPolygonOfNumber(uint64_t number) {
    const registry::Entry *entry = registry::FindNumber(number);
    return entry != nullptr ? entry->block.load(std::memory_order_relaxed) : nullptr;
}

} // namespace bmr
