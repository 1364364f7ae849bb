// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_PAIR_TABLES_H
#define BOOMERANG_GLUE_PAIR_TABLES_H

#include <atomic>
#include <cstdint>

#include "glue/pairs/pair_table.h"

/// @file
/// Which world has which table of pairs. Worlds have no room for one, so that it is found by the address of
/// their contact manager. A world gets one when it has contacts enough (CostOfAPass), and loses it when it
/// ends, or has no contact.

namespace bmr {

namespace internal {
/// Grows when a table is made or dropped: the table that a thread remembers is good until then. 0: no table
/// at all.
extern std::atomic<uint64_t> changesOfPairTables;
PairTable *FindPairTableOfSome(const b2ContactManager *manager);
} // namespace internal

/// Has any world had a table? A load and a test, for hooks that games call often.
inline bool AnyPairTable() {
    return internal::changesOfPairTables.load(std::memory_order_acquire) != 0;
}

/// nullptr where it has none, or has left it. A few loads for the world that the thread asked for last. If
/// the world's memory was put back since the table was signed, the table is dropped here, and none of its
/// pointers is followed.
inline PairTable *FindPairTable(const b2ContactManager *manager) {
    return AnyPairTable() ? internal::FindPairTableOfSome(manager) : nullptr;
}
/// Makes it if need be; nullptr where no sign is left, and where the world has left its table.
PairTable *MakePairTable(b2ContactManager *manager);
/// For a step that begins: signs it, and makes it for a world of as many contacts as a pass costs. nullptr
/// also for a step that a game makes inside another one, or as a contact ends.
PairTable *PairTableForStep(b2ContactManager *manager);
/// The same as FindPairTable, and gives world and table a new sign: for steps that begin, and for contacts
/// that end.
PairTable *FindAndSignPairTable(b2ContactManager *manager);
/// A world without contacts has no table. It may be another world than before: a game may make a world in the
/// memory of one whose destructor it never called.
void DropPairTableOfEmpty(const b2ContactManager *manager);
/// For a game that breaks Box2D's rules: it steps a world inside of its own callbacks, throws through a step,
/// or makes and ends contacts unheard. The marks that Box2D's contacts would hold by now are written back,
/// and the world has no table until its next step begins. (No enabling is deferred any more: contacts were
/// enabled ahead of the game's code.) Passes that are under way go on by Box2D's list, and are as safe as
/// Box2D's.
void LeaveTable(const b2ContactManager *manager);
/// Code of the game ran: the world leaves its table if contacts were made or ended unheard. Has it left?
inline bool LeaveIfNotWhole(PairTable *table) {
    if (!table->WasLeft() && !table->IsWhole())
        LeaveTable(table->Manager());
    return table->WasLeft();
}
/// The world ends, or is to be forgotten. A step that holds the table keeps it to its end.
void DropPairTable(const b2ContactManager *manager);

} // namespace bmr

#endif
