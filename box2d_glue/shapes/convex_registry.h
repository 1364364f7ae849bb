// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CONVEX_REGISTRY_H
#define BOOMERANG_GLUE_CONVEX_REGISTRY_H

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <box2d/b2_polygon_shape.h>

#include "boomerang/allocator.h"
#include "convex32/convex32.h"

/// @file
/// The big polygons of the process, by handle. A shape has 4 bytes to spare, too few for a pointer.
///
/// Entries lie in chunks that never move and are never freed, so reading needs no lock: each shape has a
/// reference, and a thread that got the shape from another thread sees what that thread wrote before. Making
/// and freeing a polygon takes a lock, copying a reference does not. Everything is initialised at compile
/// time and never destroyed: shapes may be made before and freed after this file's statics would.

namespace bmr::registry {

/// 0 is no polygon.
using Handle = uint32_t;

/// 4096 polygons a chunk, 16 million polygons in all.
constexpr uint32_t kChunkBits = 12;
constexpr uint32_t kMostChunks = 4096;
/// Of a number, the bits that are the handle.
constexpr uint32_t kHandleBits = 24;
static_assert(uint64_t{kMostChunks} << kChunkBits == uint64_t{1} << kHandleBits);

/// Polygons that live and die together, as the pieces of an outline do: a reference to one of them is a
/// reference to all.
struct Group {
    std::atomic<size_t> references;
    /// Called with the last reference: removes its polygons and itself.
    void (*end)(Group *group);
};

/// The vertices that the shapes of a polygon show to Box2D's own code: some of the polygon's,
/// counter-clockwise. A shape that shows others was changed in place.
struct Shown {
    uint32_t count;
    bmr_vec32 vertices[b2_maxPolygonVertices];

    bool IsOf(const b2PolygonShape &shape) const {
        if (static_cast<uint32_t>(shape.m_count) != count)
            return false;
        const void *const ours = vertices, *const theirs = shape.m_vertices;
        // Nearly always there are as many as can be: a size that compilers know.
        return count == b2_maxPolygonVertices ? std::memcmp(ours, theirs, sizeof vertices) == 0
                                              : std::memcmp(ours, theirs, count * sizeof *vertices) == 0;
    }
};

struct Entry {
    /// No more than there are shapes, and each has its own bytes: cannot overflow. Of a polygon in a group
    /// the group counts instead.
    std::atomic<size_t> references;
    std::atomic<Group *> group; ///< nullptr: it lives by itself
    std::atomic<bmr_convex32_block *> block;
    Shown shown; ///< never written while a shape has the polygon
    /// 0 where the entry is free. In the low bits the handle.
    std::atomic<uint64_t> number;
    Handle nextFree;
};

namespace internal {
extern std::atomic<Entry *> chunks[kMostChunks];
} // namespace internal

/// Of a handle that a reference is held to.
inline Entry &Find(Handle handle) {
    return internal::chunks[handle >> kChunkBits].load(
        std::memory_order_relaxed)[handle & ((1u << kChunkBits) - 1)];
}

/// The entry that has this number; nullptr where none has. Any number may be asked.
inline Entry *FindNumber(uint64_t number) {
    const auto handle = static_cast<Handle>(number & ((uint64_t{1} << kHandleBits) - 1));
    Entry *chunk = internal::chunks[handle >> kChunkBits].load(std::memory_order_acquire);
    if (chunk == nullptr || handle == 0)
        return nullptr;
    Entry &entry = chunk[handle & ((1u << kChunkBits) - 1)];
    return entry.number.load(std::memory_order_acquire) == number ? &entry : nullptr;
}

/// Takes the block over, with one reference; in a group with none, for the group counts. 0 without memory;
/// then the block is still the caller's.
Handle Add(bmr_convex32_block *block, Group *group = nullptr);
/// Frees the polygon, however many references it has. Only for the end of a group.
void Remove(Handle handle);

/// One reference more, of a handle that a reference is held to, or of 0.
inline void AddReference(Handle handle) {
    if (handle == 0)
        return;
    Entry &entry = Find(handle);
    Group *const group = entry.group.load(std::memory_order_relaxed);
    (group != nullptr ? group->references : entry.references).fetch_add(1, std::memory_order_relaxed);
}

/// One reference less; the last frees the block, or ends the group. 0 is allowed.
void Release(Handle handle);
/// The same of a group.
void ReleaseGroup(Group *group);

/// Where polygons and chunks come from; nullptr: malloc. Changed by tests alone, while there is no polygon.
void SetAllocator(const bmr_allocator *allocator);
const bmr_allocator *GetAllocator();

/// Polygons that exist.
size_t Count();

} // namespace bmr::registry

#endif
