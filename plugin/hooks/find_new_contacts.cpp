// SPDX-License-Identifier: MIT
// b2ContactManager::FindNewContacts.
#include <box2d/b2_contact_manager.h>

#include "passes/find_pairs.h"
#include "reach/stock.h"
#include "start/settings.h"

BMR_FOR_LOADERS("_ZN16b2ContactManager15FindNewContactsEv");

void b2ContactManager::FindNewContacts() {
    if (bmr::PassesRun(bmr::HookOf::FindNewContacts))
        bmr::FindNewContacts(this);
    else
        bmr::stock::FindNewContacts(this);
}
