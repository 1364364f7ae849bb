// SPDX-License-Identifier: MIT
#include "solver/ordered_contacts.h"

#include <cmath>

namespace bmr {

bool CarriesNoOrder(float invMass, float invI, const float *at) {
    const auto isNegativeZero = [](float x) { return x == 0.0f && std::signbit(x); };
    return invMass == 0.0f && invI == 0.0f && !isNegativeZero(at[0]) && !isNegativeZero(at[1]) &&
           !isNegativeZero(at[2]);
}

void OrderedContacts::Reserve(uint32_t bodies, uint32_t contacts) {
    const uint32_t all = kOverlapping * contacts;
    m_places.Reserve(contacts);
    m_groups.Reserve(all);
    m_levels.Reserve(all + 1);
    m_last.Reserve(bodies + 2);
}

bool OrderedContacts::Find(uint32_t bodies, uint32_t iterations) {
    const bool isKnown = m_isKnown && m_count == m_ordered && iterations == m_iterations;
    m_ordered = m_count;
    m_bodies = bodies;
    m_iterations = iterations;
    if (!isKnown)
        m_pays = m_count >= kLeast && FindAnew();
    return m_count >= kLeast && m_pays;
}

/// False where two iterations have hardly fewer groups than contacts: chains of few contacts each.
bool OrderedContacts::FindAnew() {
    const uint32_t rounds = (m_iterations + kOverlapping - 1) / kOverlapping, most = m_iterations / rounds;
    m_groupCount = m_levelCount = 0;
    for (uint32_t i = 0; i <= m_bodies; ++i)
        m_last[i] = 0;
    for (m_overlapping = 0; m_overlapping < most;) {
        FindLevels(m_overlapping);
        ++m_overlapping;
        const uint32_t all = m_overlapping * m_count;
        if (kEnoughInFour * m_groupCount <= 4 * all && m_iterations % m_overlapping == 0)
            return true;
        if (m_overlapping == 2 && 5 * m_groupCount > 4 * all)
            return false;
    }
    return true;
}

/// Of one more iteration. (Without branches that are hard to foretell: they would take most of the time.)
void OrderedContacts::FindLevels(uint32_t iteration) {
    const uint32_t none = m_bodies; // for a body that carries no order: m_last[none] stays 0
    for (uint32_t i = 0; i < m_count; ++i) {
        const Place &place = m_places[i];
        const uint32_t a = place.a < none ? place.a : none, b = place.b < none ? place.b : none,
                       afterA = m_last[a], afterB = m_last[b], level = afterA > afterB ? afterA : afterB;
        if (level == m_levelCount)
            m_levels[m_levelCount++] = {{kNone, kNone, kNone}};
        m_last[a + (a == none ? 1 : 0)] = level + 1;
        m_last[b + (b == none ? 1 : 0)] = level + 1;
        uint32_t &newest = m_levels[level].ofKinds[place.kind];
        const uint32_t before = newest;
        const bool isFull = before % 4 == 3; // and so is kNone
        newest = isFull ? 4 * m_groupCount : before + 1;
        m_groupCount += isFull ? 1 : 0;
        Group &group = m_groups[newest / 4];
        group.contacts[newest % 4] = place.contact;
        group.iterations[newest % 4] = static_cast<uint8_t>(iteration);
        group.next = isFull ? before : group.next;
    }
}

} // namespace bmr
