// SPDX-License-Identifier: MIT
#include "contact_index.h"

#include <cstdlib>
#include <cstring>

#include <box2d/b2_broad_phase.h>

#include "contact_access.h"

namespace bmr::interpose {

Table::~Table() {
    std::free(m_slots);
}

void Table::Clear() {
    m_count = 0;
    if (++m_round == 0) { // once in four billion calls the rounds of old slots come up again
        if (m_slots != nullptr)
            std::memset(static_cast<void *>(m_slots), 0, sizeof(Slot) * m_capacity);
        m_round = 1;
    }
}

bool Table::Grow() {
    const uint32_t capacity = m_capacity == 0 ? kFirstCapacity : 2 * m_capacity;
    Slot *slots = static_cast<Slot *>(std::calloc(capacity, sizeof(Slot)));
    if (slots == nullptr)
        return false;
    Slot *const old = m_slots;
    const uint32_t oldCapacity = m_capacity;
    m_slots = slots;
    m_capacity = capacity;
    for (uint32_t i = 0; i < oldCapacity; ++i) {
        if (old[i].round != m_round)
            continue;
        uint32_t at = Start(old[i].word);
        while (m_slots[at].round == m_round)
            at = (at + 1) & (m_capacity - 1);
        m_slots[at] = old[i];
    }
    std::free(old);
    return true;
}

namespace {

uint64_t PairOf(int32 proxyA, int32 proxyB) {
    return static_cast<uint64_t>(static_cast<uint32_t>(b2Min(proxyA, proxyB))) << 32 |
           static_cast<uint32_t>(b2Max(proxyA, proxyB));
}

/// False for a contact whose fixtures have no proxies: its bodies were put out of the world in the middle of
/// the call, and may come back with any.
bool FindPairOf(const b2Contact &contact, uint64_t *pair) {
    const int32 a = FixtureAccess::ProxyOf(contact.GetFixtureA(), contact.GetChildIndexA());
    const int32 b = FixtureAccess::ProxyOf(contact.GetFixtureB(), contact.GetChildIndexB());
    *pair = PairOf(a, b);
    return a != b2BroadPhase::e_nullProxy && b != b2BroadPhase::e_nullProxy;
}

} // namespace

bool ContactIndex::ExistsBehind(const b2ContactEdge *edge, const b2FixtureProxy &a, const b2FixtureProxy &b) {
    const b2Body *body = b.fixture->GetBody();
    uint32_t *steps = StepsOf(body);
    if (steps != nullptr && *steps == kIndexed)
        return m_pairs.Find(PairOf(a.proxyId, b.proxyId)) != nullptr;
    uint32_t walked = 0;
    for (; edge != nullptr && !Joins(*edge, a, b); edge = edge->next)
        ++walked;
    if (steps != nullptr && (*steps += walked) > kWorthIndexing)
        Index(body, steps);
    return edge != nullptr;
}

void ContactIndex::Index(const b2Body *body, uint32_t *steps) {
    uint64_t pair;
    for (const b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next)
        if (!FindPairOf(*edge->contact, &pair) || m_pairs.Add(pair) == nullptr)
            return;
    *steps = kIndexed;
}

void ContactIndex::Remember(const b2Contact &made) {
    uint64_t pair;
    if (m_pairs.Count() != 0 && (!FindPairOf(made, &pair) || m_pairs.Add(pair) == nullptr))
        Forget(); // nothing is indexed any more
}

} // namespace bmr::interpose
