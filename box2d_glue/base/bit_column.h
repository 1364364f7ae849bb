// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_BIT_COLUMN_H
#define BOOMERANG_GLUE_BIT_COLUMN_H

#include <cstdint>

#include "base/column.h"

namespace bmr {

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

} // namespace bmr

#endif
