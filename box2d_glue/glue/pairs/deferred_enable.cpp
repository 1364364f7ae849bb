// SPDX-License-Identifier: MIT
#include "glue/pairs/deferred_enable.h"

#include "debug/verify.h"
#include "glue/pairs/pair_table.h"

namespace bmr {

bool DeferredEnable::IsActive(uint32_t i) const {
    const Pair &pair = m_table.At(i);
    return m_table.motions.IsActive(pair.a) || m_table.motions.IsActive(pair.b);
}

void DeferredEnable::EnableDownTo(uint32_t down) {
    if (m_below > m_table.Count())
        m_below = m_table.Count();
    while (m_below > down) {
        // The contacts of one word that are deferred, in any order: no code of the game runs in between.
        const uint32_t word = (m_below - 1) / 64, first = word * 64 > down ? word * 64 : down;
        uint64_t deferred = m_table.AwakeOf(word) & ~m_updated.Word(word) & ~uint64_t{0} << (first % 64);
        if (m_below % 64 != 0)
            deferred &= ~(~uint64_t{0} << (m_below % 64));
        for (uint64_t left = deferred; left != 0; left &= left - 1)
            BMR_PREFETCH(m_table.Contact(word * 64 + LowestBit(left)));
        for (; deferred != 0; deferred &= deferred - 1) {
            const uint32_t i = word * 64 + LowestBit(deferred);
            b2Contact *const contact = m_table.Contact(i);
            if ((!contact->IsEnabled() || Verifying()) && IsActive(i)) {
                ContactAccess::Enable(contact);
                if (Verifying())
                    VerifyContact(*contact);
            }
        }
        m_below = first;
    }
}

void DeferredEnable::EnableIfDeferred(uint32_t i) {
    if (i < m_below && m_table.IsAwake(i) && !m_updated.Has(i) && IsActive(i))
        ContactAccess::Enable(m_table.Contact(i));
}

void DeferredEnable::EnableOfSleeper(const b2Body *body) {
    for (const b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
        const uint32_t i = m_table.NumberOf(edge->contact);
        if (i != PairTable::kNone)
            EnableIfDeferred(i);
    }
}

void DeferredEnable::EndPass() {
    if (m_gameRan || m_gameRanBefore || Verifying())
        EnableDownTo(0);
}

} // namespace bmr
