// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_PER_THREAD_H
#define BOOMERANG_GLUE_PER_THREAD_H

#include <cstdlib>
#include <memory>
#include <type_traits>

namespace bmr {

/// This thread's own T, all zero at first, freed with the thread; nullptr without memory. One load after the
/// first use: the pointer needs no check of an initialiser. (T itself is on the heap: large thread-local
/// objects would eat the small stacks that some programs give their threads. And it costs nothing until it is
/// used: the system hands out large blocks zeroed, page by page.)
template <typename T> T *PerThread() {
    static_assert(std::is_trivially_copyable<T>::value,
                  "zeros must do for a constructor, nothing for a destructor");
    static thread_local T *mine = nullptr;
    if (mine == nullptr) {
        struct Free {
            void operator()(void *memory) const { std::free(memory); }
        };
        static thread_local std::unique_ptr<void, Free> owner;
        owner.reset(std::calloc(1, sizeof(T)));
        mine = static_cast<T *>(owner.get());
    }
    return mine;
}

} // namespace bmr

#endif
