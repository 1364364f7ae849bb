// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_COLLIDE_BY_LIST_H
#define BOOMERANG_GLUE_COLLIDE_BY_LIST_H

#include <cstdint>

class b2ContactManager;

namespace bmr {

/// Contacts of a step by Box2D's list.
struct ListCounts {
    uint32_t awake = 0;    ///< one of the two bodies is
    uint32_t touching = 0; ///< of these
};

/// b2ContactManager::Collide by Box2D's list, contact by contact.
ListCounts CollideByList(b2ContactManager *manager);

} // namespace bmr

#endif
