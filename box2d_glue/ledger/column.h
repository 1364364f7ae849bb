// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_COLUMN_H
#define BOOMERANG_GLUE_COLUMN_H

#include <cstdint>
#include <cstdlib>
#include <type_traits>
#include <utility>

namespace bmr {

/// One column of a table: plain data in one piece of memory that grows, and never throws.
template <typename T> class Column {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    Column() = default;
    ~Column() { std::free(m_data); }
    Column(const Column &) = delete;
    Column &operator=(const Column &) = delete;

    /// Room for so many in all; what is there stays. False without memory, and nothing has changed.
    bool Reserve(uint32_t capacity) {
        if (capacity <= m_capacity)
            return true;
        // Four fifths of what is written stays in use at the worst, on the average of growing.
        const uint64_t wanted = uint64_t{m_capacity} + m_capacity / 4 + 16;
        const uint64_t most = wanted > capacity ? wanted : capacity;
        // NOLINTNEXTLINE(bugprone-sizeof-expression): of pointers, too
        void *data = std::realloc(static_cast<void *>(m_data), most * sizeof(T));
        if (data == nullptr)
            return false;
        m_data = static_cast<T *>(data);
        m_capacity = static_cast<uint32_t>(most);
        return true;
    }
    /// Gives the memory back.
    void Clear() {
        std::free(m_data);
        m_data = nullptr;
        m_capacity = 0;
    }

    void Swap(Column *other) {
        std::swap(m_data, other->m_data);
        std::swap(m_capacity, other->m_capacity);
    }

    T &operator[](uint32_t i) { return m_data[i]; }
    const T &operator[](uint32_t i) const { return m_data[i]; }

private:
    T *m_data = nullptr;
    uint32_t m_capacity = 0;
};

} // namespace bmr

#endif
