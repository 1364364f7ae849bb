// SPDX-License-Identifier: MIT
//
// Everything a game may do to a world between steps and in callbacks, at random, all the time. What it is
// for: whoever remembers something about fixtures or pairs must notice each of these.
#include <algorithm>
#include <cmath>

#include "scene.h"
#include "shapes.h"

namespace testbed {
namespace {

class Churn final : public Scene {
    void Build(Stage &stage, int size) override {
        m_wanted = static_cast<std::size_t>(size);
        m_arena = AddArena(stage, {0.0f, 0.0f}, halfWidth, halfHeight, 0.3f);
        // A bumpy floor of edges and a few rocks, so that polygons meet everything they can meet.
        Outline floor;
        for (int i = 0; i <= 20; ++i)
            floor.emplace_back(halfWidth * (1.0f - 0.1f * static_cast<float>(i)),
                               stage.Rng().Uniform(0.2f, 1.0f) - halfHeight);
        b2ChainShape chain;
        chain.CreateChain(floor.data(), static_cast<int32>(floor.size()), floor.front() + b2Vec2(1.0f, 0.0f),
                          floor.back() - b2Vec2(1.0f, 0.0f));
        stage.AddFixture(m_arena, chain, 0.0f);
        for (int i = 0; i < 6; ++i) {
            b2BodyDef def;
            def.position = Anywhere(stage);
            if (i % 2 == 0) {
                def.type = b2_kinematicBody;
                def.angularVelocity = stage.Rng().Uniform(-2.0f, 2.0f);
            }
            const Outline outline = RoughOutline(stage.Rng(), 7 + i, 0.6f, 1.4f);
            AddFan(stage, stage.AddBody(def), outline, Material(0.0f));
        }
        for (int i = 0; i < size; ++i)
            CreateBody(stage);
    }

    void BeforeStep(Stage &stage, int step) override {
        m_step = step;
        // Times of impact survive an unfinished sub-step, until a whole step has been done.
        if (stage.World().GetSubStepping())
            m_sensorsMayTurn = false;
        else if (stage.World().GetContinuousPhysics())
            m_sensorsMayTurn = true;
        const int actions = 4 + stage.Rng().Index(5);
        for (int i = 0; i < actions; ++i)
            ActOnOne(stage);
        if (stage.Rng().OnceIn(4))
            ActOnJoints(stage);
        if (stage.Rng().OnceIn(12))
            ActOnWorld(stage);
        while (m_bodies.size() < m_wanted)
            CreateBody(stage);
        RescueLost(stage);
        // Last, for nothing may be put to sleep after it.
        if (stage.Rng().OnceIn(2) && m_sensorsMayTurn) {
            b2Body *body = SomeBody(stage.Rng());
            b2Fixture *fixture = SomeFixture(stage.Rng(), body);
            SetSensor(body, fixture, stage.Rng().OnceIn(4) && !fixture->IsSensor());
        }
        m_continuous = stage.World().GetContinuousPhysics();
    }

    // What a listener may do. The choices hang on numbers and the step alone: Stage::Rng would be right too,
    // but one call more or less would then change all that follows, and hide where two runs began to differ.
    bool Listens() const override { return true; }

    void OnBegin(b2Contact &contact) override {
        const uint32_t mixed = Mix(contact);
        if (mixed % 7 == 0)
            contact.GetFixtureB()->GetBody()->SetBullet(mixed % 2 == 0);
        // Only ever on, for a touching sensor that turns solid in mid-step has no manifold, which Box2D
        // asserts against; and not where a time of impact may be known, for Box2D does not ask again whether
        // such a contact is solid, and asserts likewise.
        if (mixed % 41 == 0 && m_sensorsMayTurn && !m_continuous &&
            contact.GetFixtureA()->GetBody() != m_arena)
            contact.GetFixtureA()->SetSensor(true);
    }

    void OnEnd(b2Contact &contact) override {
        const uint32_t mixed = Mix(contact);
        if (mixed % 5 == 0)
            contact.GetFixtureA()->GetBody()->SetBullet(mixed % 2 == 0);
        if (mixed % 11 == 0)
            contact.GetFixtureB()->SetFriction(0.1f * static_cast<float>(mixed % 10));
    }

