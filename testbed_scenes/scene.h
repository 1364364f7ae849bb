// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_SCENE_H
#define BOOMERANG_TESTBED_SCENE_H

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "stage.h"

namespace testbed {

/// A plain Box2D program: what it builds, what it does between steps, what it does at contacts.
/// Deterministic: chance comes from stage.Rng() alone, and nothing depends on addresses or clocks.
class Scene {
public:
    virtual ~Scene() = default;

    /// Fills an empty world whose gravity is (0, -10).
    virtual void Build(Stage &stage, int size) = 0;
    /// Before each b2World::Step; steps count from 0.
    virtual void BeforeStep(Stage & /*stage*/, int /*step*/) {}

    /// Whether the callbacks below are wanted even when nobody observes.
    virtual bool Listens() const { return false; }
    virtual void OnBegin(b2Contact & /*contact*/) {}
    virtual void OnEnd(b2Contact & /*contact*/) {}
    virtual void OnPreSolve(b2Contact & /*contact*/, const b2Manifold & /*old*/) {}
    virtual void OnPostSolve(b2Contact & /*contact*/, const b2ContactImpulse & /*impulse*/) {}
};

/// The seed of a scene's random numbers if no --seed is given.
constexpr unsigned long kSeed = 1;

/// What is known of a scene without building it.
struct SceneInfo {
    const char *name;
    const char *description;
    const char
        *group; ///< "classic": small and known from Box2D's testbed; "hard": many pairs that stay
                ///< apart; "games": what games are made of; "any-size": of polygons of any size, as the
                ///< options `vertices` and `bodies` choose; "outlines": of concave bodies, likewise
    int size;
    int steps;
    std::unique_ptr<Scene> (*create)();
    float timeStep = 1.0f / 60.0f;
    /// What its polygons are if no option chooses others; of 0 vertices: no option can.
    PolygonChoice polygons = {};
};

template <typename T> std::unique_ptr<Scene> CreateScene() {
    return std::make_unique<T>();
}

/// A scene whose polygons may be chosen.
inline SceneInfo WithPolygons(SceneInfo info, const PolygonChoice &polygons) {
    info.polygons = polygons;
    return info;
}

/// All scenes, group by group.
const std::vector<SceneInfo> &AllScenes();
/// Null if there is none of this name.
const SceneInfo *FindScene(std::string_view name);

/// Each file of scenes/ adds its own; called by AllScenes in this order, which is that within a group.
void AddClassicStacks(std::vector<SceneInfo> &scenes);
void AddClassicMotion(std::vector<SceneInfo> &scenes);
void AddClassicJoints(std::vector<SceneInfo> &scenes);
void AddClassicExamples(std::vector<SceneInfo> &scenes);
void AddLongThings(std::vector<SceneInfo> &scenes);
void AddCoins(std::vector<SceneInfo> &scenes);
void AddAsteroids(std::vector<SceneInfo> &scenes);
void AddGears(std::vector<SceneInfo> &scenes);
void AddCrowds(std::vector<SceneInfo> &scenes);
void AddGames(std::vector<SceneInfo> &scenes);
void AddAnySizeBodies(std::vector<SceneInfo> &scenes);
void AddAnySizeWorlds(std::vector<SceneInfo> &scenes);
void AddOutlines(std::vector<SceneInfo> &scenes);

/// A scene that is not in the list: two convex bodies that are led through given poses, one pose a step. The
/// file says, in this order,
///
///     course STEPS TIMESTEP
///     polygon N X Y X Y ..             of A, counter-clockwise; then another, of B
///     XA YA ANGLEA XB YB ANGLEB        STEPS + 1 times; angles go on beyond pi
///
/// Box2D integrates: each step gives the bodies the velocities that take them to their next pose. A is
/// kinematic, B is a bullet, so that Box2D asks all its questions. Throws a std::exception for a file that
/// cannot be read.
SceneInfo CourseScene(const std::string &file);

} // namespace testbed

#endif
