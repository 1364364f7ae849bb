// SPDX-License-Identifier: MIT
// b2World::SolveTOI: whose search for impacts is it, and the call of the pass.
#include <box2d/b2_time_step.h>
#include <box2d/b2_world.h>

#include "passes/contact_access.h"
#include "passes/step.h"
#include "reach/stock.h"
#include "start/settings.h"
#include "world/ledger.h"
#include "world/ledgers.h"

using namespace bmr;

BMR_FOR_LOADERS("_ZN7b2World8SolveTOIERK10b2TimeStep");

void b2World::SolveTOI(const b2TimeStep &step) {
    if (NothingIsInstalled())
        return stock::SolveToi(this, step);
    Ledger *const ledger = FindLedger(&m_contactManager);
    if (PassesRun(HookOf::SolveToi) && bmr::SolveTOI(this, step))
        return;
    if (ledger != nullptr) {
        ledger->Owed().EnableDownTo(0);
        ledger->GiveMarksBack();
        ledger->GetBodies().NoteDisplaced();
        ledger->Interrupt(); // and reads who touches in the next step
    }
    if (PassesRun() && HasCodeOfGame(m_contactManager))
        BeforeGame(&m_contactManager);
    stock::SolveToi(this, step);
}
