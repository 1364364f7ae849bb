// SPDX-License-Identifier: MIT
#include "random_world.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace testbed;

namespace differential {

namespace {

/// In a Box2D of other length units everything is as many times as large.
constexpr float kMeter = b2_lengthUnitsPerMeter;

std::size_t Pick(Random &random, std::size_t count) {
    return static_cast<std::size_t>(random.Index(static_cast<int>(count)));
}

b2Fixture *SomeFixture(Random &random, b2Body *body) {
    int count = 0;
    for (b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
        ++count;
    if (count == 0)
        return nullptr;
    b2Fixture *fixture = body->GetFixtureList();
    for (int skip = random.Index(count); skip > 0; --skip)
        fixture = fixture->GetNext();
    return fixture;
}

b2FixtureDef SomeMaterial(Random &random) {
    const float friction = random.Uniform(0.0f, 0.8f);
    return Material(random.OnceIn(12) ? 0.0f : 1.0f, friction, random.OnceIn(3) ? 0.6f : 0.0f);
}

b2PolygonShape SomePolygon(Random &random, b2Vec2 center) {
    if (random.OnceIn(3)) {
        const int count = 3 + random.Index(6);
        Outline outline =
            RegularOutline(count, kMeter * random.Uniform(0.15f, 0.6f), random.Uniform(0.0f, 3.0f));
        for (b2Vec2 &corner : outline)
            corner += center;
        b2PolygonShape shape;
        shape.Set(outline.data(), count);
        return shape;
    }
    const float width = kMeter * random.Uniform(0.1f, 1.2f),
                height = kMeter * (random.OnceIn(2) ? 0.08f : 0.3f);
    return MakeBox(width, height, center, random.OnceIn(2) ? 0.0f : random.Uniform(0.0f, 3.0f));
}

/// Has the polygon a mass that Box2D takes, whatever its density? It asserts that the area is positive, and
/// the moment of inertia of the body, which it is where each polygon's is, about its own centre.
bool HasMass(const b2PolygonShape &polygon) {
    float area = 0.0f;
    for (int32 i = 0; i < polygon.m_count; ++i)
        area += 0.5f * b2Cross(polygon.m_vertices[i], polygon.m_vertices[(i + 1) % polygon.m_count]);
    if (area <= 0.001f * kMeter * kMeter)
        return false;
    b2MassData mass;
    polygon.ComputeMass(&mass, 1.0f);
    return mass.I - mass.mass * mass.center.LengthSquared() > 0.001f * mass.I;
}

/// Moves one vertex alone: the normals are those of other sides then. A vertex that turns the polygon inside
/// out stays.
void MoveVertex(Random &random, b2PolygonShape *polygon) {
    b2PolygonShape moved = *polygon;
    moved.m_vertices[random.Index(3)] *= random.Uniform(0.2f, 1.6f);
    if (HasMass(moved))
        *polygon = moved;
}

/// One more fixture, somewhere on the body.
void AddPart(Stage &stage, b2Body *body) {
    Random &random = stage.Rng();
    const b2Vec2 center = kMeter * random.Direction(0.0f, 0.8f);
    b2FixtureDef def = SomeMaterial(random);
    def.isSensor = random.OnceIn(8); // sensors of every kind, on bodies of every type
    const int kind = random.Index(10);
    if (kind == 0)
        stage.AddFixture(body, def, MakeCircle(kMeter * random.Uniform(0.1f, 0.4f), center));
    else if (kind == 1 && body->GetType() == b2_staticBody)
        stage.AddFixture(body, def, MakeEdge(center, center + kMeter * random.Direction(0.3f, 2.0f)));
    else
        stage.AddFixture(body, def, SomePolygon(random, center));
}

} // namespace

b2Vec2 RandomWorld::Anywhere(Random &random) const {
    const float x = random.Uniform(-0.95f, 0.95f) * kHalfWidth;
    const float y = random.Uniform(-0.95f, 0.95f) * kHalfHeight;
    return m_arena->GetPosition() + b2Vec2(x, y);
}

b2Body *RandomWorld::SomeBody(Random &random) const {
    return m_bodies[Pick(random, m_bodies.size())];
}

void RandomWorld::OnGoodbye(b2Joint &joint) {
    m_joints.erase(std::remove(m_joints.begin(), m_joints.end(), &joint), m_joints.end());
}

void RandomWorld::Destroy(b2World &world, b2Body *body) {
    m_bodies.erase(std::find(m_bodies.begin(), m_bodies.end(), body));
    world.DestroyBody(body);
}

void RandomWorld::BuildLevel(Stage &stage) {
    Random &random = stage.Rng();
    // Near the origin; about where certificates are no longer trusted, and where the bands of budgets end
    // (proofs/thresholds.h); beyond.
    constexpr float kPlaces[] = {0.0f, 0.0f, 0.0f, 0.0f, 60.0f, 478.0f, 505.0f, 1917.0f, 3000.0f, -10000.0f};
    const float place = kMeter * kPlaces[random.Index(10)];
    m_arena = AddArena(stage, {place, random.OnceIn(2) ? place : 0.0f}, kHalfWidth, kHalfHeight, 0.3f);
    if (random.OnceIn(2)) {
        Outline floor;
        for (int i = 0; i <= 10; ++i)
            floor.emplace_back(kHalfWidth * (1.0f - 0.2f * static_cast<float>(i)),
                               kMeter * random.Uniform(0.1f, 0.8f) - kHalfHeight);
        b2ChainShape chain;
        chain.CreateChain(floor.data(), static_cast<int32>(floor.size()),
                          floor.front() + b2Vec2(kMeter, 0.0f), floor.back() - b2Vec2(kMeter, 0.0f));
        stage.AddFixture(m_arena, chain, 0.0f);
    }
    for (int i = random.Index(5); i > 0; --i) {
        b2BodyDef def;
        def.position = Anywhere(random);
        def.angle = random.Uniform(-b2_pi, b2_pi);
        if (random.OnceIn(2)) {
            def.type = b2_kinematicBody;
            def.angularVelocity = random.Uniform(-2.0f, 2.0f);
            def.linearVelocity = kMeter * random.Direction(0.0f, 0.5f);
        }
        AddFan(stage, stage.AddBody(def),
               RoughOutline(random, 5 + random.Index(9), 0.4f * kMeter, 1.2f * kMeter), Material(0.0f));
    }
    AddChains(stage);
}

/// Loops of edges, resting or moving, solid or not.
void RandomWorld::AddChains(Stage &stage) {
    Random &random = stage.Rng();
    for (int i = random.Index(3); i > 0; --i) {
        b2BodyDef def;
        def.position = Anywhere(random);
        if (random.OnceIn(2)) {
            def.type = b2_kinematicBody;
            def.angularVelocity = random.Uniform(-4.0f, 4.0f);
            def.linearVelocity = kMeter * random.Direction(0.0f, 1.0f);
        }
        const Outline corners = RoughOutline(random, 4 + random.Index(6), 0.5f * kMeter, 1.5f * kMeter);
        b2ChainShape loop;
        loop.CreateLoop(corners.data(), static_cast<int32>(corners.size()));
        b2FixtureDef fixture = Material(0.0f, 0.3f, random.OnceIn(2) ? 0.8f : 0.0f);
        fixture.isSensor = random.OnceIn(3);
        stage.AddFixture(stage.AddBody(def), fixture, loop);
    }
}

void RandomWorld::Build(Stage &stage, int size) {
    Random &random = stage.Rng();
    BuildLevel(stage);
    m_stormy = random.OnceIn(4);
    if (m_stormy || random.OnceIn(2))
        stage.World().SetGravity({0.0f, 0.0f}); // a gas: more pairs that pass than pairs that lie
    m_wanted = static_cast<std::size_t>(size) + static_cast<std::size_t>(random.Index(size));
    for (std::size_t i = 0; i < m_wanted; ++i)
        CreateBody(stage);
}

void RandomWorld::CreateBody(Stage &stage) {
    Random &random = stage.Rng();
    b2BodyDef def;
    def.type = random.OnceIn(10) ? b2_kinematicBody : b2_dynamicBody;
    def.position = Anywhere(random);
    def.angle = random.OnceIn(4) ? 0.25f * b2_pi : random.Uniform(-b2_pi, b2_pi);
    def.linearVelocity = kMeter * random.Direction(0.0f, random.OnceIn(5) ? 60.0f : 3.0f);
    if (random.OnceIn(6)) // far beyond a turn, and beyond where certificates are trusted
        def.angle += random.Uniform(-700.0f, 700.0f);
    def.angularVelocity = random.Uniform(-3.0f, 3.0f);
    def.bullet = m_stormy || random.OnceIn(5);
    if (m_stormy)
        def.linearVelocity = kMeter * random.Direction(20.0f, 150.0f);
    def.fixedRotation = random.OnceIn(12);
    def.allowSleep = !random.OnceIn(8);
    b2Body *body = stage.AddBody(def);
    m_bodies.push_back(body);
    FillBody(stage, body);
}

void RandomWorld::FillBody(Stage &stage, b2Body *body) {
    Random &random = stage.Rng();
    switch (random.Index(8)) {
    case 0: // up to 100 vertices: more than a hull keeps
        AddConvex(stage, body, RegularOutline(9 + random.Index(92), kMeter * random.Uniform(0.3f, 0.9f)),
                  SomeMaterial(random));
        break;
    case 1:
        AddFan(stage, body, RoughOutline(random, 5 + random.Index(8), 0.2f * kMeter, 0.9f * kMeter),
               SomeMaterial(random));
        break;
    case 2:
        AddFan(stage, body, StarOutline(6 + random.Index(12), 0.3f * kMeter, 0.9f * kMeter),
               SomeMaterial(random));
        break;
    case 3: // a plank of several boxes
        for (int i = random.Index(4); i >= 0; --i)
            stage.AddFixture(body, SomeMaterial(random),
                             MakeBox(0.4f * kMeter, 0.06f * kMeter,
                                     {kMeter * (0.8f * static_cast<float>(i) - 0.8f), 0.0f}));
        break;
    case 4: { // an eye
        b2FixtureDef eye = SomeMaterial(random);
        eye.isSensor = true;
        stage.AddFixture(body, eye, MakeRegular(3 + random.Index(6), 1.2f * kMeter));
        AddPart(stage, body);
        AddPart(stage, body);
        break;
    }
    case 5:
        for (int i = random.Index(5); i >= 0; --i)
            AddPart(stage, body);
        break;
    default:
        stage.AddFixture(body, SomeMaterial(random), SomePolygon(random, {0.0f, 0.0f}));
    }
}

void RandomWorld::BeforeStep(Stage &stage, int step) {
    Random &random = stage.Rng();
    m_step = step;
    // Times of impact survive an unfinished sub-step, until a whole step has been done.
    if (stage.World().GetSubStepping())
        m_sensorsMayTurn = false;
    else if (stage.World().GetContinuousPhysics() && m_timeStep > 0.0f)
        m_sensorsMayTurn = true;
    for (int actions = random.Index(4); actions > 0; --actions)
        ActOnBody(stage);
    if (random.OnceIn(6))
        ActOnJoints(stage);
    if (random.OnceIn(15))
        ActOnWorld(stage);
    while (m_bodies.size() < m_wanted)
        CreateBody(stage);
    RescueLost(random);
    if (random.OnceIn(3))
        Probe(stage);
    // Last, for nothing may be put to sleep after it.
    if (random.OnceIn(4) && m_sensorsMayTurn && m_timeStep > 0.0f && !StepIsSleepy())
        TurnSensor(random);
    if (m_turnedInImpacts)
        WakeAll();
    RememberPlaces();
}

/// A sensor that turns solid must be looked at before it is solved, or Box2D asserts: a touching sensor has
/// no manifold. So everything it touches is woken.
void RandomWorld::TurnSensor(Random &random) {
    b2Body *body = SomeBody(random);
    b2Fixture *fixture = SomeFixture(random, body);
    if (fixture == nullptr)
        return;
    fixture->SetSensor(!fixture->IsSensor() && random.OnceIn(2));
    for (b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next)
        edge->other->SetAwake(true);
    body->SetAwake(true);
}

void RandomWorld::ActOnBody(Stage &stage) {
    Random &random = stage.Rng();
    b2Body *body = SomeBody(random);
    switch (random.Index(18)) {
    case 0:
        Destroy(stage.World(), body);
        break;
    case 1:
        body->SetTransform(Anywhere(random), random.Uniform(-b2_pi, b2_pi));
        break;
    case 2: // so near that what was known of its pairs almost holds
        body->SetTransform(body->GetPosition() + kMeter * random.Direction(0.0f, 0.05f),
                           body->GetAngle() + random.Uniform(-0.02f, 0.02f));
        break;
    case 3: { // two change places
        b2Body *other = SomeBody(random);
        const b2Vec2 place = body->GetPosition();
        body->SetTransform(other->GetPosition(), body->GetAngle());
        other->SetTransform(place, other->GetAngle());
        break;
    }
    case 4:
        body->SetType(static_cast<b2BodyType>(random.Index(3)));
        break;
    case 5: // back to dynamic more often than away from it, or in the end nothing moves
        body->SetType(b2_dynamicBody);
        break;
    case 6:
        body->SetEnabled(!body->IsEnabled());
        break;
    case 7:
        body->SetEnabled(true);
        break;
    case 8:
        body->SetAwake(!body->IsAwake());
        break;
    case 9:
        body->SetBullet(!body->IsBullet());
        break;
    case 10:
        body->SetLinearVelocity(kMeter * random.Direction(0.0f, random.OnceIn(3) ? 60.0f : 4.0f));
        body->SetAngularVelocity(random.Uniform(-10.0f, 10.0f));
        break;
    case 11:
        body->ApplyLinearImpulse(random.Direction(0.0f, 3.0f),
                                 body->GetPosition() + random.Direction(0.0f, 0.5f), random.OnceIn(2));
        break;
    case 12:
    case 13:
        ActOnShape(stage, body);
        break;
    default:
        ActOnFixture(stage, body);
    }
}

/// Fixtures come, go and are replaced.
void RandomWorld::ActOnShape(Stage &stage, b2Body *body) {
    Random &random = stage.Rng();
    b2Fixture *fixture = SomeFixture(random, body);
    switch (random.Index(6)) {
    case 0:
    case 1:
        AddPart(stage, body);
        break;
    case 2:
        if (fixture != nullptr && fixture->GetNext() != nullptr)
            body->DestroyFixture(fixture);
        break;
    case 3: // one after another, all of them; some bodies stay bare
        while (body->GetFixtureList() != nullptr)
            body->DestroyFixture(body->GetFixtureList());
        if (!random.OnceIn(3))
            FillBody(stage, body);
        break;
    default: // resized: another at the address of the old one
        if (fixture == nullptr)
            break;
        body->DestroyFixture(fixture);
        stage.AddFixture(body, SomeMaterial(random),
                         SomePolygon(random, kMeter * random.Direction(0.0f, 0.6f)));
    }
}

/// What is changed in place, without Box2D being told.
void RandomWorld::ActOnFixture(Stage &stage, b2Body *body) {
    Random &random = stage.Rng();
    b2Fixture *fixture = SomeFixture(random, body);
    if (fixture == nullptr)
        return;
    switch (random.Index(5)) {
    case 0: {
        b2Filter filter;
        filter.maskBits = random.OnceIn(2) ? 0xffff : 0x0001;
        filter.categoryBits = random.OnceIn(3) ? 0x0002 : 0x0001;
        filter.groupIndex = static_cast<int16>(random.Index(7) - 3);
        fixture->SetFilterData(filter);
        break;
    }
    case 1:
        fixture->SetFriction(random.Uniform(0.0f, 1.0f));
        fixture->SetDensity(random.Uniform(0.5f, 3.0f));
        body->ResetMassData();
        break;
    case 2:
        if (fixture->GetType() == b2Shape::e_polygon || fixture->GetType() == b2Shape::e_edge)
            fixture->GetShape()->m_radius = random.Uniform(-1.0f, 3.0f) * b2_polygonRadius;
        break;
    default:
        if (fixture->GetType() == b2Shape::e_polygon) {
            auto *polygon = static_cast<b2PolygonShape *>(fixture->GetShape());
            const float radius = polygon->m_radius;
            *polygon = SomePolygon(random, kMeter * random.Direction(0.0f, 0.4f));
            polygon->m_radius = radius;
            if (random.OnceIn(4))
                MoveVertex(random, polygon);
            if (random.OnceIn(2))
                body->ResetMassData();
        }
    }
}

void RandomWorld::ActOnJoints(Stage &stage) {
    Random &random = stage.Rng();
    if (m_joints.size() > m_wanted / 4 || (!m_joints.empty() && random.OnceIn(3))) {
        const auto joint = m_joints.begin() + static_cast<std::ptrdiff_t>(Pick(random, m_joints.size()));
        b2Joint *broken = *joint;
        m_joints.erase(joint);
        stage.World().DestroyJoint(broken);
        return;
    }
    b2Body *a = SomeBody(random), *b = SomeBody(random);
    const float distance = (a->GetPosition() - b->GetPosition()).Length();
    // Joints that begin far from rest would throw their bodies out of the world.
    if (a == b || distance > 3.0f * kMeter || distance < 0.1f * kMeter)
        return;
    if (random.OnceIn(2)) {
        b2RevoluteJointDef def;
        def.Initialize(a, b, 0.5f * (a->GetPosition() + b->GetPosition()));
        def.collideConnected = random.OnceIn(2);
        m_joints.push_back(stage.AddJoint(def));
    } else {
        b2DistanceJointDef def;
        def.Initialize(a, b, a->GetPosition(), b->GetPosition());
        def.collideConnected = random.OnceIn(2);
        m_joints.push_back(stage.AddJoint(def));
    }
}

void RandomWorld::ActOnWorld(Stage &stage) {
    Random &random = stage.Rng();
    b2World &world = stage.World();
    constexpr float kTimeSteps[] = {1.0f / 60.0f, 1.0f / 60.0f, 1.0f / 30.0f, 1.0f / 240.0f, 0.0f};
    switch (random.Index(8)) {
    case 0: // there and, sooner or later, back
        world.ShiftOrigin(m_arena->GetPosition() +
                          kMeter * random.Direction(0.0f, random.OnceIn(3) ? 700.0f : 50.0f));
        break;
    case 1:
        world.ShiftOrigin(m_arena->GetPosition());
        break;
    case 2:
        world.SetGravity(random.OnceIn(2) ? b2Vec2(0.0f, -10.0f * kMeter) : b2Vec2(0.0f, 0.0f));
        break;
    case 3:
        world.SetGravity(kMeter * random.Direction(0.0f, 12.0f));
        break;
    case 4:
        world.SetAllowSleeping(!world.GetAllowSleeping());
        break;
    case 5:
        world.SetContinuousPhysics(!random.OnceIn(4));
        break;
    case 6:
        world.SetSubStepping(random.OnceIn(3));
        break;
    default:
        m_timeStep = kTimeSteps[random.Index(5)];
    }
}

/// Asks contacts for their manifolds out of turn, as anybody may, at poses that are nobody's.
void RandomWorld::Probe(Stage &stage) {
    Random &random = stage.Rng();
    int skip = random.Index(8);
    for (b2Contact *c = stage.World().GetContactList(); c != nullptr; c = c->GetNext()) {
        if (skip-- > 0 || c->GetFixtureA()->GetType() != b2Shape::e_polygon)
            continue;
        skip = 8;
        b2Transform xfA = c->GetFixtureA()->GetBody()->GetTransform();
        const b2Transform xfB = c->GetFixtureB()->GetBody()->GetTransform();
        if (random.OnceIn(2))
            xfA.p += kMeter * random.Direction(0.0f, 0.3f);
        b2Manifold manifold;
        std::memset(static_cast<void *>(&manifold), 0x7f, sizeof manifold);
        c->Evaluate(&manifold, xfA, xfB);
        m_probes.Field("points", manifold.pointCount);
        for (int32 i = 0; i < manifold.pointCount; ++i) {
            m_probes.Field("x", manifold.points[i].localPoint.x);
            m_probes.Field("y", manifold.points[i].localPoint.y);
            m_probes.Field("id", static_cast<uint32_t>(manifold.points[i].id.key));
        }
    }
}

/// What has been squeezed out of the arena comes back in.
void RandomWorld::RescueLost(Random &random) {
    for (b2Body *body : m_bodies) {
        const b2Vec2 away = body->GetPosition() - m_arena->GetPosition();
        if (std::abs(away.x) < kHalfWidth + 2.0f * kMeter && std::abs(away.y) < kHalfHeight + 2.0f * kMeter)
            continue;
        body->SetTransform(Anywhere(random), 0.0f);
        body->SetLinearVelocity({0.0f, 0.0f});
        body->SetAngularVelocity(0.0f);
    }
}

} // namespace differential
