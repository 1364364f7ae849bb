// SPDX-License-Identifier: MIT
#include "hooks/untold_impacts.h"

#include <atomic>

#include "hooks/short_list.h"
#include "ledger/ledger.h"

namespace bmr::hooks {

namespace {

std::atomic<bool> reached{false};

} // namespace

bool TimeOfImpactIsReached() {
    return reached.load(std::memory_order_relaxed);
}

void NoteTimeOfImpactIsReached() {
    reached.store(true, std::memory_order_relaxed);
}

void UntoldImpacts::Finish() {
    m_told = true;
    ShortList::ChooseAgain(m_ledger->Manager());
}

void UntoldImpacts::Tell() {
    if (m_told)
        return;
    Ledger &ledger = *m_ledger;
    for (uint32_t i = ledger.Count(); i-- > 0;) {
        b2Contact *const contact = ledger.Contact(i);
        if (contact == nullptr || ledger.WasAsked(i))
            continue; // these Box2D asks for itself
        if (ledger.MayNotImpact(i)) {
            ledger.ForgetOldImpact(i);
            continue;
        }
        ledger.EnableIfOwed(i);
        ContactNumber::ForgetImpact(contact);
        if (contact->IsEnabled() && ledger.MayImpact(i))
            ContactNumber::HasNoImpact(contact);
    }
    ledger.ForgetOwed();
    // Pairs that could not impact when the search began may be able to after the first one, which wakes
    // bodies.
    Finish();
}

void UntoldImpacts::FoundImpact() {
    Tell();
    m_ledger->SetFoundImpact(true);
}

} // namespace bmr::hooks
