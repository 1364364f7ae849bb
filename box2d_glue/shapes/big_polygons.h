// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_BIG_POLYGONS_H
#define BOOMERANG_GLUE_BIG_POLYGONS_H

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>

#include <box2d/b2_math.h>
#include <box2d/b2_polygon_shape.h>

#include "boomerang/allocator.h"
#include "boomerang/convex_shape.h"
#include "convex32/convex32.h"
#include "geometry/memory.h"

struct b2Color;

/// @file
/// The big polygons: from a shape that Box2D hands over to the polygon that it really is. A shape has 4 bytes
/// to spare, too few for a pointer, so it has a handle to one of the polygons of the process.
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

/// So many vertices at most: the handle of the real polygon must have room (boomerang/convex_shape.h).
#if defined(BMR_CONVEX_HANDLE_IN_PADDING)
constexpr int32 kMostShown = b2_maxPolygonVertices;
#else
constexpr int32 kMostShown = b2_maxPolygonVertices - 1;
#endif

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

/// The polygon of a handle that a reference is held to.
inline const bmr_convex32_block &BlockOf(Handle handle) {
    return *Find(handle).block.load(std::memory_order_relaxed);
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

/// `count` objects in memory of that allocator, each as T() makes it. They need no destructor.
template <typename T> class Array {
public:
    explicit Array(size_t count)
        : m_bytes(count * sizeof(T)), // NOLINT(bugprone-sizeof-expression): pointers, too
          m_allocator(GetAllocator()), m_objects(static_cast<T *>(bmr_allocate(m_allocator, m_bytes))) {
        for (size_t i = 0; m_objects != nullptr && i < count; ++i)
            new (m_objects + i) T();
    }
    ~Array() {
        if (m_objects != nullptr)
            bmr_release(m_allocator, m_objects, m_bytes);
    }
    Array(const Array &) = delete;
    Array &operator=(const Array &) = delete;

    /// nullptr without memory.
    T *Get() { return m_objects; }
    T &operator[](size_t i) { return m_objects[i]; }

private:
    size_t m_bytes;
    const bmr_allocator *m_allocator;
    T *m_objects;
};

} // namespace bmr::registry

namespace bmr {

/// The real polygon of a ConvexShape of more than 8 vertices; nullptr of every other shape. Never written,
/// and there for as long as the shape is. A few loads: it is asked at every evaluation of a contact.
const bmr_convex32_block *BigPolygonOf(const b2Shape &shape);

/// A number that no other polygon of the process has, or ever had. Code that remembers a polygon without
/// keeping it alive knows it again by this. 0 for every other shape.
uint64_t NumberOfBigPolygon(const b2Shape &shape);

/// The polygon of that number; nullptr where no shape has it (any more). Any number may be asked, on any
/// thread, also one that was read from uninitialised memory: the answer is nullptr or a polygon that some
/// shape has. A few loads, no lock.
const bmr_convex32_block *BigPolygonOfNumber(uint64_t number);

namespace internal {

extern std::atomic<bool> anyBigPolygon;

/// Where a ConvexShape's functions are; nullptr before there is one. The class is final, and its functions
/// are in one library.
extern std::atomic<const void *> convexShapeTable;

/// The first word of every shape.
inline const void *TableOf(const b2Shape &shape) {
    const void *table;
    std::memcpy(&table, static_cast<const void *>(&shape), sizeof table);
    return table;
}

/// One of any size.
inline bool IsConvexShape(const b2Shape &shape) {
    return TableOf(shape) == convexShapeTable.load(std::memory_order_relaxed);
}

struct ConvexShapeAccess {
    /// 0 where the shape is any other, was changed in place, or has no more than 8 vertices and is no piece
    /// of an outline.
    static uint32_t HandleOf(const b2Shape &shape) {
        return IsConvexShape(shape) ? static_cast<const ConvexShape &>(shape).GetHandle() : 0;
    }
    /// Also where it was changed in place.
    static uint32_t KeptHandleOf(const b2Shape &shape) {
        return IsConvexShape(shape) ? static_cast<const ConvexShape &>(shape).GetKeptHandle() : 0;
    }
    /// The shape takes over the polygon of the handle, with one reference of the caller's.
    static void Adopt(ConvexShape *shape, uint32_t handle) { shape->Adopt(handle); }
};

} // namespace internal

/// Has this process ever made a big polygon? One load. Our hooks ask this first. True before the first such
/// shape is handed out; never false again.
inline bool AnyBigPolygon() {
    return internal::anyBigPolygon.load(std::memory_order_relaxed);
}

/// Hands a polygon at a pose to a game's b2Draw::DrawSolidPolygon: whole, or in pieces of at most
/// b2_maxPolygonVertices vertices, which every drawer of Box2D's polygons takes. Without memory for all
/// vertices, in pieces. If the polygon is a piece of an outline, segments follow: its edges, and
/// parts of edges, behind which no other piece goes on.
void DrawBigPolygon(const bmr_convex32_block &block, const b2Transform &xf, const b2Color &color,
                    DrawAs drawAs, b2Draw &draw);

/// b2World::DebugDraw calls this on its thread when it draws a big polygon of the world: the next
/// DrawConvexShapes of the same world and drawer then has nothing left to do, up to the next step of any
/// world on this thread (which calls it with nullptr).
void NoteDrawnByBox2D(const b2World *world, const b2Draw *draw);

} // namespace bmr

#endif
