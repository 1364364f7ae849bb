// SPDX-License-Identifier: MIT
#ifndef BOX2D_BUILDS_GAME_H
#define BOX2D_BUILDS_GAME_H

#include <memory>
#include <vector>

#include "scene.h"
#include "state/sinks.h"

namespace box2d_builds {

/// What a game's listener throws through b2World::Step.
struct Thrown {};

/// A plain Box2D program in one world: a scene, and what is asked of it beside.
class Game : public testbed::Scene {
public:
    bool Listens() const override { return true; }
    /// Of the step that follows.
    virtual float TimeStep() const { return 1.0f / 60.0f; }
    /// Of what it saw that is no state of the world and no event.
    virtual uint64_t Probes() const { return m_probes.Value(); }
    /// A step was ended by an exception of this game's; the world is locked until one ends well.
    virtual void AfterException() {}

protected:
    testbed::HashSink m_probes;
};

/// A game as the program knows it before it is played.
struct GameInfo {
    const char *name;
    const char *what;
    int steps;
    std::unique_ptr<Game> (*create)();
    bool released = false; ///< for a Box2D without assertions
};

template <typename T> std::unique_ptr<Game> Create() {
    return std::make_unique<T>();
}

/// Of Box2D's flag b2World::IsLocked, and whether a game may do what Box2D asserts that it does not.
#if defined(NDEBUG)
constexpr bool kReleased = true;
#else
constexpr bool kReleased = false;
#endif

/// Each file of games adds its own.
void AddDisabling(std::vector<GameInfo> &games);
void AddShapes(std::vector<GameInfo> &games);
void AddSteps(std::vector<GameInfo> &games);

} // namespace box2d_builds

#endif
