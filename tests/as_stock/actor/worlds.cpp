// SPDX-License-Identifier: MIT
// What is done to a world as a whole, and asked of it.
#include "actor.h"
#include "plugin.h"
#include "state/visit.h"

namespace actor {

namespace {

class Query final : public b2QueryCallback {
public:
    explicit Query(testbed::HashSink *sink) : m_sink(sink) {}
    bool ReportFixture(b2Fixture *fixture) override {
        m_sink->Field("found", testbed::NumberOf(*fixture));
        return true;
    }

private:
    testbed::HashSink *m_sink;
};

class Ray final : public b2RayCastCallback {
public:
    explicit Ray(testbed::HashSink *sink) : m_sink(sink) {}
    float ReportFixture(b2Fixture *fixture, const b2Vec2 &point, const b2Vec2 &normal,
                        float fraction) override {
        m_sink->Field("hit", testbed::NumberOf(*fixture));
        testbed::VisitVector(*m_sink, "x", "y", point);
        testbed::VisitVector(*m_sink, "nx", "ny", normal);
        return fraction;
    }

private:
    testbed::HashSink *m_sink;
};

} // namespace

void Actor::ShiftOrigin() {
    static constexpr float kScales[] = {0.01f, 0.1f, 1.0f, 5.0f, 100.0f, 1000.0f};
    const float scale = kScales[Below(6)];
    const b2Vec2 to = Vector(scale);
    Box2D().ShiftOrigin(to);
    m_origin -= to;
}

void Actor::SetGravity() {
    const b2Vec2 gravity = Vector(0.2f);
    Box2D().SetGravity(gravity);
}

void Actor::SetTimeStep() {
    static constexpr float kTimes[] = {1.0f / 60.0f,  0.0f,         1.0f / 60.0f, 1.0f,
                                       1.0f / 240.0f, 1.0f / 30.0f, 1e-6f,        0.1f};
    m_timeStep = kTimes[Below(8)];
}

void Actor::SetIterations() {
    const int how = Byte();
    m_velocityIterations = how % 11;
    m_positionIterations = how / 11 % 11;
}

void Actor::SetSolver() {
    b2World &world = Box2D();
    switch (Below(6)) {
    case 0:
        world.SetWarmStarting(!world.GetWarmStarting());
        break;
    case 1:
        world.SetContinuousPhysics(!world.GetContinuousPhysics());
        break;
    case 2:
    case 3:
        world.SetSubStepping(!world.GetSubStepping());
        break;
    case 4:
        world.SetAllowSleeping(!world.GetAllowSleeping());
        break;
    default:
        world.SetAutoClearForces(!world.GetAutoClearForces());
    }
}

void Actor::SetReactions() {
    const int count = 1 + Below(World::kReactionsHeld);
    for (int i = 0; i < count; ++i)
        m_world->reactions[i] = Byte();
}

void Actor::SetRefusals() {
    m_world->refused = Byte();
}

void Actor::AskWorld() {
    const b2Vec2 from = Place();
    const b2Vec2 to = Place();
    Query query(&m_world->Probes());
    b2AABB box;
    box.lowerBound = b2Min(from, to);
    box.upperBound = b2Max(from, to);
    Box2D().QueryAABB(&query, box);
    if (b2DistanceSquared(from, to) > 0.0f) {
        Ray ray(&m_world->Probes());
        Box2D().RayCast(&ray, from, to);
    }
    for (b2Body *body = Box2D().GetBodyList(); body != nullptr; body = body->GetNext())
        for (b2Fixture *fixture = body->GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext())
            m_world->Probes().Field("inside", uint32_t{fixture->TestPoint(from) ? 1u : 0u});
}

/// Asks for a manifold out of turn, at poses that are nobody's.
void Actor::ProbeContact() {
    b2Contact *contact = SomeContact();
    const b2Vec2 away = Vector(0.002f);
    if (contact != nullptr)
        actor::ProbeContact(m_world->Probes(), *contact, away);
}

void Actor::ProbeFixtures() {
    b2Fixture *a = SomeFixture();
    b2Fixture *b = SomeFixture();
    if (a != nullptr && b != nullptr)
        ProbePair(m_world->Probes(), *a, 0, *b, 0);
}

void Actor::SwitchWorld() {
    m_world = m_world->other;
}

/// At the same address as the one before it.
void Actor::RecreateWorld() {
    const b2Vec2 gravity = Box2D().GetGravity();
    const int index = m_world == &*m_worlds[0] ? 0 : 1;
    m_worlds[index].emplace(gravity);
    m_worlds[index]->other = &*m_worlds[1 - index];
    m_world = &*m_worlds[index];
}

void Actor::Inspect() {
    InspectAll(Box2D());
}

void Actor::ChangeHands() {
    m_world->ChangeHands(Byte());
    m_world->filterReacts = static_cast<uint8_t>(Byte() % 2);
}

void Actor::SetFilterReactions() {
    m_world->filterReacts = static_cast<uint8_t>(Byte() % 4);
}

void Actor::ShiftThereAndBack() {
    static constexpr float kScales[] = {1.0f, 100.0f, 8192.0f, 1000.3f};
    const float scale = kScales[Below(4)];
    const b2Vec2 to = Vector(scale);
    Box2D().ShiftOrigin(to);
    Box2D().ShiftOrigin(-to);
}

/// Two times in three to the nearest.
void Actor::SetRounding() {
    const int how = Byte();
    m_world->rounding = how % 3 == 0 ? how / 3 % 4 : 0;
}

void Actor::SetThrowing() {
    m_world->throwing = Byte();
}

void Actor::SetTicks() {
    m_world->ticks = Byte();
}

void Actor::Draw() {
    m_world->Draw();
}

} // namespace actor
