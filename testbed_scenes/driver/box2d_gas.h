// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_BOX2D_GAS_H
#define BOOMERANG_TESTBED_BOX2D_GAS_H

#include <vector>

#include "workers.h"
#include "worlds/run.h"

namespace testbed {

/// Where all bodies are at some time, and how they move.
struct GasMoment {
    double time = 0.0;
    std::vector<bmr_pose> poses;
    std::vector<bmr_vec2> velocities;
    std::vector<double> spins;
};
GasMoment MomentOf(const WorldRun &run, const WorldSetup &setup);

/// A contact of two bodies, a < b, in the world's units of time. A wall is the number after the last body's.
struct GasContact {
    int a = 0, b = 0;
    double time = 0.0;
};

/// What stock Box2D makes of the same bodies: elastic, no friction, all of them bullets, 60 steps a second.
struct Box2DGas {
    int64_t steps = 0;
    double timeStep = 0.0; ///< in the world's units of time
    double clock = 0.0;    ///< seconds of the processor for its steps, of a run that is timed alone
    double energyChange = 0.0, mostGain = 0; ///< as shares of the energy after the first step
    double deepest = 0.0;                    ///< overlap, in units of the world's length
    std::vector<GasContact> begins; ///< where Box2D says that a contact begins, at the end of the step
};

/// Of the two, RunGas measures; FindBegins only looks for contacts. Time runs slower in Box2D, so that a
/// body's usual speed is ten metres a second, far above the metre a second below which Box2D takes all energy
/// out of a collision; lengths stay as they are. Throws WorkerError.
Box2DGas RunGas(const WorldSetup &setup, const GasMoment &from, double seconds, const Workers &workers);
std::vector<GasContact> FindBegins(const WorldSetup &setup, const GasMoment &from, double seconds,
                                   const Workers &workers);
/// How long one of Box2D's steps is, in the world's units of time.
double Box2DTimeStep(const WorldSetup &setup);

} // namespace testbed

#endif
