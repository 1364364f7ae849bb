// SPDX-License-Identifier: MIT
// What is done to a world as a whole, and asked of it.
#include <cstring>

#include "plugin.h"
#include "script.h"
#include "state/visit.h"

namespace fuzz {

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

void Script::ShiftOrigin() {
    static constexpr float kScales[] = {0.01f, 0.1f, 1.0f, 5.0f, 100.0f, 1000.0f};
    const float scale = kScales[Below(6)];
    const b2Vec2 to = Vector(scale);
    Box2D().ShiftOrigin(to);
    m_origin -= to;
}

void Script::SetGravity() {
    const b2Vec2 gravity = Vector(0.2f);
    Box2D().SetGravity(gravity);
}

void Script::SetTimeStep() {
    static constexpr float kTimes[] = {1.0f / 60.0f,  0.0f,         1.0f / 60.0f, 1.0f,
                                       1.0f / 240.0f, 1.0f / 30.0f, 1e-6f,        0.1f};
    m_timeStep = kTimes[Below(8)];
}

void Script::SetIterations() {
    const int how = Byte();
    m_velocityIterations = how % 11;
    m_positionIterations = how / 11 % 11;
}

void Script::SetSolver() {
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

void Script::SetReactions() {
    const int count = 1 + Below(World::kReactions);
    for (int i = 0; i < count; ++i)
        m_world->reactions[i] = Byte();
}

void Script::SetRefusals() {
    m_world->refused = Byte();
}

void Script::AskWorld() {
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
void Script::ProbeContact() {
    b2Contact *contact = SomeContact();
    const b2Vec2 away = Vector(0.002f);
    if (contact == nullptr)
        return;
    b2Transform xfA = contact->GetFixtureA()->GetBody()->GetTransform();
    xfA.p += away;
    b2Manifold manifold;
    std::memset(static_cast<void *>(&manifold), 0x7f, sizeof manifold);
    contact->Evaluate(&manifold, xfA, contact->GetFixtureB()->GetBody()->GetTransform());
    testbed::VisitManifold(m_world->Probes(), manifold, false);
}

void Script::ProbeFixtures() {
    b2Fixture *a = SomeFixture();
    b2Fixture *b = SomeFixture();
    if (a != nullptr && b != nullptr)
        ProbePair(m_world->Probes(), *a, 0, *b, 0);
}

void Script::SwitchWorld() {
    m_world = m_world->other;
}

/// At the same address as the one before it.
void Script::RecreateWorld() {
    const b2Vec2 gravity = Box2D().GetGravity();
    const int index = m_world == &*m_worlds[0] ? 0 : 1;
    m_worlds[index].emplace(gravity);
    m_worlds[index]->other = &*m_worlds[1 - index];
    m_world = &*m_worlds[index];
}

/// All of them.
void Script::MoveElsewhere() {
    static constexpr float kScales[] = {0.01f, 1.0f, 8.0f, 1000.0f};
    const float scale = kScales[Below(4)];
    const b2Vec2 by = Vector(scale);
    m_origin += by;
    for (b2Body *body = Box2D().GetBodyList(); body != nullptr; body = body->GetNext())
        body->SetTransform(body->GetPosition() + by, body->GetAngle());
}

void Script::WakeAll() {
    for (b2Body *body = Box2D().GetBodyList(); body != nullptr; body = body->GetNext())
        body->SetAwake(true);
    Box2D().ClearForces();
}

void Script::LookAround() {
    Look(Box2D());
}

/// Of all bodies.
void Script::EmptyWorld() {
    DestroyGears();
    while (b2Body *body = Box2D().GetBodyList())
        Box2D().DestroyBody(body);
}

/// As many small bodies as there is room for, in rows: near enough for contacts, far enough for budgets.
void Script::Crowd() {
    const int how = Byte();
    const float size = 0.1f + 0.01f * static_cast<float>(how % 16);
    const float pitch = 2.0f * size + 0.02f * static_cast<float>(how / 16);
    const b2Vec2 first = Place();
    b2PolygonShape box;
    box.SetAsBox(size, size);
    b2FixtureDef fixture;
    fixture.density = 1.0f;
    fixture.isSensor = how == 255;
    for (int i = 0; Box2D().GetBodyCount() < kMostBodies; ++i) {
        b2BodyDef def;
        def.type = b2_dynamicBody;
        def.bullet = i % 5 == 0;
        def.position = first + pitch * b2Vec2(static_cast<float>(i % 5), static_cast<float>(i / 5));
        m_world->Create(m_world->Create(def), fixture, box);
    }
}

void Script::ChangeHands() {
    m_world->ChangeHands(Byte());
    m_world->filterReacts = Byte() % 2 != 0;
}

} // namespace fuzz
