// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_STOCK_SOLVER_H
#define BOOMERANG_GLUE_STOCK_SOLVER_H

#include <cstdint>

#include <box2d/b2_time_step.h>

#include "passes/sweeps.h"

class b2Body;
class b2Contact;
class b2ContactListener;
class b2Joint;
class b2StackAllocator;
class b2World;

namespace bmr {

/// An island as it is handed to b2Island, in its order.
struct IslandParts {
    b2StackAllocator *allocator; ///< the world's
    b2Body *const *bodies;
    b2Contact *const *contacts;
    b2Joint *const *joints;
    uint32_t bodyCount, contactCount, jointCount;
};

/// How Box2D's own passes are reached, and what they are made of.
struct StockSolver {
    void (*solveWorld)(b2World *world, const b2TimeStep &step);   ///< b2World::Solve
    void (*solveImpacts)(b2World *world, const b2TimeStep &step); ///< b2World::SolveTOI
    /// b2Island's two functions, and what b2World::SolveTOI does with sweeps. nullptr where they are not
    /// reached.
    void (*solve)(const IslandParts &parts, const b2TimeStep &step, const b2Vec2 &gravity, bool allowSleep,
                  b2ContactListener *listener, b2Profile *profile);
    void (*solveToi)(const IslandParts &parts, const b2TimeStep &step, b2ContactListener *listener);
    Sweeps sweeps;
};

/// The plugin fills it when it finds Box2D, before Install. Until then WhoSolvesIslands() is
/// IslandsBy::Nobody.
inline StockSolver &TheStockSolver() {
    static StockSolver solver = {};
    return solver;
}

} // namespace bmr

#endif
