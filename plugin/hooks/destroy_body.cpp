// SPDX-License-Identifier: MIT
// b2World::DestroyBody: the list of bodies is another one. b2World::~b2World: the ledger goes with the world.
#include <box2d/b2_world.h>

#include "reach/stock.h"
#include "world/ledger.h"
#include "world/ledgers.h"

using namespace bmr;

BMR_FOR_LOADERS("_ZN7b2World11DestroyBodyEP6b2Body");

void b2World::DestroyBody(b2Body *body) {
    if (Ledger *ledger = FindLedger(&m_contactManager))
        ledger->GetBodies().Forget();
    stock::DestroyBody(this, body);
}

void bmr::hooks::NoteWorldEnds(b2World *world) {
    DropLedger(&world->GetContactManager());
}
