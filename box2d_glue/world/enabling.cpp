// SPDX-License-Identifier: MIT
// Enabling that is owed: Box2D's loop over contacts enables every active contact that it comes by. Those that
// no pass looked at are enabled here, ahead of the first call that could see the difference.
#include "world/ledger.h"

namespace bmr {

void Ledger::OweEnabling(uint32_t below) {
    m_owed = below;
    m_looked.ClearAll();
}

void Ledger::EnableDownTo(uint32_t down) {
    if (m_owed > m_count)
        m_owed = m_count;
    while (m_owed > down) {
        // Those of one word that are owed it, in any order: nobody looks in between.
        const uint32_t word = (m_owed - 1) / 64, first = word * 64 > down ? word * 64 : down;
        uint64_t owed = m_awake.Word(word) & ~m_looked.Word(word) & ~uint64_t{0} << (first % 64);
        if (m_owed % 64 != 0)
            owed &= ~(~uint64_t{0} << (m_owed % 64));
        for (uint64_t left = owed; left != 0; left &= left - 1)
            BMR_PREFETCH(m_contacts[word * 64 + LowestBit(left)]);
        for (; owed != 0; owed &= owed - 1) {
            const uint32_t i = word * 64 + LowestBit(owed);
            if (IsActive(i))
                ContactAccess::Enable(m_contacts[i]);
        }
        m_owed = first;
    }
}

void Ledger::EnableOfSleeper(const b2Body *body) {
    for (const b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
        const uint32_t i = NumberOf(edge->contact);
        if (i != kNone)
            EnableIfOwed(i);
    }
}

} // namespace bmr
