// SPDX-License-Identifier: MIT
#include "passes/ordered_contacts.h"

#include <cmath>

namespace bmr {

bool CarriesNoOrder(float invMass, float invI, const float *at) {
    const auto isNegativeZero = [](float x) { return x == 0.0f && std::signbit(x); };
    return invMass == 0.0f && invI == 0.0f && !isNegativeZero(at[0]) && !isNegativeZero(at[1]) &&
           !isNegativeZero(at[2]);
}

bool OrderedContacts::Reserve(uint32_t bodies, uint32_t contacts) {
    const uint32_t all = kOverlapping * contacts;
    return m_places.Reserve(contacts) && m_groups.Reserve(all) && m_levels.Reserve(all + 1) &&
           m_last.Reserve(bodies);
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
    m_groupCount = m_levelCount = 0;
    for (uint32_t i = 0; i < m_bodies; ++i)
        m_last[i] = 0;
    for (uint32_t i = 0; i < m_iterations; ++i) {
        for (uint32_t j = 0; j < m_count; ++j) {
            const Place &place = m_places[j];
            const uint32_t a = place.a != kNone ? m_last[place.a] : 0,
                           b = place.b != kNone ? m_last[place.b] : 0, level = a > b ? a : b;
            if (level == m_levelCount)
                m_levels[m_levelCount++] = {{kNone, kNone, kNone}};
            if (place.a != kNone)
                m_last[place.a] = level + 1;
            if (place.b != kNone)
                m_last[place.b] = level + 1;
            Put(place, i, &m_levels[level]);
        }
        if (i == 1 && 5 * m_groupCount > 8 * m_count)
            return false;
    }
    return true;
}

void OrderedContacts::Put(const Place &place, uint32_t iteration, Level *level) {
    uint32_t &newest = level->ofKinds[place.kind];
    if (newest == kNone || m_groups[newest].count == 4) {
        const uint32_t c = place.contact;
        m_groups[m_groupCount] = {{c, c, c, c}, {0, 0, 0, 0}, 0, newest};
        newest = m_groupCount++;
    }
    Group &group = m_groups[newest];
    group.contacts[group.count] = place.contact;
    group.iterations[group.count++] = static_cast<uint8_t>(iteration);
}

} // namespace bmr
