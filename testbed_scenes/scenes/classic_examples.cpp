// SPDX-License-Identifier: MIT
//
// Bodies of several shapes, and a sensor that acts on what it sees.
#include "scene.h"
#include "shapes.h"

namespace testbed {
namespace {

b2PolygonShape MakeTriangle(b2Vec2 a, b2Vec2 b, b2Vec2 c) {
    const b2Vec2 corners[] = {a, b, c};
    b2PolygonShape shape;
    shape.Set(corners, 3);
    return shape;
}

class Compound final : public Scene {
    struct Visitor {
        b2Body *host;
        bool ship;
    };

    void Build(Stage &stage, int size) override {
        const float halfWidth = 10.0f * static_cast<float>(size) + 30.0f;
        b2Body *ground = stage.AddBody(b2_staticBody, {0.0f, 0.0f});
        stage.AddFixture(ground, MakeEdge({halfWidth, 0.0f}, {-halfWidth, 0.0f}), 0.0f);
        for (int i = 0; i < size; ++i) {
            const float left = -20.0f * static_cast<float>(i);
            AddTable(stage, {left - 15.0f, 1.0f}, 1.5f);
            AddTable(stage, {left - 5.0f, 1.0f}, 2.0f);
            const float right = 20.0f * static_cast<float>(i);
            AddShip(stage, {right + 5.0f, 1.0f}, 0.0f, 4.0f / 3.0f);
            AddShip(stage, {right + 15.0f, 1.0f}, 1.0f, 2.0f);
        }
    }

    // Every half second something appears in the middle of each table and each ship.
    void BeforeStep(Stage &stage, int step) override {
        if (step == 0 || step > 240 || step % 30 != 0)
            return;
        for (const Visitor &visitor : m_hosts) {
            b2BodyDef def;
            def.type = b2_dynamicBody;
            def.position = visitor.host->GetPosition();
            def.angle = visitor.host->GetAngle();
            def.gravityScale = visitor.ship ? 0.0f : 1.0f;
            b2Body *body = stage.AddBody(def);
            if (visitor.ship)
                stage.AddFixture(body, MakeCircle(0.5f, {0.0f, 2.0f}), 2.0f);
            else
                stage.AddFixture(body, MakeBox(4.0f, 0.1f, {0.0f, 3.0f}), 2.0f);
        }
    }

    void AddTable(Stage &stage, b2Vec2 position, float halfLeg) {
        b2Body *table = stage.AddBody(b2_dynamicBody, position);
        stage.AddFixture(table, MakeBox(3.0f, 0.5f, {0.0f, 3.5f}), 2.0f);
        stage.AddFixture(table, MakeBox(0.5f, halfLeg, {-2.5f, halfLeg}), 2.0f);
        stage.AddFixture(table, MakeBox(0.5f, halfLeg, {2.5f, halfLeg}), 2.0f);
        m_hosts.push_back({table, false});
    }

    void AddShip(Stage &stage, b2Vec2 position, float noseX, float noseY) {
        b2Body *ship = stage.AddBody(b2_dynamicBody, position);
        stage.AddFixture(ship, MakeTriangle({-2.0f, 0.0f}, {noseX, noseY}, {0.0f, 4.0f}), 2.0f);
        stage.AddFixture(ship, MakeTriangle({2.0f, 0.0f}, {-noseX, noseY}, {0.0f, 4.0f}), 2.0f);
        m_hosts.push_back({ship, true});
    }

    std::vector<Visitor> m_hosts;
};

/// What touches the sensor is drawn to its centre.
class SensorsClassic final : public Scene {
    void Build(Stage &stage, int size) override {
        b2Body *ground = stage.AddBody(b2_staticBody, {0.0f, 0.0f});
        stage.AddFixture(ground, MakeEdge({-40.0f, 0.0f}, {40.0f, 0.0f}), 0.0f);
        b2FixtureDef eye = Material(0.0f);
        eye.isSensor = true;
        m_sensor = stage.AddFixture(ground, eye, MakeCircle(5.0f, {0.0f, 10.0f}));
        for (int i = 0; i < size; ++i) {
            b2Body *body = stage.AddBody(b2_dynamicBody, {-10.0f + 3.0f * static_cast<float>(i), 20.0f});
            if (i % 2 == 0)
                stage.AddFixture(body, MakeCircle(1.0f), 1.0f);
            else
                stage.AddFixture(body, MakeRegular(5, 1.0f), 1.0f);
        }
    }

