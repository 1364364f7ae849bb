// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_PROCESS_LOCK_H
#define BOOMERANG_GLUE_PROCESS_LOCK_H

#include <mutex>

namespace bmr {

/// The lock of all data that belong to the process, not to a world: what is installed, the registers of
/// contacts and of big polygons, which world has which ledger. A thread may take it again while it holds it.
/// Initialised at compile time, never destroyed.
///
/// A fork waits for the thread that holds it. So the child, which does not have that thread, finds nothing
/// half done, and the lock free.
std::recursive_mutex &ProcessLock();

class HoldsProcessLock {
public:
    HoldsProcessLock() : m_held(ProcessLock()) {}

private:
    std::lock_guard<std::recursive_mutex> m_held;
};

} // namespace bmr

#endif
