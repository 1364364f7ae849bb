// SPDX-License-Identifier: MIT
// b2World::ClearForces, at the end of each step: a body that is asleep has no forces, so that those that are
// awake will do, where the step knows them.
#include <box2d/b2_body.h>
#include <box2d/b2_world.h>

#include "reach/stock.h"
#include "start/current_step.h"
#include "start/settings.h"
#include "world/ledger.h"
#include "world/ledgers.h"

using namespace bmr;

BMR_FOR_LOADERS("_ZN7b2World11ClearForcesEv");

void b2World::ClearForces() {
    Ledger *ledger = PassesRun() ? FindLedger(&m_contactManager) : nullptr;
    // Code of the game may have woken bodies, and have pushed them, since the list was made.
    if (ledger == nullptr || !ledger->GetBodies().AreAlone(CurrentStep()) || GameRan()) {
        stock::ClearForces(this);
        return;
    }
    const Bodies &bodies = ledger->GetBodies();
    for (uint32_t i = 0; i < bodies.AwakeCount(); ++i) {
        bodies.Awake(i)->m_force.SetZero();
        bodies.Awake(i)->m_torque = 0.0f;
    }
}
