// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_LEDGERS_H
#define BOOMERANG_GLUE_LEDGERS_H

#include <atomic>
#include <cstdint>

#include "start/settings.h"

class b2ContactManager;

namespace bmr {

class Ledger;

/// @file
/// Which world has which ledger. Worlds have no room for one, so that it is found by the address of their
/// contact manager. A world gets one when it has contacts enough (CostOfAPass), and loses it when it
/// ends, or has no contact. Between the two the ledger counts what pays (Ledger::NextStepPays).

/// A pass over a ledger costs as much as Box2D's loop over so many contacts, whatever the ledger holds: a
/// game's own work has put its code and memory out of the caches between two steps. Where the plugin is to
/// work everywhere it is not asked what anything costs.
inline int CostOfAPass() {
    return PairsAreHulls() ? 1 : WorksEverywhere() ? 8 : 48;
}

namespace internal {
/// Grows when a ledger is made or dropped: the ledger that a thread remembers is good until then. 0: no
/// ledger at all.
extern std::atomic<uint64_t> changesOfLedgers;
Ledger *FindLedgerOfSome(const b2ContactManager *manager);
} // namespace internal

/// Has any world had a ledger? A load and a test, for hooks that games call often.
inline bool AnyLedger() {
    return internal::changesOfLedgers.load(std::memory_order_acquire) != 0;
}

/// nullptr where it has none. A few loads for the world that the thread asked for last. If the world's memory
/// was put back since the ledger was signed, the ledger is dropped here, and none of its
/// pointers is followed.
inline Ledger *FindLedger(const b2ContactManager *manager) {
    return AnyLedger() ? internal::FindLedgerOfSome(manager) : nullptr;
}
/// Makes it if need be; nullptr where no sign is left.
Ledger *MakeLedger(b2ContactManager *manager);
/// For a step that begins: signs it, and makes it for a world of as many contacts as a pass costs.
Ledger *LedgerForStep(b2ContactManager *manager);
/// The same as FindLedger, and gives world and ledger a new sign: for steps that begin, and
/// for contacts that end.
Ledger *FindAndSignLedger(b2ContactManager *manager);
/// A world without contacts has no ledger. It may be another world than before: a game may make a world in
/// the memory of one whose destructor it never called.
void DropLedgerOfEmpty(const b2ContactManager *manager);
/// For a game that breaks Box2D's rules: it steps a world inside of its own callbacks, throws through a step,
/// or makes and ends contacts unheard. The marks that Box2D's contacts would hold by now are written back,
/// once, and the world has no ledger until its next step begins. (Enabling is not owed any more: it was paid
/// ahead of the game's code.) Passes that are under way go on by Box2D's list, and are as safe as Box2D's.
void LeaveTable(const b2ContactManager *manager);
/// The world ends, or is to be forgotten. A pass that is under way keeps what it has.
void DropLedger(const b2ContactManager *manager);

} // namespace bmr

#endif