    void OnPreSolve(b2Contact &contact, const b2Manifold &) override {
        const uint32_t mixed = Mix(contact);
        if (mixed % 13 == 0)
            contact.SetEnabled(false);
        if (mixed % 17 == 0)
            contact.ResetFriction();
        if (mixed % 19 == 0)
            contact.SetFriction(0.05f * static_cast<float>(mixed % 20));
        if (mixed % 23 == 0)
            contact.SetRestitution(0.02f * static_cast<float>(mixed % 20));
        if (mixed % 29 == 0)
            contact.ResetRestitution();
        if (mixed % 31 == 0)
            contact.SetTangentSpeed(static_cast<float>(mixed % 5) - 2.0f);
        if (mixed % 37 == 0)
            contact.SetRestitutionThreshold(static_cast<float>(mixed % 3));
    }

    void OnGoodbye(b2Joint &joint) override {
        m_joints.erase(std::remove(m_joints.begin(), m_joints.end(), &joint), m_joints.end());
    }

    uint32_t Mix(b2Contact &contact) const {
        const uint32_t a =
            NumberOf(*contact.GetFixtureA()->GetBody()) * 8u + NumberOf(*contact.GetFixtureA());
        const uint32_t b =
            NumberOf(*contact.GetFixtureB()->GetBody()) * 8u + NumberOf(*contact.GetFixtureB());
        // The multiplier of Knuth's multiplicative hashing; the low bits are the poorest, so they go.
        return ((a * 31u + b) * 31u + static_cast<uint32_t>(m_step)) * 2654435761u >> 8;
    }

    b2Vec2 Anywhere(Stage &stage) const {
        const float x = stage.Rng().Uniform(-0.9f, 0.9f) * halfWidth;
        const float y = stage.Rng().Uniform(-0.8f, 0.9f) * halfHeight;
        return m_arena->GetPosition() + b2Vec2(x, y);
    }

    void CreateBody(Stage &stage) {
        Random &random = stage.Rng();
        b2BodyDef def;
        def.type = b2_dynamicBody;
        def.position = Anywhere(stage);
        def.angle = random.Uniform(-b2_pi, b2_pi);
        def.linearVelocity = random.Direction(0.0f, 8.0f);
        def.angularVelocity = random.Uniform(-3.0f, 3.0f);
        def.bullet = random.OnceIn(5);
        def.fixedRotation = random.OnceIn(12);
        def.allowSleep = !random.OnceIn(10);
        b2Body *body = stage.AddBody(def);
        m_bodies.push_back(body);
        switch (random.Index(6)) {
        // (One statement for each: the order in which a compiler evaluates arguments must not decide the
        // scene.)
        case 0: {
            const b2FixtureDef material = SomeMaterial(random);
            const float radius = random.Uniform(0.4f, 0.8f);
            AddConvex(stage, body, RegularOutline(9 + random.Index(40), radius), material);
            break;
        }
        case 1: {
            const int count = 5 + random.Index(8);
            const b2FixtureDef material = SomeMaterial(random);
            AddFan(stage, body, RoughOutline(random, count, 0.4f, 0.9f), material);
            break;
        }
        case 2: {
            b2FixtureDef eye = SomeMaterial(random);
            eye.isSensor = true;
            stage.AddFixture(body, eye, MakeRegular(6, 1.5f));
            AddPart(stage, body);
            break;
        }
        default:
            AddPart(stage, body);
        }
    }

    static b2FixtureDef SomeMaterial(Random &random) {
        const float friction = random.Uniform(0.0f, 0.8f);
        return Material(1.0f, friction, random.OnceIn(3) ? 0.6f : 0.0f);
    }

