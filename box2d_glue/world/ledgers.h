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
/// contact manager. A world gets one when it has contacts enough, and loses it when it ends.

/// So many contacts are worth a ledger. In worlds of fewer, looking at what touches costs less than the
/// ledger does, whose code and memory a game's own work has put out of the caches between two steps. Where
/// the plugin is to work everywhere it is not asked what anything costs.
inline int WorthALedgerAnyway() {
    return WorksEverywhere() ? 8 : 48;
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

/// nullptr where it has none. Two loads for the world that the thread asked for last.
inline Ledger *FindLedger(const b2ContactManager *manager) {
    return AnyLedger() ? internal::FindLedgerOfSome(manager) : nullptr;
}
/// Makes it if need be; nullptr without memory.
Ledger *MakeLedger(b2ContactManager *manager);
/// For a step that begins: makes it where there are contacts enough. Gives it back where the world began many
/// steps in a row with less than half as many: a world that goes to and fro about the limit keeps it.
Ledger *LedgerForStep(b2ContactManager *manager);
/// The world ends.
void DropLedger(const b2ContactManager *manager);

} // namespace bmr

#endif
