// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_PASSES_H
#define BOOMERANG_GLUE_PASSES_H

#include <cstdint>

#include <box2d/b2_settings.h>

class b2Contact;
class b2ContactManager;
class b2World;
struct b2TimeStep;

/// @file
/// A step, its three passes in their order (Collide, SolveIslands, SolveImpacts), and what these call: the
/// search for new pairs, and the end of a contact. `table`: the world's table of pairs, with all its
/// contacts, if the step goes by it; nullptr: the pass goes by Box2D's lists. A world may leave its table
/// while a pass calls code of the game (LeaveTable). The pass goes on by Box2D's lists then, and so do those
/// after it.

namespace bmr {

class IslandSolver;
class PairTable;

/// b2World::Step, if ClaimStep. Forces are cleared of the bodies that are awake alone, where it is known
/// that no other has any.
void RunStep(b2World *world, float seconds, int32 velocityIterations, int32 positionIterations);

/// A step begins: is it ours, and with it each of its passes? It is Box2D's if the thread does not round to
/// nearest, is about to end, or is in the midst of another step. Then the world leaves its table here; and so
/// does one that is stepped in the midst of its own step, or as a contact of its ends.
bool ClaimStep(const b2World &world);

/// b2ContactManager::Collide: the same contacts in the same order, each filtered, destroyed or updated when
/// Box2D would.
///
/// By a table the pass does not read contacts whose deadline is not reached. Box2D's loop would leave each of
/// these without points, not touching, and enabled. The first two it is. A game may have disabled it, and the
/// pass defers its enabling (DeferredEnable).
void Collide(b2ContactManager *manager, PairTable *table);

/// b2World::Solve: islands of bodies that touch or are joined are built, depth first, and solved; then boxes
/// follow their bodies, and new contacts are looked for.
///
/// Where few pairs of a table touch, islands are built from links between these alone, in the order of
/// Box2D's lists.
void SolveIslands(b2World *world, const b2TimeStep &step, IslandSolver *solver, PairTable *table);

/// b2World::SolveTOI: finds the first impact of what is left of the step, lets the bodies of its island meet,
/// and begins again, until there is none.
///
/// By a table the times of impact that are known stand in a heap (ImpactTimes), and after an impact those
/// pairs alone are asked that Box2D would ask again. Otherwise Box2D's list is searched, and after that its
/// ToiCandidates. Either way a pair that is proved apart over its whole motion is not asked.
void SolveImpacts(b2World *world, const b2TimeStep &step, IslandSolver *solver, PairTable *table);

/// b2ContactManager::FindNewContacts: pairs of proxies whose fat boxes have come to overlap. The same
/// contacts are made in the same order, and the same filters asked. Pairs are found by tree/pair_descent.h;
/// contacts that exist already, in the table of pairs, where Box2D walks over the body's list.
void FindNewContacts(b2ContactManager *manager);

/// b2ContactManager::Destroy: tells the listener if the contact touches, takes it out of the lists of its
/// world and bodies, and frees it. Its pair goes last: the listener may step the world, or end other
/// contacts, and numbers stay.
void EndContact(b2ContactManager *manager, b2Contact *contact);

} // namespace bmr

#endif
