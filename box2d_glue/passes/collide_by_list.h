// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_COLLIDE_BY_LIST_H
#define BOOMERANG_GLUE_COLLIDE_BY_LIST_H

#include <cstdint>

class b2ContactManager;

namespace bmr {

/// b2ContactManager::Collide by Box2D's list, contact by contact. Returns how many contacts touch, of those
/// that are awake.
uint32_t CollideByList(b2ContactManager *manager);

} // namespace bmr

#endif
