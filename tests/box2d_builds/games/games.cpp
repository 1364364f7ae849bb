// SPDX-License-Identifier: MIT
// The named games: many pairs at once, steps of another world in the midst of a step, shapes that are changed
// in place, worlds that are drawn.
#include "game.h"
#include "shapes.h"
#include "state/snapshot.h"

namespace box2d_builds {

namespace {

void AddBoxes(testbed::Stage &stage, int count, bool bullets) {
    b2Body *ground = stage.AddBody(b2_staticBody, {0.0f, -1.0f});
    stage.AddFixture(ground, testbed::MakeBox(8.0f, 0.5f), 0.0f);
    for (int i = 0; i < count; ++i) {
        b2BodyDef def;
        def.type = b2_dynamicBody;
        def.bullet = bullets && i % 2 == 0;
        def.position = {0.62f * static_cast<float>(i % 8) - 2.0f, 0.7f * static_cast<float>(i / 8)};
        def.angle = 0.05f * static_cast<float>(i % 5);
        def.linearVelocity = {0.0f, bullets ? -30.0f : 0.0f};
        stage.AddFixture(stage.AddBody(def), testbed::Material(1.0f, 0.4f, bullets ? 0.5f : 0.0f),
                         testbed::MakeBox(0.28f, 0.3f));
    }
}

/// Box2D begins with room for 16 pairs of boxes: the first step finds many more.
class Heap final : public Game {
public:
    void Build(testbed::Stage &stage, int) override { AddBoxes(stage, 64, false); }
};

/// Listeners of one world step another one, whose impacts are solved in the midst of this one's.
class OtherWorld final : public Game {
public:
    OtherWorld() : m_otherStage(m_otherScene, 2, &m_otherEvents) { m_otherEvents.StartStep(false); }
    void Build(testbed::Stage &stage, int) override {
        AddBoxes(stage, 24, true);
        AddBoxes(m_otherStage, 32, true);
    }
    void BeforeStep(testbed::Stage &, int) override { m_mayStep = 3; }
    void OnBegin(b2Contact &) override { StepOther(); }
    void OnEnd(b2Contact &) override { StepOther(); }
    void OnPreSolve(b2Contact &, const b2Manifold &) override { StepOther(); }
    void OnPostSolve(b2Contact &, const b2ContactImpulse &) override { StepOther(); }

private:
    void StepOther() {
        if (m_mayStep == 0 || ++m_told % 7 != 0)
            return;
        --m_mayStep;
        m_otherEvents.StartStep(false);
        m_otherStage.World().Step(1.0f / 60.0f, 8, 3);
        const testbed::StateHashes hashes = testbed::HashState(m_otherStage.World(), m_otherEvents);
        m_probes.Field("bodies", hashes.bodies);
        m_probes.Field("contacts", hashes.contacts);
        m_probes.Field("events", hashes.events);
    }

    class Nothing final : public testbed::Scene {
        void Build(testbed::Stage &, int) override {}
    } m_otherScene;
    testbed::EventRecorder m_otherEvents;
    testbed::Stage m_otherStage;
    int m_mayStep = 0;
    unsigned m_told = 0;
};

/// Moves all vertices away from the middle of the body, or toward it once one is farther than `reach`.
/// Normals stay right, and Box2D is not told.
void ScaleInPlace(b2PolygonShape *polygon, float reach) {
    float farthest = 0.0f;
    for (int32 i = 0; i < polygon->m_count; ++i)
        farthest = b2Max(farthest, polygon->m_vertices[i].Length());
    const float factor = farthest > reach ? 0.75f : 1.25f;
    for (int32 i = 0; i < polygon->m_count; ++i)
        polygon->m_vertices[i] *= factor;
    polygon->m_centroid *= factor;
}

/// A tumbling crowd of wheels of several fixtures, whose vertices and radii a listener changes in the midst
/// of steps.
class Edits final : public Game {
public:
    void Build(testbed::Stage &stage, int) override {
        stage.World().SetGravity({0.0f, -2.0f});
        testbed::AddArena(stage, {0.0f, 0.0f}, 3.0f, 2.5f, 0.8f);
        for (int i = 0; i < 9; ++i) {
            b2BodyDef def;
            def.type = b2_dynamicBody;
            def.bullet = i % 3 == 0;
            def.position = {1.7f * static_cast<float>(i % 3 - 1), 1.4f * static_cast<float>(i / 3 - 1)};
            def.linearVelocity = {9.0f - 2.0f * static_cast<float>(i), 3.0f};
            def.angularVelocity = static_cast<float>(i % 4) - 1.5f;
            def.allowSleep = false;
            b2Body *body = stage.AddBody(def);
            testbed::AddFan(stage, body, testbed::StarOutline(8 + 2 * (i % 3), 0.3f, 0.6f),
                            testbed::Material(1.0f, 0.2f, 0.7f));
        }
    }
    void OnBegin(b2Contact &contact) override { Edit(contact, 0); }
    void OnEnd(b2Contact &contact) override { Edit(contact, 1); }
    void OnPreSolve(b2Contact &contact, const b2Manifold &) override { Edit(contact, 2); }
    void OnPostSolve(b2Contact &contact, const b2ContactImpulse &) override { Edit(contact, 3); }

private:
    void Edit(b2Contact &contact, unsigned occasion) {
        const unsigned number = m_told++ * 4 + occasion;
        if (number % 5 != 0)
            return;
        b2Body *body = contact.GetFixtureB()->GetBody();
        if (number % 2 == 0 && body->GetNext() != nullptr)
            body = body->GetNext();
        if (body->GetType() != b2_dynamicBody)
            return;
        b2Fixture *fixture = body->GetFixtureList();
        for (unsigned skip = number / 7 % 8; skip > 0 && fixture->GetNext() != nullptr; --skip)
            fixture = fixture->GetNext();
        b2PolygonShape &polygon = *static_cast<b2PolygonShape *>(fixture->GetShape());
        if (number % 3 == 0) {
            polygon.m_radius = (polygon.m_radius > b2_polygonRadius ? 1.0f : 6.0f) * b2_polygonRadius;
            return;
        }
        ScaleInPlace(&polygon, 0.6f);
    }

