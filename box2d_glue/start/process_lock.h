// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_PROCESS_LOCK_H
#define BOOMERANG_GLUE_PROCESS_LOCK_H

#include <mutex>

namespace bmr {

/// The locks of data that belong to the process, not to a world, in the order in which a thread takes them. A
/// thread may take one again while it holds it. Initialised at compile time, never destroyed.
///
/// A fork waits for the threads that hold them. So the child, which does not have these threads, finds
/// nothing half done, and the locks free.
enum class ProcessLock {
    Starting,    ///< what is installed. Its holder may ask the loader, which waits for threads in dlopen
    Recognising, ///< which Box2D this is, and the register of contacts
    Data,        ///< big polygons, worlds' ledgers, recorders. Its holder never asks the loader
    Count
};

std::recursive_mutex &LockOf(ProcessLock which);

class HoldsProcessLock {
public:
    explicit HoldsProcessLock(ProcessLock which) : m_held(LockOf(which)) {}

private:
    std::lock_guard<std::recursive_mutex> m_held;
};

} // namespace bmr

#endif
