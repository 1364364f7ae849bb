// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_PASSES_H
#define BOOMERANG_GLUE_PASSES_H

#include <box2d/b2_settings.h>

class b2ContactManager;
class b2World;

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

/// b2ContactManager::FindNewContacts: pairs of proxies whose fat boxes have come to overlap. The same
/// contacts are made in the same order, and the same filters asked. Pairs are found by tree/pair_descent.h;
/// contacts that exist already, in the ledger's table of pairs, where Box2D walks over the body's list.
void FindNewContacts(b2ContactManager *manager);

/// Is a step that begins ours, and with it each of its passes? It is Box2D's if the thread does not round to
/// nearest, or is about to end. Then the world leaves its table; and so does one that is stepped in the midst
/// of its own step, or as a contact of its ends.
bool StepIsOurs(const b2World &world);

/// b2World::Step of a step that is ours: the passes in their order. The clock is read once between two of
/// them; and forces are cleared of the bodies that are awake alone, where it is known that no other has any.
void RunStep(b2World *world, float seconds, int32 velocityIterations, int32 positionIterations);

} // namespace bmr

#endif
