// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_PAIR_MEMORY_H
#define BOOMERANG_GLUE_PAIR_MEMORY_H

#include <cstdint>

#include "boomerang/exact32.h"

struct b2DistanceProxy;

namespace bmr {

/// @file
/// What separated pairs of shapes, or was inside both, when they were last asked for. These are guesses:
/// whoever takes one shows anew that it holds, for the shapes as they are then. So a place may be shared,
/// shapes may change or die and their addresses be used again, and nothing is ever wrong, only slower. Each
/// thread has its own memory, of fixed size.

struct PairMemory {
    bmr_vec32 direction; ///< from a to b, that kept them apart: of unit length, or zero
    uint8_t vertex; ///< of a polygon, that was inside the other: its number, kVertexOfB added if it is b's
    uint8_t misses; ///< proofs for a motion that were sought in vain since one was found, at most 255
    uint8_t rests;  ///< how many more times none is sought
};
constexpr uint8_t kVertexOfB = 0x80;

/// Where a pair is remembered, all zero at first; nullptr without memory, and when the thread ends.
PairMemory *Remember(uint64_t keyA, uint64_t keyB);

/// Calls `seek()`, which says whether it found a proof for a motion, unless that is to rest: pairs of which
/// none was found again and again are asked for one less and less often. `most` misses in a row go without a
/// rest; after the ones that follow it rests 1, 3, 7, 7, .. times.
template <typename Seek> bool SeekUnlessResting(PairMemory *memory, unsigned most, const Seek &seek) {
    constexpr unsigned kMostDoublings = 3;
    if (memory->rests > 0) {
        --memory->rests;
        return false;
    }
    if (seek()) {
        memory->misses = 0;
        return true;
    }
    const unsigned misses = memory->misses + 1u, counted = misses > most ? misses - most : 0;
    const unsigned doublings = counted < kMostDoublings ? counted : kMostDoublings;
    memory->misses = static_cast<uint8_t>(misses < most + kMostDoublings ? misses : most + kMostDoublings);
    memory->rests = static_cast<uint8_t>((1u << doublings) - 1u);
    return false;
}

/// A number that the same shape has again at the next step, most likely no other one.
inline uint64_t KeyOf(const void *shape) {
    return static_cast<uint64_t>(reinterpret_cast<uintptr_t>(shape));
}
uint64_t KeyOf(const b2DistanceProxy &proxy);

} // namespace bmr

#endif
