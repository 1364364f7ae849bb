// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_BOX2D_GLUE_H
#define BOOMERANG_BOX2D_GLUE_H

#include <cstdint>

#include <box2d/b2_api.h>

#if defined(_WIN32) // part of the DLL that Box2D is
#    define BMR_BOX2D_API B2_API
#    if !defined(BMR_API)
#        define BMR_API B2_API
#    endif
#elif defined(__GNUC__)
#    define BMR_BOX2D_API __attribute__((visibility("default")))
#else
#    define BMR_BOX2D_API
#endif

#include "boomerang/pair.h"

class b2Body;
class b2Contact;

/// @file
/// Boomerang as Box2D's polygon narrow phase. Games include boomerang/box2d.h.

namespace bmr {

/// Whether the plugin answers.
enum class Mode : int32_t {
    On,
    Off,   ///< every contact and every function is Box2D's own
    Verify ///< compute everything twice, compare, say where the two differ first, and go on with Box2D's
           ///< answer; when the process ends (by exit, or by returning from main) say on stderr how many
           ///< answers were compared and how many differed, also where none was
};

/// How one evaluation of two polygons was answered. Those before HandedOver needed no manifold.
enum class Answer : int32_t {
    ApartByPair,   ///< the kinetic structure of their bodies (or of the two) proves them apart
    ApartByEdge,   ///< the edge that their contact remembers does; of a big ConvexShape its vertices
    ApartBySearch, ///< an edge, or the direction of a big one, was found, and is remembered from now on
    HandedOver,    ///< not known to be apart: a manifold was needed
    Touching       ///< the same, nothing asked: they touched at the last look
};

/// How polygons of more than b2_maxPolygonVertices vertices are handed to a game's b2Draw. A drawer that was
/// written for Box2D's polygons may have room for 8 vertices and no more.
enum class Outlines : int32_t {
    Pieces, ///< as a fan of polygons of at most 8 vertices
    Whole   ///< at once: for drawers that take any number
};

/// How the plugin is to work. Process-wide, fixed at the first Install.
struct Options {
    /// Count events. Costs a few per cent; GetStatistics() is all zero without it.
    bool statistics = false;
    /// Told of every event of every pair (implies statistics). Called from inside b2World::Step, from the
    /// thread that steps: it must not touch the world.
    ///
    /// There are two kinds of structures, and each tells of its own life. One is that of two hulls: of bodies
    /// that have many contacts with each other. Its events are core's (boomerang/pair.h). The other is each
    /// contact of two polygons, which keeps an edge, or a direction where one is big. Its certificate is of
    /// level 0, the polygons themselves; level -1 is what is coarser, the disks around big polygons or the
    /// bodies' hulls:
    ///
    ///   START    the first certificate is made
    ///   PUSH     it failed, and another edge or direction separates the two
    ///   STAB     what is coarser failed, and an edge or a direction separates them
    ///   COARSEN  disks are apart, where an edge or a direction was needed before
    ///   CONTACT  they are handed over: nothing is known to separate them
    ///   LEAVE    they were handed over, and are known to be apart now
    ///
    /// (A look tries all vertices of the other polygon. There is no window to leave, so there is no ROLL.) A
    /// look at which the certificate holds, and a budget of motion that is renewed, are no events. Neither is
    /// the end of a contact: where the two meet again, another life begins.
    ///
    /// `event.pair` of a contact is made for the event, and gone when onEvent returns. Its stamp is 0; that
    /// of a pair of hulls is not. Its certificate holds at `event.pose`, of the two bodies as they are given.
    /// (Box2D's test goes by the normals that a polygon has. Where these are not those of its sides, nothing
    /// is certified, and `event.gap` is 0.)
    void (*onEvent)(void *context, const b2Body *bodyA, const b2Body *bodyB,
                    const bmr_event &event) = nullptr;
    void *eventContext = nullptr;
    /// Told of every evaluation, once its manifold is there (implies statistics). As onEvent otherwise.
    void (*onAnswer)(void *context, const b2Contact &contact, Answer answer) = nullptr;
    Mode mode = Mode::On;
    /// 0: refusals and differences alone are printed on stderr. 1: also what Presence says.
    int32_t verbosity = 0;
    /// Where the statistics go when the process ends, as JSON (implies statistics); nullptr: nowhere. Copied.
    /// "way", "box2d", "rounds_as_box2d" and "passes_run" are of Presence. Of a program that forks, the
    /// process that installed writes it; with "%p" in the name, which stands for the number of the process,
    /// each writes its own.
    const char *statisticsFile = nullptr;
    /// How b2World::DebugDraw draws a ConvexShape, where the shared library stands in front of Box2D.
    Outlines outlines = Outlines::Pieces;
};

/// Makes Boomerang the polygon-against-polygon contact of every world in the process. Where Box2D calls the
/// functions that our passes replace (Presence::passesRun), whole steps are ours, too. Call it once, before
/// or after worlds exist (contacts that exist already keep working as stock). What the environment says
/// (BOOMERANG, BOOMERANG_VERBOSE, ...; docs/is-it-for-my-game.md) outweighs the options. Returns whether this
/// call put the plugin to work: false at a second call, where the mode is Off, and where the Box2D of this
/// process is not one that the plugin knows, or there is no memory (one line on stderr says so, once). Not to
/// be raced against a running b2World::Step of another thread.
BMR_BOX2D_API bool Install(const Options &options = Options());
BMR_BOX2D_API bool IsInstalled();

/// How the plugin stands with the Box2D of this process. BOOMERANG_VERBOSE=1 prints the same.
struct Presence {
    /// How Box2D's calls reach the library: "ahead of Box2D" (for the loader), "compiled with Box2D"
    /// (boomerang_accelerate), "behind a wrapper of Box2D" (another b2World::Step is ahead), "behind Box2D"
    /// or "contacts alone of Box2D" (the glue without the plugin).
    const char *way = "";
    const char *box2d = "";     ///< "2.4.1" or "2.4.2"
    bool roundsAsBox2D = false; ///< false also until Install has found it out
    /// True once Install has seen that Box2D's calls reach all functions that our passes replace: it steps
    /// a small world to find out (about 0.1 ms). Else only the contacts of polygons are ours.
    bool passesRun = false;
    const char *whyNot = ""; ///< why no pass of ours runs, in a few words; empty until Install has looked
};
BMR_BOX2D_API Presence GetPresence();

/// What has been done since the process began, summed over all worlds and threads.
struct Statistics {
    uint64_t steps = 0; ///< calls of b2World::Step (seen by the shared library alone)
    /// Times Box2D asked for a manifold of two polygons, or of a big ConvexShape with anything.
    uint64_t evaluations = 0;
    uint64_t edgeChecks = 0;         ///< remembered edges re-tested
    uint64_t edgeSearches = 0;       ///< full separating-edge searches in front of b2CollidePolygons
    uint64_t verdictsReused = 0;     ///< answers of a body pair given again at the same poses
    uint64_t provedApart = 0;        ///< evaluations answered without Box2D
    uint64_t handedOver = 0;         ///< evaluations that needed a manifold
    uint64_t handedOverTouching = 0; ///< of those, because the pair touched at the last look
    uint64_t touchingAnswered = 0;   ///< of those, made here instead of by b2CollidePolygons
    uint64_t toiQueries = 0;         ///< times of impact that a step asked for
    uint64_t toiAnswered = 0;        ///< of those, answered without Box2D
    uint64_t overlapQueries = 0;     ///< overlaps of sensors that a step asked for
    uint64_t overlapsAnswered = 0;   ///< of those, answered without Box2D
    uint64_t pairsWatched = 0; ///< contacts of awake bodies, summed over the steps of worlds with a ledger
    uint64_t looks = 0;        ///< of those, the ones whose contact or geometry was read
    uint64_t renewals = 0;     ///< of those, the ones that their own line renewed
    uint64_t verified = 0;     ///< answers compared with Box2D's (Mode::Verify)
    uint64_t differences = 0;  ///< of those, the ones that differed
    uint64_t pairs = 0;        ///< body pairs that got a kinetic structure
    uint64_t hulls = 0;        ///< hulls built
    bmr_counters kinetic = {}; ///< events of all structures (Options::onEvent); checks of hulls alone
};
BMR_BOX2D_API Statistics GetStatistics();

/// The distance that is certified between the polygon fixtures of two bodies at their present poses: a lower
/// bound of the true distance of the core polygons (radii not subtracted), 0 where nothing is proved or they
/// touch; of the vertices as they are, also where these were changed in place and normals left. Bodies of
/// different worlds: 0. O(fixtures of one times fixtures of the other); does not change the
/// simulation.
BMR_BOX2D_API float CertifiedSlack(const b2Body *bodyA, const b2Body *bodyB);

/// Forgets what is known about this body's shape, and builds its hulls again. To be called after normals of a
/// polygon fixture were changed in place (through b2Fixture::GetShape) and its vertices were not. All else is
/// found without it: vertices and radii that are changed in place, at any time, fixtures that come and go. A
/// call after a change of vertices can save time where the library does not see b2World::Step: there a hull
/// that no longer holds its fixtures answers nothing, and nobody else builds it again.
BMR_BOX2D_API void Invalidate(b2Body *body);

} // namespace bmr

#endif
