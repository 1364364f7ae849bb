// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_PROXY_PAIRS_H
#define BOOMERANG_GLUE_PROXY_PAIRS_H

#include <cstdint>

#include "base/columns.h"

class b2Contact;

namespace bmr {

/// Which pairs of proxies of the broad phase have a contact, and by which number: Box2D finds this out by a
/// walk over a body's contacts, for every pair of boxes that begin to overlap.
class ProxyPairs {
public:
    /// Room for contacts of numbers below this, and for one more than there are.
    void Reserve(uint32_t count);
    /// For a contact that there is room for. A body that was put out of its world has no proxies; a filter
    /// may all the same make a contact of it meanwhile, which lasts until the body comes back with other
    /// proxies: the pair of such a contact is unknown.
    void Add(uint32_t i, const b2Contact &contact);
    void Remove(uint32_t i);
    /// The contact of this number is still there, but one of its proxies is not, and may be another fixture's
    /// by now.
    void Forget(uint32_t i) {
        Remove(i);
        m_pairs[i] = kUnknown;
        ++m_unknown;
    }
    bool IsKnown(uint32_t i) const { return m_pairs[i] != kUnknown; }
    /// The contact of this number has another one from here on.
    void Renumber(uint32_t from, uint32_t to);
    void Empty();

    /// Is there a contact of these two proxies?
    bool Exists(int32_t proxyA, int32_t proxyB) const;
    /// The proxies of some contact are unknown: Exists would not find it.
    bool HasUnknown() const { return m_unknown > 0; }

private:
    static constexpr uint64_t kUnknown = ~uint64_t{0};
    uint32_t Find(uint64_t pair) const {
        return m_table.Find(pair, [this](uint32_t i) { return m_pairs[i]; });
    }

    Column<uint64_t> m_pairs; ///< the two proxies, the smaller one first; or kUnknown
    KeyTable m_table;
    uint32_t m_unknown = 0;
};

} // namespace bmr

#endif
