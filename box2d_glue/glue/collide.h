// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_COLLIDE_H
#define BOOMERANG_GLUE_COLLIDE_H

class b2ContactManager;

namespace bmr {

/// b2ContactManager::Collide, at the start of a step: the same contacts in the same order, each filtered,
/// destroyed or updated when Box2D would.
///
/// A world with a ledger (glue/pairs/pair_table.h) does not look at contacts whose budget of motion is not
/// used up. Box2D's loop would leave each of these without points, not touching, and enabled. The first two
/// it is. A game may have disabled it, and the pass owes it the enabling: the pass pays before each call of
/// the game's code, for the contacts that it has passed, and at its end if code of the game ran. (If none
/// does, b2World::SolveTOI alone asks: OwedEnabling.)
///
/// A world of few contacts, or whose ledger does not pay, is stepped by Box2D's list.
void Collide(b2ContactManager *manager);

} // namespace bmr

#endif
