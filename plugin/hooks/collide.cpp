// SPDX-License-Identifier: MIT
// b2ContactManager::Collide: the loop over a world's contacts at the start of a step.
#include "passes/collide.h"

#include <box2d/b2_contact_manager.h>

#include "reach/stock.h"
#include "start/settings.h"

BMR_FOR_LOADERS("_ZN16b2ContactManager7CollideEv");

void b2ContactManager::Collide() {
    if (bmr::PassesRun(bmr::HookOf::Collide))
        bmr::Collide(this);
    else
        bmr::stock::Collide(this);
}
