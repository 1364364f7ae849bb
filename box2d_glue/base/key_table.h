// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_KEY_TABLE_H
#define BOOMERANG_GLUE_KEY_TABLE_H

#include <cstdint>
#include <utility>

#include "base/column.h"

namespace bmr {

/// Finds the rows of another table by a key of 64 bits that each of them has, no two the same. Open
/// addressing, at most half full. Four bytes a place: the keys stay with the rows, so every call is handed
/// `keyOf(row)`.
class KeyTable {
public:
    static constexpr uint32_t kNone = 0xffffffffu;

    /// The row that has the key, or kNone.
    template <typename KeyOf> uint32_t Find(uint64_t key, const KeyOf &keyOf) const {
        return m_size == 0 ? kNone : m_rows[Place(key, keyOf)] - 1; // an empty place is 0
    }
    /// Room for one row more.
    template <typename KeyOf> void MakeRoom(const KeyOf &keyOf) {
        if (2 * (m_count + 1) > m_size)
            Grow(keyOf);
    }
    /// A row of a new key, for which there is room.
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
    /// Empty; the memory stays.
    void Empty() {
        for (uint32_t at = 0; at < m_size; ++at)
            m_rows[at] = 0;
        m_count = 0;
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
