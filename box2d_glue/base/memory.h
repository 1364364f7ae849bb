// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_MEMORY_H
#define BOOMERANG_GLUE_MEMORY_H

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <type_traits>

namespace bmr {

[[noreturn]] inline void EndWithoutMemory() {
    std::fputs("boomerang: there is no memory\n", stderr);
    std::abort();
}

/// The glue's own memory: realloc, which for big blocks moves pages and no bytes. Without memory it ends the
/// program with a sentence, as Box2D ends in its own allocations. Freed by std::free. (Shapes, outlines and
/// the recorder answer with an error instead.)
inline void *TakeMemory(void *block, std::size_t bytes) {
    void *const taken = std::realloc(block, bytes);
    if (taken == nullptr)
        EndWithoutMemory();
    return taken;
}

/// For containers of the standard library.
template <typename T> struct GlueAllocator {
    using value_type = T;
    GlueAllocator() = default;
    template <typename Other> GlueAllocator(const GlueAllocator<Other> &) {}
    T *allocate(std::size_t count) {
        return static_cast<T *>(TakeMemory(nullptr, count * sizeof(T))); // NOLINT(bugprone-sizeof-expression)
    }
    void deallocate(T *block, std::size_t) { std::free(block); }
    template <typename Other> bool operator==(const GlueAllocator<Other> &) const { return true; }
    template <typename Other> bool operator!=(const GlueAllocator<Other> &) const { return false; }
};

/// This thread's own T, freed with the thread; nullptr from then on when the thread's
/// objects have begun to die: what dies later (a static object's destructor, a thread_local of the game's)
/// may still step a world. One load after the first use: the pointer needs no check of an initialiser. (T
/// itself is on the heap: large thread-local objects would eat the small stacks that some programs give their
/// threads.)
///
/// Where zeros do for a constructor and nothing for a destructor, T costs nothing until it is used: the
/// system hands out large blocks zeroed, page by page.
template <typename T> T *PerThread() {
    constexpr bool kPlain = std::is_trivially_copyable<T>::value;
    // Both have no destructors: they are good for as long as the thread runs at all.
    static thread_local T *mine = nullptr;
    static thread_local bool ended = false;
    if (mine != nullptr || ended)
        return mine;
    struct Owner {
        ~Owner() {
            T *const dying = mine;
            mine = nullptr;
            ended = true;
            if (dying == nullptr)
                return;
            if constexpr (!kPlain)
                dying->~T();
            std::free(dying);
        }
        // (A thread_local is made, and its destructor noted, where it is first used.)
        void Take(T *made) const { mine = made; }
    };
    static thread_local Owner owner;
    if constexpr (kPlain) {
        constexpr size_t bytes = sizeof(T);
        void *const memory = TakeMemory(nullptr, bytes);
        owner.Take(static_cast<T *>(std::memset(memory, 0, bytes)));
    } else
        owner.Take(new (TakeMemory(nullptr, sizeof(T))) T());
    return mine;
}

} // namespace bmr

#endif
