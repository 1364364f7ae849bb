// SPDX-License-Identifier: MIT
#ifndef BOX2D_BUILDS_PLAYING_H
#define BOX2D_BUILDS_PLAYING_H

#include <memory>

#include "game.h"
#include "state/snapshot.h"

namespace box2d_builds {

/// A game while it is played: its world, and a record of all that can be seen of it.
class Playing {
public:
    Playing(std::unique_ptr<Game> game, unsigned long seed)
        : m_game(std::move(game)), m_stage(*m_game, seed, &m_recorder) {
        m_recorder.StartStep(false);
        m_game->Build(m_stage, kSize);
    }
    Playing(const Playing &) = delete;
    Playing &operator=(const Playing &) = delete;

    b2World &World() { return m_stage.World(); }
    testbed::Stage &Stage() { return m_stage; }
    Game &TheGame() { return *m_game; }

    /// What the game does between steps, and a step. `inWords`: its events are kept as text, too.
    void Step(int step, bool inWords) {
        m_recorder.StartStep(inWords);
        if (!World().IsLocked()) // it is after an exception
            m_game->BeforeStep(m_stage, step);
        StepAlone();
    }
    void StepAlone() {
        try {
            World().Step(m_game->TimeStep(), 8, 3);
        } catch (const Thrown &) {
            m_game->AfterException();
        }
    }

    testbed::StateHashes Hashes() { return testbed::HashState(World(), m_recorder); }
    std::string Describe() { return testbed::DescribeState(World(), m_recorder); }

private:
    static constexpr int kSize = 12;

    // In this order: the world goes first, and tells the game of its joints.
    std::unique_ptr<Game> m_game;
    testbed::EventRecorder m_recorder;
    testbed::Stage m_stage;
};

} // namespace box2d_builds

#endif
