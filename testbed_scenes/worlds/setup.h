// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_WORLD_SETUP_H
#define BOOMERANG_TESTBED_WORLD_SETUP_H

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "boomerang/world.h"
#include "theory/body.h"

/// @file
/// What a world of many bodies begins with: a scene's name, what may be chosen about it, and the bodies that
/// come of that, placed so that no two disks meet.

namespace testbed {

/// A choice that no world can be made of; says what would do.
class WorldChoiceError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// What may be chosen. Lengths are in radii of the smallest body's disk.
struct WorldChoice {
    std::string scene;
    size_t bodies = 0;
    /// A name of bmr_outline, or "mixed": all of them in turn.
    std::string shape;
    size_t fewestVertices = 0, mostVertices = 0; ///< each body's number is drawn from between them
    double sizes = 1.0;                          ///< radius of the largest disk over the smallest; >= 1
    double density = 0.0;                        ///< the polygons' area over the box's
    double speed = 0.0;                          ///< of a body of the largest size, on average
    double seconds = 0.0;
    std::string structure;
    uint64_t seed = 1;
    bmr_boundary boundary = BMR_WALLED;
    bmr_response response = {BMR_RESPONSE_IMPULSE, 1.0};
    bmr_zeno_policy zeno = BMR_ZENO_ERROR;
    double zenoSpeed = 1e-2;
    bool allPairs = false;
};

/// A scene, with the choice that it is unless told otherwise.
struct WorldScene {
    const char *description;
    WorldChoice choice;
};
const std::vector<WorldScene> &WorldScenes();

struct WorldBody {
    std::unique_ptr<Body> polygon; ///< its centre of mass is the origin of its frame
    double radius = 0.0;           ///< of its disk about that
    double area = 0.0;
    bmr_pose pose = bmr_pose_identity();
    bmr_vec2 velocity = {0.0, 0.0};
    double spin = 0.0;
};

/// Everything at time 0. The same choice gives the same bits.
struct WorldSetup {
    WorldChoice choice;
    bmr_vec2 low = {0.0, 0.0}, high = {0.0, 0.0}; ///< the box; of an open world: where the bodies begin
    std::vector<WorldBody> bodies;
    /// Every body gets a new plan about so often; 0: never.
    double planEvery = 0.0;
};

/// Makes the bodies of a choice. Throws WorldChoiceError where they cannot be placed so densely, or the box
/// is too small for a periodic one. O(bodies * vertices).
WorldSetup MakeWorld(const WorldChoice &choice);

/// Numbers from a seed, the same everywhere.
class Dice {
public:
    explicit Dice(uint64_t seed);
    double Uniform(double low, double high);
    size_t Index(size_t count);
    /// A unit vector.
    bmr_vec2 Direction();

private:
    uint64_t Next();
    uint64_t m_state[4];
};

} // namespace testbed

#endif
