// SPDX-License-Identifier: MIT
//
// Polygons, discs and compounds on edge terrain and on chain terrain.
#include <cmath>

#include "scene.h"
#include "shapes.h"

namespace testbed {
namespace {

/// Hills from left to right; the walls at both ends keep everything in.
Outline MakeHills(Random &random, b2Vec2 from, float width) {
    constexpr float wall = 20.0f, step = 1.0f;
    Outline hills{{from.x, from.y + wall}};
    for (float x = 0.0f; x <= width; x += step) {
        const float swell = 1.5f * std::sin(0.4f * x);
        hills.push_back(from + b2Vec2(x, swell + random.Uniform(-0.3f, 0.3f)));
    }
    hills.push_back(from + b2Vec2(width, wall));
    return hills;
}

class Terrain final : public Scene {
    void Build(Stage &stage, int size) override {
        constexpr float width = 40.0f, distance = 60.0f;
        AddEdges(stage, MakeHills(stage.Rng(), {0.0f, 0.0f}, width));
        AddChain(stage, MakeHills(stage.Rng(), {distance, 0.0f}, width));
        for (int i = 0; i < size; ++i) {
            const float terrain = i % 2 == 0 ? 0.0f : distance;
            const float x = stage.Rng().Uniform(2.0f, width - 2.0f);
            const float y = stage.Rng().Uniform(4.0f, 18.0f);
            AddThing(stage, {terrain + x, y}, i / 2);
        }
    }

    /// Edges that know nothing of each other, as a level of separate segments has them.
    static void AddEdges(Stage &stage, const Outline &hills) {
        b2Body *ground = stage.AddBody(b2_staticBody, {0.0f, 0.0f});
        for (std::size_t i = 0; i + 1 < hills.size(); ++i)
            stage.AddFixture(ground, MakeEdge(hills[i], hills[i + 1]), 0.0f);
    }

    /// One-sided, from right to left, so that its front is up.
    static void AddChain(Stage &stage, Outline hills) {
        const Outline reversed(hills.rbegin(), hills.rend());
        b2ChainShape chain;
        chain.CreateChain(reversed.data(), static_cast<int32>(reversed.size()),
                          reversed.front() + b2Vec2(0, 1), reversed.back() + b2Vec2(0, 1));
        stage.AddFixture(stage.AddBody(b2_staticBody, {0.0f, 0.0f}), chain, 0.0f);
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
                      "classic", "bodies, half on each", 160, 300, CreateScene<Terrain>});
}

} // namespace testbed
