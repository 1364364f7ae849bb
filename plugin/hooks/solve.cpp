// SPDX-License-Identifier: MIT
// b2World::Solve: islands are built from the contacts that touch. The lists that it walks over hold no
// others, where few touch (touching_list.h). All else is Box2D's.
#include <box2d/b2_contact.h>
#include <box2d/b2_time_step.h>
#include <box2d/b2_world.h>

#include "hooks/touching_list.h"
#include "ledger/ledger.h"
#include "ledger/ledgers.h"
#include "reach/stock.h"
#include "start/current_step.h"
#include "start/settings.h"
#include "tell/verify.h"

using namespace bmr;
using namespace bmr::hooks;

namespace {

/// Mode::Verify: is every contact that touches known to?
void CompareTouching(const Ledger &ledger) {
    CountVerified();
    for (uint32_t i = 0; i < ledger.Count(); ++i) {
        const b2Contact *contact = ledger.Contact(i);
        if (contact != nullptr && contact->IsTouching() && (ledger.Bits(i) & kTouches) == 0)
            ReportDifference("touching list", contact->GetFixtureA(), contact->GetFixtureB(),
                             "a contact is missing");
    }
}

} // namespace

BMR_FOR_LOADERS("_ZN7b2World5SolveERK10b2TimeStep");

void b2World::Solve(const b2TimeStep &step) {
    if (NothingIsInstalled())
        return stock::Solve(this, step);
    Ledger *ledger = HookIsOn(Hook::Ledger) ? FindLedger(&m_contactManager) : nullptr;
    // Where Box2D's search for new contacts does not come by ours, nobody would open the lists for it.
    if (ledger == nullptr || !ledger->IsLookedAtIn(CurrentStep()) || !ledger->IsWhole() ||
        !ledger->AreSearchesSeen() || IsInOwnStep(this)) {
        stock::Solve(this, step);
        return;
    }
    ledger->MakeTouchesSure();
    if (Verifying()) {
        CompareTouching(*ledger);
        stock::Solve(this, step);
        return;
    }
    {
        const TouchingList list(&m_contactManager, &m_bodyList, m_bodyCount, ledger);
        stock::Solve(this, step);
    }
    if (m_continuousPhysics)
        return; // b2World::SolveTOI sees who fell asleep
    for (const b2Body *body = m_bodyList; body != nullptr; body = body->m_next)
        if ((body->m_flags & b2Body::e_islandFlag) != 0 && !body->IsAwake())
            ledger->EnableOfSleeper(body);
}
