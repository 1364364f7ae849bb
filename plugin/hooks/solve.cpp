// SPDX-License-Identifier: MIT
// b2World::Solve: whose islands are they, and the call of the pass.
#include <box2d/b2_time_step.h>
#include <box2d/b2_world.h>

#include "passes/contact_access.h"
#include "passes/step.h"
#include "reach/stock.h"
#include "start/current_step.h"
#include "start/settings.h"
#include "world/ledger.h"
#include "world/ledgers.h"

using namespace bmr;

BMR_FOR_LOADERS("_ZN7b2World5SolveERK10b2TimeStep");

void b2World::Solve(const b2TimeStep &step) {
    if (NothingIsInstalled())
        return stock::Solve(this, step);
    if (PassesRun(HookOf::Solve) && bmr::Solve(this, step))
        return;
    Ledger *const ledger = FindLedger(&m_contactManager);
    if (ledger != nullptr)
        ledger->GiveMarksBack();
    if (PassesRun() && HasCodeOfGame(m_contactManager))
        BeforeGame(&m_contactManager);
    stock::Solve(this, step);
    if (ledger == nullptr || !ledger->IsLookedAtIn(CurrentStep()))
        return;
    for (const b2Body *body = m_bodyList; body != nullptr; body = body->m_next)
        if ((body->m_flags & b2Body::e_islandFlag) != 0 && !body->IsAwake())
            ledger->Owed().EnableOfSleeper(body);
}
