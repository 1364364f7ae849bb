// SPDX-License-Identifier: MIT
//
// Polygons, discs and compounds on edge terrain and on chain terrain.
#include "scene.h"
#include "shapes.h"

namespace testbed {
namespace {

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

void AddTerrain(std::vector<SceneInfo> &scenes) {
    scenes.push_back({"terrain", "boxes, polygons, discs and Ls on hills of edges and on hills of a chain",
                      "classic", 160, 300, CreateScene<Terrain>});
}

} // namespace testbed
