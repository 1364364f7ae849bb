// SPDX-License-Identifier: MIT
//
// Long thin slanted bodies: their bounding boxes overlap far and wide, they themselves hardly ever do.
#include <cmath>

#include "scene.h"
#include "shapes.h"

namespace testbed {
namespace {

constexpr float slant = 0.25f * b2_pi;

/// Hexagons slide down between static planks, fall off their ends and are put back on top.
class Planks final : public Scene {
    void Build(Stage &stage, int size) override {
        constexpr int planks = 19;
        for (int i = 0; i < planks; ++i) {
            b2Body *plank = stage.AddBody(b2_staticBody, {spacing * static_cast<float>(i), 0.0f}, slant);
            stage.AddFixture(plank, MakeBox(18.0f, 0.15f), 0.0f);
        }
        for (int i = 0; i < size; ++i) {
            // In the lanes between the planks, where a point at height y is y further to the right.
            const float y = stage.Rng().Uniform(-11.0f, 12.0f);
            const float lane = 0.5f + static_cast<float>(stage.Rng().Index(planks - 1));
            const float x = spacing * lane + y + stage.Rng().Uniform(-0.5f, 0.5f);
            b2Body *body = stage.AddBody(b2_dynamicBody, {x, y}, stage.Rng().Uniform(-b2_pi, b2_pi));
            stage.AddFixture(body, MakeRegular(6, 0.25f), 1.0f);
            m_hexagons.push_back(body);
        }
    }

    void BeforeStep(Stage &stage, int) override {
        constexpr float bottom = -16.0f, top = 16.0f;
        for (b2Body *body : m_hexagons) {
            if (body->GetPosition().y > bottom)
                continue;
            const float lane = 0.5f + static_cast<float>(stage.Rng().Index(18));
            const float x = spacing * lane + stage.Rng().Uniform(-0.5f, 0.5f) + 12.0f;
            body->SetTransform({x, top + stage.Rng().Uniform(-2.0f, 2.0f)}, body->GetAngle());
            body->SetLinearVelocity({0.0f, 0.0f});
        }
    }

    static constexpr float spacing = 2.75f;
    std::vector<b2Body *> m_hexagons;
};

/// Side by side without gravity, each with a slight drift and spin of its own.
class Drift final : public Scene {
public:
    Drift(float halfLength, float halfWidth, float spacing, float speed, float spin)
        : m_halfLength(halfLength), m_halfWidth(halfWidth), m_spacing(spacing), m_speed(speed), m_spin(spin) {
    }

private:
    void Build(Stage &stage, int size) override {
        stage.World().SetGravity({0.0f, 0.0f});
        const b2PolygonShape box = MakeBox(m_halfLength, m_halfWidth);
        const b2Vec2 across(std::sin(slant), -std::cos(slant));
        for (int i = 0; i < size; ++i) {
            b2BodyDef def;
            def.type = b2_dynamicBody;
            def.angle = slant;
            const float fromMiddle = static_cast<float>(i) - 0.5f * static_cast<float>(size - 1);
            def.position = m_spacing * fromMiddle * across;
            def.linearVelocity = stage.Rng().Direction(0.4f * m_speed, m_speed);
            def.angularVelocity = stage.Rng().Uniform(-m_spin, m_spin);
            stage.AddFixture(stage.AddBody(def), Material(1.0f, 0.2f, 0.5f), box);
        }
    }

    float m_halfLength, m_halfWidth, m_spacing, m_speed, m_spin;
};

std::unique_ptr<Scene> CreateNeedles() {
    return std::make_unique<Drift>(8.0f, 0.06f, 0.475f, 0.05f, 0.002f);
}
std::unique_ptr<Scene> CreatePlates() {
    return std::make_unique<Drift>(6.0f, 0.08f, 0.9f, 0.15f, 0.01f);
}

} // namespace

void AddLongThings(std::vector<SceneInfo> &scenes) {
    scenes.push_back({"planks", "hexagons slide and fall between 19 slanted static planks", "hard", 300, 300,
                      CreateScene<Planks>});
    scenes.push_back(
        {"needles", "long thin slanted boxes drift side by side", "hard", 300, 300, CreateNeedles});
    scenes.push_back(
        {"plates", "slanted plates drift side by side, further apart", "hard", 400, 300, CreatePlates});
}

} // namespace testbed
