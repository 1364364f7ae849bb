// SPDX-License-Identifier: MIT
#ifndef BOX2D_BUILDS_GAME_H
#define BOX2D_BUILDS_GAME_H

#include <memory>
#include <vector>

#include "scene.h"
#include "state/sinks.h"

namespace box2d_builds {

/// A plain Box2D program in one world: a scene, and what is asked of it beside.
class Game : public testbed::Scene {
public:
    bool Listens() const override { return true; }
    /// Of what it saw that is no state of the world and no event.
    virtual uint64_t Probes() const { return m_probes.Value(); }

protected:
    testbed::HashSink m_probes;
};

/// A game as the program knows it before it is played.
struct GameInfo {
    const char *name;
    const char *what;
    int steps;
    std::unique_ptr<Game> (*create)();
};
extern const std::vector<GameInfo> kGames;

/// All that a game does differently which knows of the plugin; called before the first step.
void InstallPlugin();

} // namespace box2d_builds

#endif
