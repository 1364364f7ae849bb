// SPDX-License-Identifier: MIT
//
// Single bodies of polygons of any size, whose motion is known: a stack that stands, wheels that roll, a
// planet that holds what lies on it.
#include <cmath>

#include "scene.h"
#include "shapes.h"

namespace testbed {
namespace {

/// What two polygons keep between them where they touch.
constexpr float kSkins = 2.0f * b2_polygonRadius;

class Stack final : public Scene {
    void Build(Stage &stage, int size) override {
        const int vertices = stage.Polygons().vertices;
        constexpr float radius = 0.5f;
        // An edge lies below; above it one, too, where the number of vertices is even.
        const float turn = b2_pi / static_cast<float>(vertices);
        const float apothem = stage.Polygons().bodies == BodyKind::Circle ? radius : radius * std::cos(turn);
        const Fixtures coin = AnySizePolygon(stage.Polygons(), radius, -0.5f * b2_pi + turn);
        b2Body *ground = stage.AddBody(b2_staticBody, {0.0f, 0.0f});
        stage.AddFixture(ground, MakeBox(20.0f, 1.0f, {0.0f, -1.0f}), 0.0f);
        for (int i = 0; i < size; ++i) {
            const float y = apothem + kSkins + static_cast<float>(i) * (2.0f * apothem + kSkins);
            coin.AddTo(stage, stage.AddBody(b2_dynamicBody, {0.0f, y}), Material(1.0f, 0.6f));
        }
    }
};

class Wheels final : public Scene {
    void Build(Stage &stage, int size) override {
        constexpr float slope = 0.15f, radius = 0.5f, spacing = 4.0f;
        const b2Rot along(-slope);
        b2Body *ground = stage.AddBody(b2_staticBody, {0.0f, 0.0f}, -slope);
        const float length = spacing * static_cast<float>(size) + 40.0f;
        stage.AddFixture(ground, Material(0.0f, 0.9f), MakeBox(length, 1.0f, {0.0f, -1.0f}));
        const Fixtures wheel = AnySizePolygon(stage.Polygons(), radius);
        for (int i = 0; i < size; ++i) {
            const b2Vec2 place(spacing * static_cast<float>(i) - 0.5f * length, radius + kSkins);
            b2Body *body = stage.AddBody(b2_dynamicBody, b2Mul(along, place));
            wheel.AddTo(stage, body, Material(1.0f, 0.9f));
        }
    }
};

class Planet final : public Scene {
    void Build(Stage &stage, int size) override {
        stage.World().SetGravity({0.0f, 0.0f});
        const Fixtures planet = AnySizePolygon(stage.Polygons(), radius);
        planet.AddTo(stage, stage.AddBody(b2_staticBody, {0.0f, 0.0f}), Material(0.0f, 0.6f));
        const int towers = (size + height - 1) / height;
        for (int i = 0; i < size; ++i) {
            const float angle = 2.0f * b2_pi * static_cast<float>(i / height) / static_cast<float>(towers);
            const float at = radius + half + 0.05f + static_cast<float>(i % height) * (2.0f * half + 0.05f);
            b2BodyDef def;
            def.type = b2_dynamicBody;
            def.position = at * b2Vec2(std::cos(angle), std::sin(angle));
            def.angle = angle;
            stage.AddFixture(stage.AddBody(def), Material(1.0f, 0.6f), MakeBox(half, half));
        }
    }

    // Its own gravity, which wakes nobody: a tower that stands may sleep.
    void BeforeStep(Stage &stage, int) override {
        constexpr float gravity = 10.0f;
        for (b2Body *body = stage.World().GetBodyList(); body != nullptr; body = body->GetNext()) {
            if (body->GetType() != b2_dynamicBody)
                continue;
            b2Vec2 down = -body->GetPosition();
            down.Normalize();
            body->ApplyForceToCenter(gravity * body->GetMass() * down, false);
        }
    }

    static constexpr float radius = 10.0f, half = 0.4f;
    static constexpr int height = 4;
};

/// Coins of any number of corners. Of 64 Box2D can only have them as bodies of 11 fixtures.
class CoinsGas final : public Scene {
    void Build(Stage &stage, int size) override {
        stage.World().SetGravity({0.0f, 0.0f});
        const Grid grid(size, 18, 2.05f);
        AddArena(stage, {0.0f, 0.0f}, grid.halfWidth, grid.halfHeight, 1.0f);
        const Fixtures coin = AnySizePolygon(stage.Polygons(), 0.5f);
        for (int i = 0; i < size; ++i) {
            b2BodyDef def;
            def.type = b2_dynamicBody;
            def.position = grid.Place(i);
            def.linearVelocity = stage.Rng().Direction(0.5f, 3.0f);
            def.angularVelocity = stage.Rng().Uniform(-1.0f, 1.0f);
            coin.AddTo(stage, stage.AddBody(def), Material(1.0f, 0.1f, 1.0f));
        }
    }
};

class CoinsPile final : public Scene {
    void Build(Stage &stage, int size) override {
        constexpr int columns = 10;
        constexpr float radius = 0.85f, spacing = 1.85f;
        AddArena(stage, {0.0f, 25.0f}, 0.5f * spacing * columns + 1.0f, 25.0f, 0.0f);
        const Fixtures coin = AnySizePolygon(stage.Polygons(), radius);
        for (int i = 0; i < size; ++i) {
            b2BodyDef def;
            def.type = b2_dynamicBody;
            def.position.Set(spacing * (static_cast<float>(i % columns) - 0.5f * (columns - 1)) +
                                 stage.Rng().Uniform(-0.04f, 0.04f),
                             radius + 0.1f + spacing * static_cast<float>(i / columns));
            def.angle = stage.Rng().Uniform(-b2_pi, b2_pi);
            coin.AddTo(stage, stage.AddBody(def), Material(1.0f, 0.3f));
        }
    }
};

} // namespace

void AddCoins(std::vector<SceneInfo> &scenes) {
    const PolygonChoice coins = {BodyKind::Many, 64};
    scenes.push_back(WithPolygons({"coins-gas", "64-gons of 11 fixtures each bounce about in a closed box",
                                   "hard", 250, 300, CreateScene<CoinsGas>},
                                  coins));
    scenes.push_back(WithPolygons(
        {"coins-pile", "larger such coins fall into a pile", "hard", 200, 300, CreateScene<CoinsPile>},
        coins));
}

void AddAnySizeBodies(std::vector<SceneInfo> &scenes) {
    const auto add = [&](int vertices, const SceneInfo &info) {
        scenes.push_back(WithPolygons(info, {BodyKind::One, vertices}));
    };
    add(256, {"any-gas", "coins of any number of corners bounce about in a closed box", "any-size", 250, 300,
              CreateScene<CoinsGas>});
    add(256,
        {"any-pile", "larger such coins fall into a pile", "any-size", 200, 300, CreateScene<CoinsPile>});
    add(64, {"any-stack", "coins with many corners stand on each other", "any-size", 10, 300,
             CreateScene<Stack>});
    add(1024, {"any-wheels", "polygons of many vertices roll down a slope", "any-size", 8, 300,
               CreateScene<Wheels>});
    add(4096, {"any-planet", "towers of boxes stand on a planet that is one polygon", "any-size", 160, 300,
               CreateScene<Planet>});
}

} // namespace testbed
