// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_FIXTURE_PAIRS_H
#define BOOMERANG_GLUE_FIXTURE_PAIRS_H

#include <cstdint>

#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>

#include "base/columns.h"

namespace bmr {

/// Which pairs of fixtures, or of their children, have a contact: Box2D finds this out by a walk over a
/// body's contacts, for every pair of boxes that begin to overlap. A pair is known by a digest; two different
/// ones have the same with a probability of 2^-64.
class FixturePairs {
public:
    /// The contact of this number.
    void Add(uint32_t i, const b2Contact &contact) {
        m_digests.Reserve(i + 1);
        m_table.ReserveRow(KeyOf{*this});
        m_digests[i] = DigestOf(contact.GetFixtureA(), contact.GetChildIndexA()) +
                       DigestOf(contact.GetFixtureB(), contact.GetChildIndexB());
        m_table.Add(i, KeyOf{*this});
    }
    void Remove(uint32_t i) { m_table.Remove(i, KeyOf{*this}); }
    /// The contact of this number has another one from here on.
    void Renumber(uint32_t from, uint32_t to) {
        m_digests[to] = m_digests[from];
        m_table.Renumber(from, to, KeyOf{*this});
    }
    void Empty() { m_table.Empty(); }

    bool HaveContact(const b2FixtureProxy &a, const b2FixtureProxy &b) const {
        return m_table.Find(DigestOf(a.fixture, a.childIndex) + DigestOf(b.fixture, b.childIndex),
                            KeyOf{*this}) != KeyTable::kNone;
    }

private:
    struct KeyOf {
        const FixturePairs &pairs;
        uint64_t operator()(uint32_t i) const { return pairs.m_digests[i]; }
    };
    static uint64_t DigestOf(const b2Fixture *fixture, int32 child) {
        constexpr uint64_t kFirst = 0x9e3779b97f4a7c15u, kSecond = 0xc2b2ae3d27d4eb4fu;
        uint64_t digest = static_cast<uint64_t>(reinterpret_cast<uintptr_t>(fixture)) * kFirst +
                          static_cast<uint32_t>(child);
        digest = (digest ^ digest >> 32) * kSecond;
        return digest ^ digest >> 29;
    }

    Column<uint64_t> m_digests;
    KeyTable m_table;
};

} // namespace bmr

#endif
