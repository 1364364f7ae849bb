// SPDX-License-Identifier: MIT
#include "glue/pairs/deferred_enable.h"

#include "debug/verify.h"
#include "glue/pairs/pair_table.h"

namespace bmr {

bool OwedEnabling::IsActive(uint32_t i) const {
    const PairRecord &record = m_ledger.At(i);
    return m_ledger.GetMovers().IsActive(record.a) || m_ledger.GetMovers().IsActive(record.b);
}

void OwedEnabling::EnableDownTo(uint32_t down) {
    if (m_below > m_ledger.Count())
        m_below = m_ledger.Count();
    while (m_below > down) {
        // The contacts of one word that are owed it, in any order: no code of the game runs in between.
        const uint32_t word = (m_below - 1) / 64, first = word * 64 > down ? word * 64 : down;
        uint64_t owed = m_ledger.WatchedOf(word) & ~m_looked.Word(word) & ~uint64_t{0} << (first % 64);
        if (m_below % 64 != 0)
            owed &= ~(~uint64_t{0} << (m_below % 64));
        for (uint64_t left = owed; left != 0; left &= left - 1)
            BMR_PREFETCH(m_ledger.Contact(word * 64 + LowestBit(left)));
        for (; owed != 0; owed &= owed - 1) {
            const uint32_t i = word * 64 + LowestBit(owed);
            b2Contact *const contact = m_ledger.Contact(i);
            if ((!contact->IsEnabled() || Verifying()) && IsActive(i)) {
                ContactAccess::Enable(contact);
                if (Verifying())
                    VerifyContact(*contact);
            }
        }
        m_below = first;
    }
}

void OwedEnabling::EnableIfOwed(uint32_t i) {
    if (i < m_below && m_ledger.IsWatched(i) && !m_looked.Has(i) && IsActive(i))
        ContactAccess::Enable(m_ledger.Contact(i));
}

void OwedEnabling::EnableOfSleeper(const b2Body *body) {
    for (const b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
        const uint32_t i = m_ledger.NumberOf(edge->contact);
        if (i != Ledger::kNone)
            EnableIfOwed(i);
    }
}

void OwedEnabling::EndPass(bool gameRan) {
    if (gameRan || m_gameRan || Verifying())
        EnableDownTo(0);
    m_gameRan = gameRan;
}

} // namespace bmr
