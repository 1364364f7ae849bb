// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_COLUMN_H
#define BOOMERANG_GLUE_COLUMN_H

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <type_traits>
#include <utility>

namespace bmr {

/// One column of a table: plain data in one piece of memory that grows, and never throws.
template <typename T> class Column {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    Column() = default;
    ~Column() { std::free(m_block); }
    Column(const Column &) = delete;
    Column &operator=(const Column &) = delete;

    /// Room for so many in all; what is there stays. False without memory, and nothing has changed.
    bool Reserve(uint32_t capacity) {
        if (capacity <= m_capacity)
            return true;
        // Four fifths of what is written stays in use at the worst, on the average of growing.
        const uint64_t wanted = uint64_t{m_capacity} + m_capacity / 4 + 16;
        const uint64_t most = wanted > capacity ? wanted : capacity;
        if (!Grow(most * sizeof(T))) // NOLINT(bugprone-sizeof-expression): of pointers, too
            return false;
        m_capacity = static_cast<uint32_t>(most);
        return true;
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

    T &operator[](uint32_t i) { return m_data[i]; }
    const T &operator[](uint32_t i) const { return m_data[i]; }

private:
    bool Grow(uint64_t bytes) {
        if constexpr (alignof(T) <= alignof(std::max_align_t)) {
            void *block = std::realloc(m_block, bytes);
            if (block == nullptr)
                return false;
            m_block = block;
            m_data = static_cast<T *>(block);
        } else { // realloc would move what is aligned
            void *block = std::malloc(bytes + alignof(T));
            if (block == nullptr)
                return false;
            const uintptr_t past = reinterpret_cast<uintptr_t>(block) % alignof(T);
            void *data = static_cast<char *>(block) + (alignof(T) - past);
            if (m_data != nullptr)
                std::memcpy(data, m_data, m_capacity * sizeof(T));
            std::free(m_block);
            m_block = block;
            m_data = static_cast<T *>(data);
        }
        return true;
    }

    void *m_block = nullptr; ///< from malloc; m_data is at its beginning, or where it is aligned
    T *m_data = nullptr;
    uint32_t m_capacity = 0;
};

} // namespace bmr

#endif
