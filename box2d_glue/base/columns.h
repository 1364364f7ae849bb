// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_COLUMNS_H
#define BOOMERANG_GLUE_COLUMNS_H

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

/// A column of bits.
class BitColumn {
public:
    /// Room for rows of numbers below this.
    void Reserve(uint32_t count) {
        const uint32_t words = count / 64 + 1;
        m_bits.Reserve(words);
        for (; m_words < words; ++m_words)
            m_bits[m_words] = 0;
    }
    bool Has(uint32_t i) const { return (m_bits[i / 64] >> (i % 64) & 1) != 0; }
    void Set(uint32_t i) { m_bits[i / 64] |= uint64_t{1} << (i % 64); }
    void Clear(uint32_t i) { m_bits[i / 64] &= ~(uint64_t{1} << (i % 64)); }
    void Put(uint32_t i, bool has) {
        if (has)
            Set(i);
        else
            Clear(i);
    }
    void ClearAll() { Fill(0); }
    void SetAll() { Fill(~uint64_t{0}); }
    void Renumber(uint32_t from, uint32_t to) {
        const bool has = Has(from);
        Clear(from);
        Put(to, has);
    }
    uint32_t Words() const { return m_words; }
    uint64_t Word(uint32_t word) const { return m_bits[word]; }

private:
    void Fill(uint64_t bits) {
        for (uint32_t word = 0; word < m_words; ++word)
            m_bits[word] = bits;
    }

    Column<uint64_t> m_bits;
    uint32_t m_words = 0;
};

/// Finds the rows of another table by a key of 64 bits that each of them has. Of two with the same key it
/// finds one. Open addressing, at most half full. Four bytes a place: the keys stay with the rows, so every
/// call is handed `keyOf(row)`.
class KeyTable {
public:
    static constexpr uint32_t kNone = 0xffffffffu;

    /// The row that has the key, or kNone.
    template <typename KeyOf> uint32_t Find(uint64_t key, const KeyOf &keyOf) const {
        return m_size == 0 ? kNone : m_rows[Place(key, keyOf)] - 1; // an empty place is 0
    }
    /// Room for one row more.
    template <typename KeyOf> void ReserveRow(const KeyOf &keyOf) {
        if (2 * (m_count + 1) > m_size)
            Grow(keyOf);
    }
    /// A row of a new key, after ReserveRow.
    template <typename KeyOf> void Add(uint32_t row, const KeyOf &keyOf) {
        m_rows[Place(keyOf(row), keyOf)] = row + 1;
        ++m_count;
    }
    /// What has the key of this row is another row from here on: this one.
    template <typename KeyOf> void Renumber(uint32_t from, uint32_t to, const KeyOf &keyOf) {
        m_rows[Place(keyOf(from), keyOf)] = to + 1;
    }
    /// It must be there.
    template <typename KeyOf> void Remove(uint32_t row, const KeyOf &keyOf) {
        uint32_t at = Place(keyOf(row), keyOf);
        m_rows[at] = 0;
        --m_count;
        // What lies behind it is moved up to where it is looked for.
        for (at = After(at); m_rows[at] != 0; at = After(at)) {
            const uint32_t moved = std::exchange(m_rows[at], 0);
            m_rows[Place(keyOf(moved - 1), keyOf)] = moved;
        }
    }
    /// Empty, and the memory is given back.
    void Clear() {
        m_rows.Clear();
        m_size = m_count = 0;
    }

private:
    uint32_t After(uint32_t at) const { return (at + 1) & (m_size - 1); }
    /// Where the key's row is, or the free place that it would have.
    template <typename KeyOf> uint32_t Place(uint64_t key, const KeyOf &keyOf) const {
        uint32_t at = static_cast<uint32_t>((key * 0x9e3779b97f4a7c15u) >> 32) & (m_size - 1);
        while (m_rows[at] != 0 && keyOf(m_rows[at] - 1) != key)
            at = After(at);
        return at;
    }
    template <typename KeyOf> void Grow(const KeyOf &keyOf) {
        const uint32_t old = m_size, size = old == 0 ? 64 : 2 * old;
        Column<uint32_t> rows;
        rows.Reserve(size);
        for (uint32_t at = 0; at < size; ++at)
            rows[at] = 0;
        m_rows.Swap(&rows);
        m_size = size;
        for (uint32_t at = 0; at < old; ++at)
            if (rows[at] != 0)
                m_rows[Place(keyOf(rows[at] - 1), keyOf)] = rows[at];
    }

    Column<uint32_t> m_rows; ///< number + 1; 0: free
    uint32_t m_size = 0, m_count = 0;
};

} // namespace bmr

#endif
