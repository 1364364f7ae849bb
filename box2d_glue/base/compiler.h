// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_COMPILER_H
#define BOOMERANG_GLUE_COMPILER_H

#include <cstdint>

#if !defined(__GNUC__)
#    include <intrin.h>
#endif

/// @file
/// Things for which C++17 has no words, in those of GNU's compilers (and clang) and of Microsoft's. The glue
/// and the plugin use no other extension; plugin/interposed has what only ELF has.

#if defined(__GNUC__)
#    define BMR_NOINLINE __attribute__((noinline))
#    define BMR_COLD __attribute__((noinline, cold))
#    define BMR_RARELY(condition) __builtin_expect((condition), 0)
#    define BMR_PREFETCH(address) __builtin_prefetch(address)
#    define BMR_NOT_FOR_ADDRESS_SANITIZER __attribute__((no_sanitize("address")))
/// A variable of each thread's, zero or a constant at first. (thread_local asks for an initialiser's call
/// wherever it is read from another file.)
#    define BMR_THREAD __thread
#else
#    define BMR_NOINLINE __declspec(noinline)
#    define BMR_COLD __declspec(noinline)
#    define BMR_RARELY(condition) (condition)
#    define BMR_PREFETCH(address) _mm_prefetch(reinterpret_cast<const char *>(address), _MM_HINT_T0)
#    define BMR_NOT_FOR_ADDRESS_SANITIZER
#    define BMR_THREAD thread_local
#endif

namespace bmr {

/// Asks memory for so many cache lines. (Addresses are numbers here: a pointer must not be moved from
/// nullptr, for which this does no harm.)
inline void PrefetchLines(const void *address, uintptr_t count) {
    constexpr uintptr_t kLine = 64;
    const uintptr_t first = reinterpret_cast<uintptr_t>(address);
    for (uintptr_t line = 0; line < count; ++line)
        BMR_PREFETCH(
            reinterpret_cast<const void *>(first + line * kLine)); // NOLINT(performance-no-int-to-ptr)
}

/// The place of the highest bit that is set; there is one.
inline uint32_t HighestBit(uint64_t bits) {
#if defined(__GNUC__)
    return 63u - static_cast<uint32_t>(__builtin_clzll(bits));
#else
    uint32_t place = 0;
    while (bits >>= 1)
        ++place;
    return place;
#endif
}

/// Likewise the lowest.
inline uint32_t LowestBit(uint64_t bits) {
#if defined(__GNUC__)
    return static_cast<uint32_t>(__builtin_ctzll(bits));
#else
    return HighestBit(bits & (~bits + 1));
#endif
}

inline uint32_t CountBits(uint64_t bits) {
#if defined(__GNUC__)
    return static_cast<uint32_t>(__builtin_popcountll(bits));
#else
    uint32_t count = 0;
    for (; bits != 0; bits &= bits - 1)
        ++count;
    return count;
#endif
}

} // namespace bmr

#endif
