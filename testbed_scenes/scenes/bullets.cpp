// SPDX-License-Identifier: MIT
//
// Bullets fly through a field of static and kinematic concave bodies: time of impact against many fixtures.
#include "scene.h"
#include "shapes.h"

namespace testbed {
namespace {

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
            const Outline outline = i % 2 == 0 ? StarOutline(triangles, 0.7f, 1.7f)
                                               : RoughOutline(stage.Rng(), triangles, 0.8f, 1.7f);
            AddFan(stage, stage.AddBody(def), outline, Material(0.0f, 0.3f, 0.3f));
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

} // namespace

void AddBullets(std::vector<SceneInfo> &scenes) {
    scenes.push_back({"bullets", "bullets fly through 84 static and kinematic concave bodies", "hard", 150,
                      300, CreateScene<Bullets>});
}

} // namespace testbed