    /// One more fixture, somewhere on the body.
    static void AddPart(Stage &stage, b2Body *body) {
        Random &random = stage.Rng();
        const b2Vec2 center = random.Direction(0.0f, 0.4f);
        const b2FixtureDef def = SomeMaterial(random);
        if (random.OnceIn(5)) {
            stage.AddFixture(body, def, MakeCircle(random.Uniform(0.15f, 0.4f), center));
        } else if (random.OnceIn(2)) {
            const float radius = random.Uniform(0.25f, 0.6f);
            stage.AddFixture(body, def, MakeRegular(3 + random.Index(6), radius));
        } else {
            const float angle = random.Uniform(0.0f, 3.0f);
            stage.AddFixture(body, def, MakeBox(random.Uniform(0.1f, 0.8f), 0.2f, center, angle));
        }
    }

    b2Body *SomeBody(Random &random) const {
        return m_bodies[static_cast<std::size_t>(random.Index(static_cast<int>(m_bodies.size())))];
    }

    static b2Fixture *SomeFixture(Random &random, b2Body *body) {
        int count = 0;
        for (b2Fixture *fixture = body->GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext())
            ++count;
        b2Fixture *fixture = body->GetFixtureList();
        for (int skip = random.Index(count); skip > 0; --skip)
            fixture = fixture->GetNext();
        return fixture;
    }

    void ActOnOne(Stage &stage) {
        Random &random = stage.Rng();
        const std::size_t index = static_cast<std::size_t>(random.Index(static_cast<int>(m_bodies.size())));
        b2Body *body = m_bodies[index];
        switch (random.Index(16)) {
        case 0:
            m_bodies.erase(m_bodies.begin() + static_cast<std::ptrdiff_t>(index));
            stage.World().DestroyBody(body);
            break;
        case 1: {
            const float angle = random.Uniform(-b2_pi, b2_pi);
            body->SetTransform(Anywhere(stage), angle);
            break;
        }
        case 2: { // a nudge: near enough that what was known of the pair almost holds
            const float turn = random.Uniform(-0.02f, 0.02f);
            body->SetTransform(body->GetPosition() + random.Direction(0.0f, 0.05f), body->GetAngle() + turn);
            break;
        }
        case 3:
            body->SetType(static_cast<b2BodyType>(random.Index(3)));
            break;
        case 4: // back to dynamic more often than away from it, or in the end nothing moves
            body->SetType(b2_dynamicBody);
            break;
        case 5:
            body->SetEnabled(!body->IsEnabled());
            break;
        case 6:
            body->SetEnabled(true);
            break;
        case 7:
            body->SetAwake(!body->IsAwake());
            break;
        case 8:
            body->SetBullet(!body->IsBullet());
            break;
        case 9:
            body->SetFixedRotation(random.OnceIn(3));
            body->SetGravityScale(random.Uniform(-0.2f, 1.0f));
            break;
        case 10:
            body->SetLinearVelocity(random.Direction(0.0f, 30.0f));
            body->SetAngularVelocity(random.Uniform(-10.0f, 10.0f));
            break;
        case 11:
            AddPart(stage, body);
            break;
        case 12:
            if (body->GetFixtureList()->GetNext() != nullptr)
                body->DestroyFixture(SomeFixture(random, body));
            break;
        default:
            ActOnFixture(random, body, SomeFixture(random, body));
        }
    }

    static void ActOnFixture(Random &random, b2Body *body, b2Fixture *fixture) {
        switch (random.Index(3)) {
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
            fixture->SetRestitution(random.Uniform(0.0f, 0.5f));
            fixture->SetDensity(random.Uniform(0.5f, 3.0f));
            body->ResetMassData();
            break;
        default:
            fixture->Refilter();
            // The radius of a shape is the game's to change, at any time.
            if (fixture->GetType() == b2Shape::e_polygon)
                fixture->GetShape()->m_radius = random.Uniform(0.5f, 2.0f) * b2_polygonRadius;
        }
    }

    /// A sensor that turns solid must be looked at before it is solved, or Box2D asserts: a touching sensor
    /// has no manifold. So everything it touches is woken.
    static void SetSensor(b2Body *body, b2Fixture *fixture, bool sensor) {
        fixture->SetSensor(sensor);
        for (b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next)
            edge->other->SetAwake(true);
        body->SetAwake(true);
    }

