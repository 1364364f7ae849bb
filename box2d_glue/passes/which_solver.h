// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_WHICH_SOLVER_H
#define BOOMERANG_GLUE_WHICH_SOLVER_H

#include <cstdint>

#include <box2d/b2_time_step.h>

class b2Body;
class b2Contact;
class b2ContactListener;
class b2Joint;
class b2World;

namespace bmr {

/// Who solves islands with this Box2D's bits.
enum class IslandsBy : uint8_t {
    Nobody, ///< Box2D's own passes alone: it rounds otherwise than we do, and its b2Island is not reached
    Box2D,  ///< its b2Island, which was compiled with us
    Ours
};

/// An island as it is handed to b2Island, in its order.
struct IslandParts {
    b2Body *const *bodies;
    b2Contact *const *contacts;
    b2Joint *const *joints;
    uint32_t bodyCount, contactCount, jointCount;
};

/// How Box2D's own solver is reached.
struct StockSolver {
    void (*solveWorld)(b2World *world, const b2TimeStep &step); ///< b2World::Solve
    /// b2Island's two functions; nullptr where they are not reached.
    void (*solve)(const IslandParts &parts, const b2TimeStep &step, const b2Vec2 &gravity, bool allowSleep,
                  b2ContactListener *listener, b2Profile *profile);
    void (*solveToi)(const IslandParts &parts, const b2TimeStep &step, b2ContactListener *listener);
};

/// Ahead of Install, by who knows. Until then nobody solves islands.
void SetStockSolver(const StockSolver &solver);
const StockSolver &TheStockSolver();

/// Found out once for a process, about 0.1 ms: in a small world of pairs that overlap, Box2D's b2World::Solve
/// and our solver make the same steps. They end with the same bits unless Box2D was compiled with fused
/// products, or so that its operations may be reordered. Rounding must be to nearest.
IslandsBy WhoSolvesIslands();

} // namespace bmr

#endif
