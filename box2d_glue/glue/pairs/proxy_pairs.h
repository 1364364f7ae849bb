// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_PROXY_PAIRS_H
#define BOOMERANG_GLUE_PROXY_PAIRS_H

#include <cstdint>

#include <box2d/b2_broad_phase.h>
#include <box2d/b2_contact.h>

#include "base/columns.h"
#include "base/private_members.h"

namespace bmr {

/// Which pairs of proxies of the broad phase have a contact, and by which number: Box2D finds this out by a
/// walk over a body's contacts, for every pair of boxes that begin to overlap.
class ProxyPairs {
public:
    /// Room for contacts of numbers below this, and for one more than there are.
    void Reserve(uint32_t count) {
        m_pairs.Reserve(count);
        m_table.MakeRoom(KeyOf{*this});
    }
    /// For a contact that there is room for. A body that was put out of its world has no proxies; a filter
    /// may all the same make a contact of it meanwhile, which lasts until the body comes back with other
    /// proxies: the pair of such a contact is unknown.
    void Add(uint32_t i, const b2Contact &contact) {
        const int32 a = FixtureAccess::ProxyOf(contact.GetFixtureA(), contact.GetChildIndexA());
        const int32 b = FixtureAccess::ProxyOf(contact.GetFixtureB(), contact.GetChildIndexB());
        m_pairs[i] = PairOf(a, b);
        if (a == b2BroadPhase::e_nullProxy || b == b2BroadPhase::e_nullProxy || Exists(a, b)) {
            m_pairs[i] = kUnknown;
            ++m_unknown;
            return;
        }
        m_table.Add(i, KeyOf{*this});
    }
    void Remove(uint32_t i) {
        if (m_pairs[i] == kUnknown)
            --m_unknown;
        else
            m_table.Remove(i, KeyOf{*this});
    }
    /// The contact of this number is still there, but one of its proxies is not, and may be another fixture's
    /// by now.
    void Forget(uint32_t i) {
        Remove(i);
        m_pairs[i] = kUnknown;
        ++m_unknown;
    }
    bool IsKnown(uint32_t i) const { return m_pairs[i] != kUnknown; }
    /// The contact of this number has another one from here on.
    void Renumber(uint32_t from, uint32_t to) {
        m_pairs[to] = m_pairs[from];
        if (m_pairs[to] != kUnknown)
            m_table.Renumber(from, to, KeyOf{*this});
    }
    void Empty() {
        m_table.Empty();
        m_unknown = 0;
    }

    /// Is there a contact of these two proxies?
    bool Exists(int32 proxyA, int32 proxyB) const {
        return m_table.Find(PairOf(proxyA, proxyB), KeyOf{*this}) != KeyTable::kNone;
    }
    /// The proxies of some contact are unknown: Exists would not find it.
    bool HasUnknown() const { return m_unknown > 0; }

private:
    static constexpr uint64_t kUnknown = ~uint64_t{0};
    struct KeyOf {
        const ProxyPairs &pairs;
        uint64_t operator()(uint32_t i) const { return pairs.m_pairs[i]; }
    };
    static uint64_t PairOf(int32 proxyA, int32 proxyB) {
        return static_cast<uint64_t>(static_cast<uint32_t>(b2Min(proxyA, proxyB))) << 32 |
               static_cast<uint32_t>(b2Max(proxyA, proxyB));
    }

    Column<uint64_t> m_pairs; ///< the two proxies, the smaller one first; or kUnknown
    KeyTable m_table;
    uint32_t m_unknown = 0;
};

} // namespace bmr

#endif
