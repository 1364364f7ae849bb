// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_INSTALL_H
#define BOOMERANG_GLUE_INSTALL_H

#include <mutex>

#include "boomerang/box2d_glue.h"

class b2ContactListener;

/// @file
/// What is installed, and what else belongs to the process, not to a world: its number, its lock, what it has
/// said, and which class its contact recorders are of. (A child has all that its parent had, exit handlers
/// too.)

namespace bmr {

/// From here on Install returns false, and nothing of Box2D is touched. Says why, in one line on stderr. Not
/// copied. Returns false.
bool Refuse(const char *why);

/// Why this Box2D was left alone: what was said on stderr. nullptr where it was not.
const char *WhyRefused();

/// Was Install called, with any result? Then the library does not start by itself.
bool InstallWasCalled();

/// How Box2D's calls reach the hooks, in a few words; and why they do not, if that is known: then Install
/// refuses. Not copied.
void SetWay(const char *way, const char *whyNotAhead);
const char *TheWay();

/// The system's number of this process.
long ThisProcess();

/// What is said on stderr about what is at work: true for the first who asks, in this process or the one that
/// it was forked from.
bool ClaimAnnouncement();
bool IsAnnounced();

/// Holds the lock of all data that belong to the process, not to a world: what is installed, which Box2D this
/// is and its register of contacts, big polygons, worlds' tables of pairs, recorders. A thread may take it
/// again while it holds it. Install asks the loader while it holds it: a library that another thread opens at
/// that moment must not make shapes in its constructors. Initialised at compile time, never destroyed.
class HoldsProcessLock {
public:
    HoldsProcessLock();

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
