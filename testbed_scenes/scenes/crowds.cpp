// SPDX-License-Identifier: MIT
//
// Crowds, each of which asks one thing of Box2D: bullets for times of impact, fans for sensors, sleepers for
// nothing at all.
#include <cmath>

#include "scene.h"
#include "shapes.h"

namespace testbed {
namespace {

/// Bullets fly through a field of static and kinematic concave bodies: time of impact against many fixtures.
class Bullets final : public Scene {
    void Build(Stage &stage, int size) override {
        AddArena(stage, {0.0f, 0.0f}, halfWidth, halfHeight, 0.3f);
        AddTargets(stage);
        for (int i = 0; i < size; ++i) {
            b2BodyDef def;
            def.type = b2_dynamicBody;
            def.bullet = true;
            b2Body *bullet = stage.AddBody(def);
            stage.AddFixture(bullet, Material(10.0f, 0.3f, 0.3f),
                             i % 2 == 0 ? MakeRegular(6, 0.12f) : MakeBox(0.2f, 0.05f));
            m_bullets.push_back(bullet);
            Shoot(stage, bullet);
        }
    }

    // Each is shot anew every two and a half seconds; they take turns. In between it comes to rest in some
    // nook.
    void BeforeStep(Stage &stage, int step) override {
        constexpr int interval = 150;
        for (std::size_t i = 0; i < m_bullets.size(); ++i)
            if (step > 0 && (static_cast<int>(i) + step) % interval == 0)
                Shoot(stage, m_bullets[i]);
    }

    static void AddTargets(Stage &stage) {
        constexpr int columns = 12, rows = 7;
        for (int i = 0; i < columns * rows; ++i) {
            b2BodyDef def;
            def.position.Set(spacing * (static_cast<float>(i % columns) - 0.5f * (columns - 1)),
                             spacing * (static_cast<float>(i / columns) - 0.5f * (rows - 1)));
            def.angle = stage.Rng().Uniform(-b2_pi, b2_pi);
            if (i % 3 == 0) {
                def.type = b2_kinematicBody;
                def.angularVelocity = stage.Rng().Uniform(-2.0f, 2.0f);
            }
            const int triangles = 10 + stage.Rng().Index(22);
            const Vertices vertices = i % 2 == 0 ? StarVertices(triangles, 0.7f, 1.7f)
                                                 : RoughVertices(stage.Rng(), triangles, 0.8f, 1.7f);
            OutlinedBody(BodyKind::Many, StarShaped(vertices))
                .AddTo(stage, stage.AddBody(def), Material(0.0f, 0.3f, 0.3f));
        }
    }

    static void Shoot(Stage &stage, b2Body *bullet) {
        const float side = stage.Rng().OnceIn(2) ? -1.0f : 1.0f;
        const float y = stage.Rng().Uniform(-0.9f, 0.9f) * halfHeight;
        bullet->SetTransform({side * (halfWidth - 1.0f), y}, stage.Rng().Uniform(-b2_pi, b2_pi));
        const float speed = stage.Rng().Uniform(40.0f, 110.0f);
        bullet->SetLinearVelocity({-side * speed, stage.Rng().Uniform(-20.0f, 20.0f)});
        bullet->SetAngularVelocity(stage.Rng().Uniform(-10.0f, 10.0f));
    }

