// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_PROCESS_H
#define BOOMERANG_GLUE_PROCESS_H

#include <mutex>

#include "boomerang/box2d_glue.h"

class b2ContactListener;

/// @file
/// What belongs to the process, not to a world: its number, what happens where it forks, its locks, what it
/// has said, and which class its contact recorders are of. (A child has all that its parent had, exit
/// handlers too.)

namespace bmr {

/// The system's number of this process.
long ThisProcess();

/// In the child of every fork from here on.
void CallWhenForked(void (*function)());

/// What is said on stderr about what is at work: true for the first who asks, in this process or the one that
/// it was forked from.
bool ClaimAnnouncement();
bool IsAnnounced();

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

namespace internal {

/// bmr::ContactRecorder calls this for each recorder that begins (`change` 1) or ends (-1), with the table of
/// virtual functions of its class. Another class may come to lie in the place of that table when the library
/// that it is in was unloaded: so it is known for as long as a recorder lives. Of two tables, where a program
/// has the class twice, the first is known alone. On any thread.
BMR_BOX2D_API void TrustListener(const void *table, int change);

} // namespace internal

/// Is it a bmr::ContactRecorder? It is called while contacts are updated, reads them, their fixtures and
/// bodies, and changes nothing.
bool IsRecorder(const b2ContactListener &listener);

} // namespace bmr

#endif
