// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_COLUMN_H
#define BOOMERANG_GLUE_COLUMN_H

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <type_traits>
#include <utility>

#include "base/memory.h"

namespace bmr {

/// One column of a table: plain data in one piece of memory that grows, and never throws.
template <typename T> class Column {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    Column() = default;
    ~Column() { std::free(m_block); }
    Column(const Column &) = delete;
    Column &operator=(const Column &) = delete;

    /// Room for so many in all; what is there stays.
    void Reserve(uint32_t capacity) {
        if (capacity <= m_capacity)
            return;
        // Four fifths of what is written stays in use at the worst, on the average of growing.
        const uint64_t wanted = uint64_t{m_capacity} + m_capacity / 4 + 16;
        const uint64_t most = wanted > capacity ? wanted : capacity;
        Grow(most * sizeof(T)); // NOLINT(bugprone-sizeof-expression): of pointers, too
        m_capacity = static_cast<uint32_t>(most);
    }
    /// Gives the memory back.
    void Clear() {
        std::free(m_block);
        m_block = nullptr;
        m_data = nullptr;
        m_capacity = 0;
    }
    void Swap(Column *other) {
        std::swap(m_block, other->m_block);
        std::swap(m_data, other->m_data);
        std::swap(m_capacity, other->m_capacity);
    }

    T *Data() { return m_data; } ///< nullptr: no room was ever asked for
    const T *Data() const { return m_data; }
    T &operator[](uint32_t i) { return m_data[i]; }
    const T &operator[](uint32_t i) const { return m_data[i]; }

private:
    void Grow(uint64_t bytes) {
        constexpr std::size_t kAlign = alignof(T) <= alignof(std::max_align_t) ? 0 : alignof(T);
        const std::ptrdiff_t before = m_block == nullptr ? 0 : AsBytes(m_data) - AsBytes(m_block);
        void *const block = TakeMemory(m_block, bytes + kAlign);
        std::size_t past = 0;
        if constexpr (kAlign != 0)
            past = kAlign - reinterpret_cast<uintptr_t>(block) % kAlign;
        constexpr std::size_t kSize = sizeof(T); // NOLINT(bugprone-sizeof-expression): of pointers, too
        if (static_cast<std::size_t>(before) != past && m_capacity > 0)
            std::memmove(AsBytes(block) + past, AsBytes(block) + before, m_capacity * kSize);
        m_block = block;
        m_data = static_cast<T *>(static_cast<void *>(AsBytes(block) + past));
    }
    static char *AsBytes(void *memory) { return static_cast<char *>(memory); }

    void *m_block = nullptr; ///< from malloc; m_data is at its beginning, or where it is aligned
    T *m_data = nullptr;
    uint32_t m_capacity = 0;
};

} // namespace bmr

#endif
