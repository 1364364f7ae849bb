// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_PROCESS_LOCKS_H
#define BOOMERANG_GLUE_PROCESS_LOCKS_H

#include <mutex>

namespace bmr {

/// @file
/// The locks of data that belong to the process, not to a world. A fork finds all of them free: it waits for
/// each thread that holds one. The child does not have that thread, and so finds nothing half done and
/// nothing locked for ever.

/// In the order in which they are taken: who holds one takes later ones alone.
enum class ProcessLock {
    Starting,    ///< the library, at the first step
    Installing,  ///< the plugin
    Recognising, ///< which Box2D this is
    Registering, ///< contacts
    Polygons,    ///< the register of big polygons
    Ledgers,     ///< which world has which
    Recorders,   ///< the class of bmr::ContactRecorder, and how many are alive
    Count
};

/// Initialised at compile time, never destroyed.
std::mutex &LockOf(ProcessLock which);

} // namespace bmr

#endif