    unsigned m_told = 0;
};

/// Hashes what b2World::DebugDraw draws, in order.
class Drawn final : public b2Draw {
public:
    uint64_t Hash() const { return m_hash.Value(); }

    void DrawPolygon(const b2Vec2 *vertices, int32 count, const b2Color &color) override {
        Add(1, vertices, count, color);
    }
    void DrawSolidPolygon(const b2Vec2 *vertices, int32 count, const b2Color &color) override {
        Add(2, vertices, count, color);
    }
    void DrawCircle(const b2Vec2 &center, float radius, const b2Color &color) override {
        m_hash.Field("radius", radius);
        Add(3, &center, 1, color);
    }
    void DrawSolidCircle(const b2Vec2 &center, float radius, const b2Vec2 &axis,
                         const b2Color &color) override {
        const b2Vec2 both[] = {center, axis};
        m_hash.Field("radius", radius);
        Add(4, both, 2, color);
    }
    void DrawSegment(const b2Vec2 &p1, const b2Vec2 &p2, const b2Color &color) override {
        const b2Vec2 both[] = {p1, p2};
        Add(5, both, 2, color);
    }
    void DrawTransform(const b2Transform &xf) override {
        m_hash.Field("s", xf.q.s);
        m_hash.Field("c", xf.q.c);
        Add(6, &xf.p, 1, b2Color(0.0f, 0.0f, 0.0f));
    }
    void DrawPoint(const b2Vec2 &p, float size, const b2Color &color) override {
        m_hash.Field("size", size);
        Add(7, &p, 1, color);
    }

private:
    void Add(uint32_t what, const b2Vec2 *points, int32 count, const b2Color &color) {
        m_hash.Field("what", what);
        for (int32 i = 0; i < count; ++i) {
            m_hash.Field("x", points[i].x);
            m_hash.Field("y", points[i].y);
        }
        for (const float part : {color.r, color.g, color.b, color.a})
            m_hash.Field("color", part);
    }

    testbed::HashSink m_hash;
};

/// Draws its world between steps and in the midst of them.
class Draws final : public Game {
public:
    void Build(testbed::Stage &stage, int) override {
        m_world = &stage.World();
        m_drawn.SetFlags(b2Draw::e_shapeBit | b2Draw::e_aabbBit | b2Draw::e_pairBit |
                         b2Draw::e_centerOfMassBit | b2Draw::e_jointBit);
        m_world->SetDebugDraw(&m_drawn);
        b2Body *ground = stage.AddBody(b2_staticBody, {0.0f, -1.0f});
        stage.AddFixture(ground, testbed::MakeBox(8.0f, 0.5f), 0.0f);
        b2Body *previous = nullptr;
        for (int i = 0; i < 12; ++i) {
            b2Body *body = stage.AddBody(b2_dynamicBody,
                                         {0.8f * static_cast<float>(i % 4), 0.8f * static_cast<float>(i / 4)},
                                         0.3f * static_cast<float>(i));
            stage.AddFixture(body, testbed::MakeRegular(3 + i % 6, 0.4f), 1.0f);
            if (i % 3 == 1)
                stage.AddHinge(previous, body, body->GetPosition());
            previous = body;
        }
    }
    void BeforeStep(testbed::Stage &, int) override { m_world->DebugDraw(); }
    void OnPreSolve(b2Contact &, const b2Manifold &) override { m_world->DebugDraw(); }
    void OnPostSolve(b2Contact &, const b2ContactImpulse &) override { m_world->DebugDraw(); }
    uint64_t Probes() const override { return m_drawn.Hash(); }

private:
    b2World *m_world = nullptr;
    Drawn m_drawn;
};

template <typename T> std::unique_ptr<Game> Create() {
    return std::make_unique<T>();
}

} // namespace

const std::vector<GameInfo> kGames = {
    {"heap", "more pairs in a step than Box2D has room for at first", 120, Create<Heap>},
    {"other-world", "listeners step another world", 100, Create<OtherWorld>},
    {"edits", "listeners change vertices and radii in place", 200, Create<Edits>},
    {"draws", "the world is drawn between steps and in the midst of them", 120, Create<Draws>}};

} // namespace box2d_builds
