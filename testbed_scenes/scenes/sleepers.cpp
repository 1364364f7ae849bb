// SPDX-License-Identifier: MIT
//
// A world that sleeps: boxes that came to rest in pairs, one on the other, and a few balls that roll on among
// them somewhere else.
#include "scene.h"
#include "shapes.h"

namespace testbed {
namespace {

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

void AddSleepers(std::vector<SceneInfo> &scenes) {
    scenes.push_back({"sleepers", "thousands of boxes fall asleep, and twenty balls roll on", "hard", 10000,
                      400, CreateScene<Sleepers>});
}

} // namespace testbed