    void ActOnJoints(Stage &stage) {
        Random &random = stage.Rng();
        if (m_joints.size() > m_wanted / 4 || (!m_joints.empty() && random.OnceIn(3))) {
            const int index = random.Index(static_cast<int>(m_joints.size()));
            b2Joint *joint = m_joints[static_cast<std::size_t>(index)];
            m_joints.erase(m_joints.begin() + index);
            stage.World().DestroyJoint(joint);
            return;
        }
        b2Body *a = SomeBody(random);
        b2Body *b = SomeBody(random);
        const float distance = (a->GetPosition() - b->GetPosition()).Length();
        // Joints that begin far from rest would throw their bodies out of the world.
        if (a == b || distance > 3.0f || distance < 0.1f)
            return;
        m_joints.push_back(CreateJoint(stage, a, b, random.OnceIn(2)));
    }

    static b2Joint *CreateJoint(Stage &stage, b2Body *a, b2Body *b, bool collide) {
        const b2Vec2 middle = 0.5f * (a->GetPosition() + b->GetPosition());
        switch (stage.Rng().Index(4)) {
        case 0: {
            b2RevoluteJointDef def;
            def.Initialize(a, b, middle);
            def.collideConnected = collide;
            return stage.AddJoint(def);
        }
        case 1: {
            b2WeldJointDef def;
            def.Initialize(a, b, middle);
            def.collideConnected = collide;
            return stage.AddJoint(def);
        }
        case 2: {
            b2PrismaticJointDef def;
            def.Initialize(a, b, middle, {1.0f, 0.0f});
            def.lowerTranslation = -1.0f;
            def.upperTranslation = 1.0f;
            def.enableLimit = true;
            def.collideConnected = collide;
            return stage.AddJoint(def);
        }
        default: {
            b2DistanceJointDef def;
            def.Initialize(a, b, a->GetPosition(), b->GetPosition());
            def.collideConnected = collide;
            return stage.AddJoint(def);
        }
        }
    }

    void ActOnWorld(Stage &stage) {
        Random &random = stage.Rng();
        b2World &world = stage.World();
        switch (random.Index(8)) {
        case 0: // there and, sooner or later, back
            world.ShiftOrigin(m_arena->GetPosition() + random.Direction(0.0f, 200.0f));
            break;
        case 1:
            world.ShiftOrigin(m_arena->GetPosition());
            break;
        case 2:
            world.SetGravity(random.OnceIn(2) ? b2Vec2(0.0f, -10.0f) : b2Vec2(0.0f, 0.0f));
            break;
        case 3:
            world.SetGravity(random.Direction(0.0f, 12.0f));
            break;
        case 4:
            world.SetAllowSleeping(!world.GetAllowSleeping());
            break;
        case 5:
            world.SetContinuousPhysics(random.Index(4) != 0);
            break;
        case 6:
            world.SetSubStepping(random.OnceIn(3));
            break;
        default:
            world.SetWarmStarting(random.Index(4) != 0);
        }
    }

    /// What has been squeezed out of the arena comes back in.
    void RescueLost(Stage &stage) {
        for (b2Body *body : m_bodies) {
            const b2Vec2 away = body->GetPosition() - m_arena->GetPosition();
            if (std::abs(away.x) < halfWidth + 3.0f && std::abs(away.y) < halfHeight + 3.0f)
                continue;
            body->SetTransform(Anywhere(stage), 0.0f);
            body->SetLinearVelocity({0.0f, 0.0f});
        }
    }

    static constexpr float halfWidth = 14.0f, halfHeight = 9.0f;
    std::size_t m_wanted = 0;
    int m_step = 0;
    bool m_sensorsMayTurn = true;
    bool m_continuous = true; ///< in the step that follows
    b2Body *m_arena = nullptr;
    std::vector<b2Body *> m_bodies;
    std::vector<b2Joint *> m_joints;
};

} // namespace

void AddChurn(std::vector<SceneInfo> &scenes) {
    scenes.push_back(
        {"churn", "bodies, fixtures and joints made, changed and destroyed all the time, also in callbacks",
         "hard", "bodies", 120, 600, CreateScene<Churn>});
}

} // namespace testbed
