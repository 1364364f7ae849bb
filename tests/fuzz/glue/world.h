// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_FUZZ_GLUE_WORLD_H
#define BOOMERANG_FUZZ_GLUE_WORLD_H

#include <box2d/box2d.h>

#include "state/snapshot.h"

namespace fuzz {

/// A world, the numbers of what is in it, and what its listeners do: a few bytes of the script, chosen from
/// by the numbers of whom they are told of. They hold no state, so how often they are called does not matter.
class World final : private b2ContactListener, private b2DestructionListener, private b2ContactFilter {
public:
    explicit World(const b2Vec2 &gravity);
    World(const World &) = delete;
    World &operator=(const World &) = delete;

    b2World &Box2D() { return m_world; }
    b2Body *Create(b2BodyDef def);
    b2Fixture *Create(b2Body *body, b2FixtureDef def, const b2Shape &shape);
    uintptr_t NextFixture() { return m_fixturesMade++; }
    b2Joint *Create(b2JointDef &def);

    void Step(float timeStep, int32 velocityIterations, int32 positionIterations);
    bool IsFinite() const;

    testbed::StateHashes Hashes() const { return testbed::HashState(m_world, m_recorder); }
    testbed::HashSink &Probes() { return m_probes; }
    /// What was recorded is forgotten.
    void StartRecord(bool inWords);
    /// Another listener and another filter, of the same mind; or none.
    void ChangeHands(uint32_t how);
    std::string Describe() const { return testbed::DescribeState(m_world, m_recorder); }

    static constexpr int kReactions = 8;
    uint8_t reactions[kReactions] = {}; ///< what listeners do
    uint8_t refused = 0;                ///< which pairs the filter refuses
    bool filterReacts = false;          ///< it does what listeners do, as far as it may
    World *other = nullptr;             ///< a listener may step it

private:
    void BeginContact(b2Contact *contact) override;
    void EndContact(b2Contact *contact) override;
    void PreSolve(b2Contact *contact, const b2Manifold *old) override;
    void PostSolve(b2Contact *contact, const b2ContactImpulse *impulse) override;
    void SayGoodbye(b2Joint *joint) override;
    void SayGoodbye(b2Fixture *fixture) override;
    bool ShouldCollide(b2Fixture *a, b2Fixture *b) override;

    /// The other listener and filter.
    class Other final : public b2ContactListener, public b2ContactFilter {
    public:
        explicit Other(World *world) : m_to(world) {}
        void BeginContact(b2Contact *contact) override { m_to->BeginContact(contact); }
        void EndContact(b2Contact *contact) override { m_to->EndContact(contact); }
        bool ShouldCollide(b2Fixture *a, b2Fixture *b) override { return m_to->ShouldCollide(a, b); }

    private:
        World *m_to;
    };

    void React(b2Contact *contact, uint32_t occasion);
    void ReactAsFilter(b2Fixture *a, b2Fixture *b);
    void ActOn(b2Contact *contact, uint32_t reaction, uint32_t mixed);
    void ProbeContact(b2Contact *contact);
    b2Body *SomeBody(uint32_t mixed);

    b2World m_world;
    Other m_other{this};
    bool m_handsChanged = false; ///< by a listener or the filter: until the next step
    testbed::EventRecorder m_recorder;
    testbed::HashSink m_probes;
    uintptr_t m_bodiesMade = 0, m_fixturesMade = 0, m_jointsMade = 0;
    uint32_t m_steps = 0;
};

/// The shape of a fixture whose vertices may be changed in place; nullptr where it is any other. (Those of a
/// polygon of any size may not.)
b2PolygonShape *PlainPolygon(b2Fixture &fixture);

/// Hash what anybody may ask Box2D of two fixtures.
void ProbePair(testbed::HashSink &sink, const b2Fixture &a, int32 childA, const b2Fixture &b, int32 childB);

} // namespace fuzz

#endif
