// SPDX-License-Identifier: MIT
#include "ledger/pair_memory.h"

#include <cstring>

#include <box2d/b2_distance.h>

#include "ledger/per_thread.h"

namespace bmr {

namespace {

// 192 KB a thread that steps worlds, as far as they are used: 16,384 pairs at once.
constexpr unsigned kPlaceBits = 14;

struct Memory {
    PairMemory places[1u << kPlaceBits];
};

} // namespace

PairMemory *Remember(uint64_t keyA, uint64_t keyB) {
    Memory *memory = PerThread<Memory>();
    if (memory == nullptr)
        return nullptr;
    // Two odd multipliers, so that (a, b) and (b, a) and neighbours in a block allocator's chunk go apart.
    const uint64_t mixed = keyA * 0x9e3779b97f4a7c15u + keyB * 0xc2b2ae3d27d4eb4fu;
    return &memory->places[mixed >> (64u - kPlaceBits)];
}

uint64_t KeyOf(const b2DistanceProxy &proxy) {
    if (proxy.m_vertices != proxy.m_buffer)
        return KeyOf(static_cast<const void *>(proxy.m_vertices));
    // A link of a chain is copied into every question: the copy's place says nothing, its coordinates do.
    uint64_t words[2];
    std::memcpy(words, proxy.m_buffer, sizeof words);
    return words[0] ^ (words[1] << 1);
}

} // namespace bmr
