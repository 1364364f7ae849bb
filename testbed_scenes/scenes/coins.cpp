// SPDX-License-Identifier: MIT
//
// Coins of any number of corners. Of 64 Box2D can only have them as bodies of 11 fixtures.
#include "any_size.h"
#include "scene.h"
#include "shapes.h"

namespace testbed {
namespace {

class CoinsGas final : public Scene {
    void Build(Stage &stage, int size) override {
        stage.World().SetGravity({0.0f, 0.0f});
        const Grid grid(size, 18, 2.05f);
        AddArena(stage, {0.0f, 0.0f}, grid.halfWidth, grid.halfHeight, 1.0f);
        const AnySizePolygon coin(stage.Polygons(), 0.5f);
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
        const AnySizePolygon coin(stage.Polygons(), radius);
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
    SceneInfo gas = {"coins-gas", "64-gons of 11 fixtures each bounce about in a closed box",
                     "hard",      250,
                     300,         CreateScene<CoinsGas>};
    SceneInfo pile = {"coins-pile",          "larger such coins fall into a pile", "hard", 200, 300,
                      CreateScene<CoinsPile>};
    gas.polygons = pile.polygons = {BodyKind::Many, 64};
    scenes.insert(scenes.end(), {gas, pile});
}

void AddAnySizeCoins(std::vector<SceneInfo> &scenes) {
    SceneInfo gas = {"any-gas",  "coins of any number of corners bounce about in a closed box",
                     "any-size", 250,
                     300,        CreateScene<CoinsGas>};
    SceneInfo pile = {
        "any-pile", "larger such coins fall into a pile", "any-size", 200, 300, CreateScene<CoinsPile>};
    gas.polygons = pile.polygons = {BodyKind::One, 256};
    scenes.insert(scenes.end(), {gas, pile});
}

} // namespace testbed
