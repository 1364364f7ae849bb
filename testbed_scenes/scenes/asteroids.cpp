// SPDX-License-Identifier: MIT
//
// Bodies that drift and collide. Concave ones have 10 to 63 triangles: most of what the broad phase reports
// belongs to one body.
#include <algorithm>

#include "scene.h"
#include "shapes.h"

namespace testbed {
namespace {

/// Stretched polygons of 3 to 8 corners, each of one fixture.
class Drifters final : public Scene {
    void Build(Stage &stage, int size) override {
        stage.World().SetGravity({0.0f, 0.0f});
        const Grid grid(size, 4, 3.6f);
        AddArena(stage, {0.0f, 0.0f}, grid.halfWidth, grid.halfHeight, 1.0f);
        for (int i = 0; i < size; ++i) {
            Vertices vertices = RegularVertices(3 + i % 6, 1.0f);
            for (b2Vec2 &vertex : vertices)
                vertex.x *= 1.8f;
            b2PolygonShape polygon;
            polygon.Set(vertices.data(), static_cast<int32>(vertices.size()));
            const b2BodyDef def = Drifting(stage.Rng(), grid.Place(i), 1.0f, 2.0f, 1.0f);
            stage.AddFixture(stage.AddBody(def), Material(1.0f, 0.1f, 1.0f), polygon);
        }
    }
};

class Asteroids final : public Scene {
    void Build(Stage &stage, int size) override {
        constexpr int fewest = 10;
        stage.World().SetGravity({0.0f, 0.0f});
        const PolygonChoice &choice = stage.Polygons();
        const Grid grid(size, 15, 4.9f);
        AddArena(stage, {0.0f, 0.0f}, grid.halfWidth, grid.halfHeight, 1.0f);
        for (int i = 0; i < size; ++i) {
            const b2BodyDef def = Drifting(stage.Rng(), grid.Place(i), 0.5f, 3.0f, 1.0f);
            const int points = fewest + stage.Rng().Index(std::max(choice.vertices - fewest, 0) + 1);
            const Concave rock = StarShaped(RoughVertices(stage.Rng(), points, 1.0f, 1.8f));
            OutlinedBody(choice.bodies, rock).AddTo(stage, stage.AddBody(def), Material(1.0f, 0.1f, 1.0f));
        }
    }
};

class StarPile final : public Scene {
    void Build(Stage &stage, int size) override {
        constexpr int columns = 8;
        constexpr float spacing = 2.1f;
        const int rows = (size + columns - 1) / columns;
        const float height = 0.5f * spacing * static_cast<float>(rows) + 2.0f;
        AddArena(stage, {0.0f, height}, 0.5f * spacing * columns + 0.5f, height, 0.0f);
        for (int i = 0; i < size; ++i) {
            b2Body *body = stage.AddBody(b2_dynamicBody, InRows(i, columns, spacing, 1.1f),
                                         stage.Rng().Uniform(-b2_pi, b2_pi));
            const int triangles = 10 + stage.Rng().Index(22);
            OutlinedBody(BodyKind::Many, StarShaped(StarVertices(triangles, 0.55f, 1.0f)))
                .AddTo(stage, body, Material(1.0f, 0.4f));
        }
    }
};

} // namespace

void AddAsteroids(std::vector<SceneInfo> &scenes) {
    scenes.push_back({"drifters", "stretched polygons of 3 to 8 corners drift in a closed box", "hard", 8,
                      300, CreateScene<Drifters>});
    scenes.push_back(
        WithPolygons({"asteroids", "concave bodies of 10 to 63 triangles bounce about in a closed box",
                      "hard", 150, 300, CreateScene<Asteroids>},
                     {BodyKind::Many, 63}));
    scenes.push_back(WithPolygons({"asteroids-outline", "the asteroids, each cut into few convex pieces",
                                   "outlines", 150, 300, CreateScene<Asteroids>},
                                  {BodyKind::One, 63}));
    scenes.push_back({"star-pile", "concave stars of 10 to 31 triangles fall into a pile", "hard", 120, 300,
                      CreateScene<StarPile>});
}

} // namespace testbed
