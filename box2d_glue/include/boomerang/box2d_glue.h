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
class b2World;

/// @file
/// Boomerang as Box2D's polygon narrow phase. Games include boomerang/box2d.h.

namespace bmr {

/// Whether the plugin answers.
enum class Mode : int32_t {
    On,
    Off,   ///< every contact and every function is Box2D's own
    Verify ///< as On; what is answered about contacts and pairs is held against Box2D's own answer, and the
           ///< first difference is said on stderr. When the process ends (by exit, or by returning from
           ///< main) a line says how many answers were compared and how many differed, also where none was
};

/// How polygons of more than b2_maxPolygonVertices vertices are handed to a game's b2Draw. A drawer that was
/// written for Box2D's polygons may have room for 8 vertices and no more.
enum class DrawAs : int32_t {
    Pieces, ///< as a fan of polygons of at most 8 vertices
    Whole   ///< at once: for drawers that take any number
};

/// How the plugin works. One for the process, fixed at the first Install.
struct Options {
    /// Count events. Costs a few per cent.
    bool statistics = false;
    /// Called with every event of every pair (implies statistics), from inside b2World::Step, on the thread
    /// that steps: it must not touch the world.
    ///
    /// Each contact of two polygons is a structure of its own: it keeps an edge, or a direction if one is
    /// big. Its certificate is of level 0, the polygons themselves; level -1 is coarser: the disks around big
    /// polygons. With `pairsBy` the events are core's (boomerang/pair.h), of pairs of bodies; contacts of
    /// sensors have theirs besides.
    ///
    ///   START    the first certificate is made
    ///   PUSH     it failed, and another edge or direction separates the two
    ///   STAB     a coarser proof failed, and an edge or a direction separates the two
    ///   COARSEN  disks are apart, where an edge or a direction was needed before
    ///   CONTACT  no proof separates them: their contact points are computed
    ///   LEAVE    after a CONTACT a proof separates them again
    ///
    /// (An update tries all vertices of the other polygon. There is no window to leave, so there is no ROLL.)
    /// An update at which the certificate holds, and a budget of motion that is renewed, are no events.
    /// Neither is the end of a contact. If its two fixtures meet again, that begins with START.
    ///
    /// A contact's event has no pair, no pose and no gap: `event.pair` and `event.pose` are NULL.
    void (*onEvent)(void *context, const b2Body *bodyA, const b2Body *bodyB,
                    const bmr_event &event) = nullptr;
    void *eventContext = nullptr;
    Mode mode = Mode::On;
    /// For study, not for speed. By default each contact has a line of its own, whose failure time is bounded
    /// instead of computed. With a structure named here every two bodies that have contacts have one kinetic
    /// structure of the paper, of their hulls (of a static body: of each fixture's). It is taken to where the
    /// two are when a contact of theirs is due, and Box2D's exact test is asked only if a stab reaches the
    /// hulls themselves. Shapes other than polygons are Box2D's. The bits are the same.
    /// (BMR_STRUCTURE_COUNT names no structure.)
    bmr_structure pairsBy = BMR_STRUCTURE_COUNT;
    /// 0: only refusals and differences are printed on stderr. 1: how the plugin is at work, too, and what a
    /// step took.
    int32_t verbosity = 0;
    /// How b2World::DebugDraw draws a ConvexShape, if the shared library stands in front of Box2D.
    DrawAs drawAs = DrawAs::Pieces;
};

/// Puts Boomerang to work for every world in the process. Call it once, before or after worlds exist
/// (contacts that exist already keep working as stock), and not while another thread is in b2World::Step. The
/// environment (BOOMERANG, BOOMERANG_VERBOSE, ...; docs/is-it-for-my-game.md) overrides the options. Returns
/// whether this call put the plugin to work. False at a second call, and if the mode is Off. It is also
/// false, and Box2D runs as it is, if the plugin does not know the Box2D of this process, or if Box2D does
/// not call all functions that our passes replace (a small world is stepped to find out, about 0.1 ms): one
/// line on stderr says which, once.
BMR_BOX2D_API bool Install(const Options &options = Options());
BMR_BOX2D_API bool IsInstalled();

/// Drops all that the library remembers of this world. The world's next step begins anew, with the same bits;
/// it costs about as much as one step without the plugin. Call it between steps, on the thread that uses the
/// world; nullptr, and a world of which nothing is remembered, are allowed.
///
/// A game that puts Box2D's memory back to what it was (rollback) need not call it: the next step sees that,
/// by a number in the world's own memory. Call it where that number is not put back with the rest, because
/// the game copies member by member, or after any other change that went around Box2D's functions. A
/// ConvexShape of more than b2_maxPolygonVertices vertices has memory outside of the world, and counts who
/// uses it: a game that goes back must not go back past the making or the end of its fixture.
BMR_BOX2D_API void Forget(b2World *world);

} // namespace bmr

#endif
