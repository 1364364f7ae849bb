// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_DIFFERENTIAL_RANDOM_WORLD_H
#define BOOMERANG_TEST_DIFFERENTIAL_RANDOM_WORLD_H

#include <cstdint>
#include <vector>

#include "scene.h"
#include "shapes.h"
#include "state/sinks.h"

namespace differential {

/// What listeners did while b2World::SolveTOI was at work, and how often a contact had all its sub-steps.
struct Meddling {
    unsigned long sensors = 0, solids = 0, bullets = 0, asleep = 0, disabled = 0, spent = 0;
};

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
    const Meddling &InImpacts() const { return m_inImpacts; }

    bool Listens() const override { return true; }
    void OnBegin(b2Contact &contact) override;
    void OnPreSolve(b2Contact &contact) override;
    void OnGoodbye(b2Joint &joint) override;

    /// Between the solving of velocities and the end of the step: listeners are told of impacts.
    bool ImpactsAreSolved() const;
    /// Ends a body where the world is not locked.
    void Destroy(b2World &world, b2Body *body);
    /// Bodies were moved after BeforeStep: by a filter, say, before the world is locked.
    void RememberPlaces();
    /// So that all contacts of what turned solid are brought up to date before they are solved.
    void WakeAll();

private:
    b2Vec2 Anywhere(testbed::Random &random) const;
    b2Body *SomeBody(testbed::Random &random) const;
    uint32_t Mix(b2Contact &contact) const;
    /// In these steps listeners put bodies to sleep, and no sensor turns solid: Box2D asserts where one that
    /// touches sleeps over its next update. (Listeners turn sensors in the steps after these.)
    bool StepIsSleepy() const { return m_step % 3 == 2; }
    void Meddle(b2Contact &contact, uint32_t mixed);
    void MeddleWithSensor(const b2Contact &contact, b2Fixture *fixture, bool inImpacts);
    void LookAtContacts(const b2Contact &contact);

    void BuildLevel(testbed::Stage &stage);
    void CreateBody(testbed::Stage &stage);
    void FillBody(testbed::Stage &stage, b2Body *body);
    void AddChains(testbed::Stage &stage);
    void ActOnBody(testbed::Stage &stage);
    void ActOnShape(testbed::Stage &stage, b2Body *body);
    void ActOnFixture(testbed::Stage &stage, b2Body *body);
    void ActOnJoints(testbed::Stage &stage);
    void ActOnWorld(testbed::Stage &stage);
    void TurnSensor(testbed::Random &random);
    void Probe(testbed::Stage &stage);
    void RescueLost(testbed::Random &random);

    static constexpr float kHalfWidth = 7.0f * b2_lengthUnitsPerMeter,
                           kHalfHeight = 5.0f * b2_lengthUnitsPerMeter;
    std::size_t m_wanted = 0;
    int m_step = 0;
    float m_timeStep = 1.0f / 60.0f;
    bool m_sensorsMayTurn = true;
    bool m_stormy = false;          ///< all are bullets, fast and elastic
    bool m_turnedInImpacts = false; ///< a sensor turned solid, after contacts were brought up to date
    struct Place {
        b2Vec2 position;
        float angle;
    };
    std::vector<Place> m_places; ///< of m_bodies, before the step
    Meddling m_inImpacts;
    b2Body *m_arena = nullptr;
    std::vector<b2Body *> m_bodies;
    std::vector<b2Joint *> m_joints;
    testbed::HashSink m_probes;
};

} // namespace differential

#endif