    void BeforeStep(Stage &, int) override {
        for (b2Body *body : m_seen) {
            b2Vec2 pull = b2Vec2(0.0f, 10.0f) - body->GetPosition();
            pull.Normalize();
            body->ApplyForce(100.0f * pull, body->GetPosition(), false);
        }
    }

    bool Listens() const override { return true; }

    void OnBegin(b2Contact &contact) override {
        if (b2Body *body = SeenBody(contact))
            m_seen.push_back(body);
    }

    void OnEnd(b2Contact &contact) override {
        const b2Body *body = SeenBody(contact);
        for (std::size_t i = 0; i < m_seen.size(); ++i) {
            if (m_seen[i] == body) {
                m_seen.erase(m_seen.begin() + static_cast<std::ptrdiff_t>(i));
                return;
            }
        }
    }

    b2Body *SeenBody(b2Contact &contact) const {
        if (contact.GetFixtureA() == m_sensor)
            return contact.GetFixtureB()->GetBody();
        return contact.GetFixtureB() == m_sensor ? contact.GetFixtureA()->GetBody() : nullptr;
    }

    const b2Fixture *m_sensor = nullptr;
    std::vector<b2Body *> m_seen; // in the order of their coming
};

/// Polygons, discs and compounds on edge terrain and on chain terrain.
class Terrain final : public Scene {
    void Build(Stage &stage, int size) override {
        constexpr float width = 40.0f, distance = 60.0f;
        constexpr Swell swell = {0.4f, 1.5f, 0.3f};
        AddEdges(stage, MakeHills(stage.Rng(), {0.0f, 0.0f}, width, swell), 0.2f);
        AddChain(stage, MakeHills(stage.Rng(), {distance, 0.0f}, width, swell));
        for (int i = 0; i < size; ++i) {
            const float terrain = i % 2 == 0 ? 0.0f : distance;
            const float x = stage.Rng().Uniform(2.0f, width - 2.0f);
            const float y = stage.Rng().Uniform(4.0f, 18.0f);
            AddThing(stage, {terrain + x, y}, i / 2);
        }
    }

    static void AddThing(Stage &stage, b2Vec2 position, int kind) {
        b2Body *body = stage.AddBody(b2_dynamicBody, position, stage.Rng().Uniform(-b2_pi, b2_pi));
        switch (kind % 4) {
        case 0:
            stage.AddFixture(body, MakeBox(0.4f, 0.3f), 1.0f);
            break;
        case 1:
            stage.AddFixture(body, MakeRegular(3 + stage.Rng().Index(6), 0.45f), 1.0f);
            break;
        case 2:
            stage.AddFixture(body, MakeCircle(0.35f), 1.0f);
            break;
        default: // an L
            stage.AddFixture(body, MakeBox(0.5f, 0.12f), 1.0f);
            stage.AddFixture(body, MakeBox(0.12f, 0.4f, {0.4f, 0.4f}), 1.0f);
        }
    }
};

} // namespace

void AddClassicExamples(std::vector<SceneInfo> &scenes) {
    scenes.push_back({"compound", "tables and ships of several shapes; things appear inside them", "classic",
                      2, 300, CreateScene<Compound>});
    scenes.push_back({"sensors-classic", "a round sensor draws discs and pentagons to its centre", "classic",
                      7, 600, CreateScene<SensorsClassic>});
    scenes.push_back({"terrain", "boxes, polygons, discs and Ls on hills of edges and on hills of a chain",
                      "classic", 160, 300, CreateScene<Terrain>});
}

} // namespace testbed
