// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_BOX2D_GLUE_H
#define BOOMERANG_BOX2D_GLUE_H

#include <cstdint>

#include "boomerang/pair.h"

class b2Body;

#if defined(__GNUC__)
#    define BMR_BOX2D_API __attribute__((visibility("default")))
#else
#    define BMR_BOX2D_API
#endif

/// @file
/// Boomerang as Box2D's polygon narrow phase. Games include boomerang/box2d.h.

namespace bmr {

/// How the plugin is to work. Process-wide, fixed at the first Install.
struct Options {
    /// The kinetic structure of body pairs (bodies of several fixtures, and all pairs where the prefilter is
    /// off).
    bmr_structure structure = BMR_FREE_DIRECTION;
    /// Ask one remembered edge first: Box2D's own test on one edge, exact to the bit. Off: certificates
    /// alone.
    bool prefilter = true;
    /// Count events. Costs a few per cent; GetStatistics() is all zero without it.
    bool statistics = false;
    /// Told of every event of every pair (implies statistics). Called from inside b2World::Step, from the
    /// thread that steps: it must not touch the world.
    void (*onEvent)(void *context, const b2Body *bodyA, const b2Body *bodyB,
                    const bmr_event &event) = nullptr;
    void *eventContext = nullptr;
};

/// Makes Boomerang the polygon-against-polygon contact of every world in the process. Call it once, before or
/// after worlds exist (contacts that exist already keep working as stock); a second call changes nothing and
/// returns false. Not to be raced against a running b2World::Step of another thread.
BMR_BOX2D_API bool Install(const Options &options = Options());
BMR_BOX2D_API bool IsInstalled();

/// What has been done since the process began, summed over all worlds and threads.
struct Statistics {
    uint64_t evaluations = 0;        ///< times Box2D asked for a polygon-polygon manifold
    uint64_t edgeChecks = 0;         ///< remembered edges re-tested
    uint64_t edgeSearches = 0;       ///< full separating-edge searches after a remembered edge failed
    uint64_t verdictsReused = 0;     ///< answers of a body pair given again at the same poses
    uint64_t provedApart = 0;        ///< evaluations answered without Box2D
    uint64_t handedOver = 0;         ///< evaluations handed to b2CollidePolygons
    uint64_t handedOverTouching = 0; ///< of those, because the pair touched at the last look
    uint64_t pairs = 0;              ///< body pairs that got a kinetic structure
    uint64_t hulls = 0;              ///< hulls built
    bmr_counters kinetic = {};       ///< checks and events of the kinetic structures
};
BMR_BOX2D_API Statistics GetStatistics();

/// The distance that is certified between the polygon fixtures of two bodies at their present poses: a lower
/// bound of the true distance of the core polygons (radii not subtracted), 0 where nothing is proved or they
/// touch. Bodies of different worlds: 0. O(fixtures of one times fixtures of the other); does not change the
/// simulation.
BMR_BOX2D_API float CertifiedSlack(const b2Body *bodyA, const b2Body *bodyB);

/// To be called after the vertices of a polygon fixture were changed in place (through b2Fixture::GetShape):
/// forgets what is known about this body's shape. Creating and destroying fixtures needs no call.
BMR_BOX2D_API void Invalidate(b2Body *body);

} // namespace bmr

#endif
