// SPDX-License-Identifier: MIT
// b2ContactManager::Destroy: a contact's record goes with it.
#include <box2d/b2_contact.h>
#include <box2d/b2_contact_manager.h>

#include "reach/stock.h"
#include "start/settings.h"
#include "world/ledger.h"
#include "world/ledgers.h"

using namespace bmr;

BMR_FOR_LOADERS("_ZN16b2ContactManager7DestroyEP9b2Contact");

void b2ContactManager::Destroy(b2Contact *contact) {
    if (NothingIsInstalled())
        return stock::Destroy(this, contact);
    Ledger *ledger = PassesRun(HookOf::Destroy) ? FindAndSignLedger(this) : nullptr;
    if (ledger == nullptr) {
        stock::Destroy(this, contact);
        return;
    }
    // The listener's EndContact may step the world, or end other contacts: numbers stay. And it may make
    // others, which get the proxies of a body that is being put out of the world.
    Ledger::Ending ending(ledger, contact);
    stock::Destroy(this, contact);
    ending.Complete();
}
