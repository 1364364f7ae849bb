// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_DIFFERENTIAL_RANDOM_WORLD_H
#define BOOMERANG_TEST_DIFFERENTIAL_RANDOM_WORLD_H

#include <vector>

#include "scene.h"
#include "shapes.h"
#include "state/sinks.h"

namespace differential {

/// A crowded arena in which anything that a game may do to a world happens, between any two steps. What it is
/// depends on its random numbers alone.
class RandomWorld final : public testbed::Scene {
public:
    void Build(testbed::Stage &stage, int size) override;
    void BeforeStep(testbed::Stage &stage, int step) override;

    /// Of the step that follows; may be 0.
    float TimeStep() const { return m_timeStep; }
    /// Of what was seen by asking contacts out of turn.
    uint64_t ProbeHash() const { return m_probes.Value(); }

    bool Listens() const override { return true; }
    void OnBegin(b2Contact &contact) override;
    void OnPreSolve(b2Contact &contact) override;
    void OnGoodbye(b2Joint &joint) override;

private:
    b2Vec2 Anywhere(testbed::Random &random) const;
    b2Body *SomeBody(testbed::Random &random) const;
    uint32_t Mix(b2Contact &contact) const;

    void BuildLevel(testbed::Stage &stage);
    void CreateBody(testbed::Stage &stage);
    void FillBody(testbed::Stage &stage, b2Body *body);
    void ActOnBody(testbed::Stage &stage);
    void ActOnShape(testbed::Stage &stage, b2Body *body);
    void ActOnFixture(testbed::Stage &stage, b2Body *body);
    void ActOnJoints(testbed::Stage &stage);
    void ActOnWorld(testbed::Stage &stage);
    void TurnSensor(testbed::Random &random);
    void Probe(testbed::Stage &stage);
    void RescueLost(testbed::Random &random);

    static constexpr float kHalfWidth = 7.0f, kHalfHeight = 5.0f;
    std::size_t m_wanted = 0;
    int m_step = 0;
    float m_timeStep = 1.0f / 60.0f;
    bool m_sensorsMayTurn = true;
    b2Body *m_arena = nullptr;
    std::vector<b2Body *> m_bodies;
    std::vector<b2Joint *> m_joints;
    testbed::HashSink m_probes;
};

} // namespace differential

#endif
