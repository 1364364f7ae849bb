// SPDX-License-Identifier: MIT
#include "glue/pairs/proxy_pairs.h"

#include <box2d/b2_broad_phase.h>
#include <box2d/b2_contact.h>

#include "base/private_members.h"

namespace bmr {

namespace {

uint64_t PairOf(int32 proxyA, int32 proxyB) {
    return static_cast<uint64_t>(static_cast<uint32_t>(b2Min(proxyA, proxyB))) << 32 |
           static_cast<uint32_t>(b2Max(proxyA, proxyB));
}

} // namespace

void ProxyPairs::Reserve(uint32_t count) {
    m_pairs.Reserve(count);
    m_table.MakeRoom([this](uint32_t i) { return m_pairs[i]; });
}

void ProxyPairs::Add(uint32_t i, const b2Contact &contact) {
    const int32 a = FixtureAccess::ProxyOf(contact.GetFixtureA(), contact.GetChildIndexA());
    const int32 b = FixtureAccess::ProxyOf(contact.GetFixtureB(), contact.GetChildIndexB());
    m_pairs[i] = PairOf(a, b);
    if (a == b2BroadPhase::e_nullProxy || b == b2BroadPhase::e_nullProxy ||
        Find(m_pairs[i]) != KeyTable::kNone) {
        m_pairs[i] = kUnknown;
        ++m_unknown;
        return;
    }
    m_table.Add(i, [this](uint32_t row) { return m_pairs[row]; });
}

void ProxyPairs::Remove(uint32_t i) {
    if (m_pairs[i] == kUnknown)
        --m_unknown;
    else
        m_table.Remove(i, [this](uint32_t row) { return m_pairs[row]; });
}

void ProxyPairs::Renumber(uint32_t from, uint32_t to) {
    m_pairs[to] = m_pairs[from];
    if (m_pairs[to] != kUnknown)
        m_table.Renumber(from, to, [this](uint32_t row) { return m_pairs[row]; });
}

void ProxyPairs::Empty() {
    m_table.Empty();
    m_unknown = 0;
}

bool ProxyPairs::Exists(int32_t proxyA, int32_t proxyB) const {
    return Find(PairOf(proxyA, proxyB)) != KeyTable::kNone;
}

} // namespace bmr