    static constexpr float spacing = 4.0f, halfWidth = 28.0f, halfHeight = 15.0f;
    std::vector<b2Body *> m_bullets;
};

/// A sector of a disc with its corner at the origin, in 8 vertices.
b2PolygonShape MakeFan(float reach, float halfAngle) {
    constexpr int onArc = b2_maxPolygonVertices - 1;
    Vertices vertices{{0.0f, 0.0f}};
    for (int i = 0; i < onArc; ++i) {
        const float angle = halfAngle * (2.0f * static_cast<float>(i) / (onArc - 1) - 1.0f);
        vertices.emplace_back(reach * std::cos(angle), reach * std::sin(angle));
    }
    b2PolygonShape fan;
    fan.Set(vertices.data(), static_cast<int32>(vertices.size()));
    return fan;
}

/// Bodies that look about: each carries a fan-shaped sensor that reaches far beyond it.
class Sensors final : public Scene {
    void Build(Stage &stage, int size) override {
        constexpr float reach = 5.0f, halfAngle = 0.4f;
        stage.World().SetGravity({0.0f, 0.0f});
        const Grid grid(size, 15, 4.35f);
        b2Body *arena = AddArena(stage, {0.0f, 0.0f}, grid.halfWidth, grid.halfHeight, 1.0f);
        // The fans look at each other, not at the walls.
        for (b2Fixture *wall = arena->GetFixtureList(); wall != nullptr; wall = wall->GetNext()) {
            b2Filter filter;
            filter.categoryBits = walls;
            wall->SetFilterData(filter);
        }
        b2FixtureDef eye = Material(0.0f);
        eye.isSensor = true;
        eye.filter.maskBits = static_cast<uint16>(0xffff & ~walls);
        for (int i = 0; i < size; ++i) {
            const b2BodyDef def = Drifting(stage.Rng(), grid.Place(i), 0.5f, 3.0f, 1.5f);
            b2Body *body = stage.AddBody(def);
            AnySizePolygon(BodyKind::Many, RegularVertices(32, 0.5f))
                .AddTo(stage, body, Material(1.0f, 0.1f, 1.0f));
            stage.AddFixture(body, eye, MakeFan(reach, halfAngle));
        }
    }

    static constexpr uint16 walls = 0x0002;
};

/// A world that sleeps: boxes that came to rest in pairs, one on the other, and a few balls that roll on
/// among them somewhere else.
class Sleepers final : public Scene {
    void Build(Stage &stage, int size) override {
        constexpr float kApart = 1.2f, kBox = 0.5f;
        constexpr int kInRow = 400, kBalls = 20;
        constexpr float halfWidth = 0.5f * kApart * static_cast<float>(kInRow) + 1.0f;
        const b2PolygonShape box = MakeBox(kBox, kBox), floor = MakeBox(halfWidth, 0.25f);
        for (int i = 0; i < size / 2; ++i) {
            const float y = 4.0f * static_cast<float>(i / kInRow);
            if (i % kInRow == 0)
                stage.AddFixture(stage.AddBody(b2_staticBody, {0.0f, y - 0.25f}), floor, 0.0f);
            const float x = kApart * (static_cast<float>(i % kInRow) - 0.5f * static_cast<float>(kInRow - 1));
            // They are awake until they have found each other, and fall asleep at once: they rest.
            for (const float up : {kBox, 3.0f * kBox})
                stage.AddFixture(stage.AddBody(b2_dynamicBody, {x, y + up}), box, 1.0f);
        }
        stage.AddFixture(stage.AddBody(b2_staticBody, {0.0f, -20.25f}), floor, 0.0f);
        b2CircleShape ball;
        ball.m_radius = 0.4f;
        for (int i = 0; i < kBalls; ++i) {
            b2BodyDef def;
            def.type = b2_dynamicBody;
            def.position.Set(static_cast<float>(2 * i - kBalls), -19.5f);
            def.linearVelocity.Set(stage.Rng().Uniform(-1.0f, 1.0f), 0.0f);
            def.allowSleep = false;
            stage.AddFixture(stage.AddBody(def), ball, 1.0f);
        }
    }
};

} // namespace

void AddCrowds(std::vector<SceneInfo> &scenes) {
    scenes.push_back({"bullets", "bullets fly through 84 static and kinematic concave bodies", "hard", 150,
                      300, CreateScene<Bullets>});
    scenes.push_back({"sensors", "drifting 32-gons, each with a fan-shaped polygon sensor of reach 5", "hard",
                      150, 300, CreateScene<Sensors>});
    scenes.push_back({"sleepers", "thousands of boxes fall asleep, and twenty balls roll on", "hard", 10000,
                      400, CreateScene<Sleepers>});
}

} // namespace testbed
