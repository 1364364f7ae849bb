// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_INSTALL_H
#define BOOMERANG_GLUE_INSTALL_H

#include <mutex>

#include "boomerang/box2d_glue.h"

class b2ContactFilter;
class b2ContactListener;

/// @file
/// What is installed, and what else belongs to the process, not to a world: its lock, what it has said, and
/// which Box2D it has (recognise.cpp). (A child has all that its parent had, exit handlers too.)

namespace bmr {

/// From here on Install returns false, and nothing of Box2D is touched. Says why, in one line on stderr.
/// Returns false.
bool Refuse(const char *why);

/// Was Install called, with any result? Then the library does not start by itself.
bool InstallWasCalled();

/// How Box2D's calls reach the hooks, in a few words; and why they do not, if that is known: then Install
/// refuses. Not copied.
void SetWay(const char *way, const char *whyNotAhead);
const char *TheWay();

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

// Which Box2D is this?

/// Why the Box2D of this process must be left alone, in a few words; nullptr where it is one that the glue
/// knows. Its version number says nothing (2.4.1 calls itself 2.4.0, and a game may have changed constants),
/// so it is tried out. A small world shows how large six records are: b2World, b2Body, b2Fixture,
/// b2PolygonShape, b2Contact, and the user data of a b2JointDef; and three constants that are compiled into
/// Box2D and into the glue: b2_maxPolygonVertices, b2_aabbExtension, b2_linearSlop (b2_lengthUnitsPerMeter
/// instead of the last two, where it explains both). If all is well the world is stepped once, and each hook
/// notes that it was called. About 0.1 ms, before anything of ours is registered. The answer lives until the
/// next call.
const char *WhyBox2DIsUnknown();
/// The same, found out once for the process, on the first call from any thread.
const char *WhyThisBox2DIsUnknown();

/// Which of the versions that are known it is, "2.4.1" or "2.4.2": found out by what b2Distance does to the
/// points of shapes whose skins overlap. For a Box2D that is known.
bool IsBox2D242();
inline const char *VersionOfBox2D() {
    return IsBox2D242() ? "2.4.2" : "2.4.1";
}

/// What b2World begins with for a contact listener, as far as WhyBox2DIsUnknown has seen one begin: Box2D's
/// own, which does nothing.
const b2ContactListener *ListenerOfNewWorlds();
/// The same for its contact filter, which runs only Box2D's code.
const b2ContactFilter *FilterOfNewWorlds();

/// A question to be asked before any of Box2D's symbols is touched, answered in the same way: the shared
/// library, which may meet any libbox2d, looks for the symbols. Set before Install.
void SetLibraryCheck(const char *(*check)());

/// Does the b2CollidePolygons of this process give the bits of bmr_exact32_collide? It does in builds for
/// plain x86-64; a Box2D compiled with fused multiply-add (ARM, -march=native) rounds otherwise. Found out by
/// asking it about pairs of polygons.
bool Box2DRoundsAsExact32();

/// Does its b2CollideEdgeAndPolygon give the bits of bmr_exact32_collide_edge? Found out on links and
/// polygons of all kinds: a game may compile a Box2D whose rules for edges it has changed.
bool Box2DCollidesEdgesAsExact32();

/// Names a hook that Box2D did not call in that step, in a few words; nullptr where it called them all. Where
/// one is not called, Box2D is inside the program, or was built so that it calls its own functions without
/// the loader. After WhyBox2DIsUnknown. The answer lives until the next call.
const char *WhichHookIsNotCalled();
/// Is this thread stepping that small world?
bool IsInTrialStep();

} // namespace bmr

#endif
