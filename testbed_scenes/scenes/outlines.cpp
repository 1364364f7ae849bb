// SPDX-License-Identifier: MIT
//
// Concave bodies and level terrain as outlines: scanned silhouettes, and a rock full of caves.
#include <algorithm>
#include <cmath>

#include "scene.h"
#include "shapes.h"

namespace testbed {
namespace {

/// What a camera sees of a thing: lobes, and the noise of its pixels.
class Silhouettes final : public Scene {
    void Build(Stage &stage, int size) override {
        constexpr int columns = 8;
        constexpr float spacing = 2.8f;
        const PolygonChoice &choice = stage.Polygons();
        const int rows = (size + columns - 1) / columns;
        const float height = 0.5f * spacing * static_cast<float>(rows) + 2.0f;
        AddArena(stage, {0.0f, height}, 0.5f * spacing * columns + 0.5f, height, 0.0f);
        for (int i = 0; i < size; ++i) {
            b2Body *body = stage.AddBody(b2_dynamicBody, InRows(i, columns, spacing, 1.6f),
                                         stage.Rng().Uniform(-b2_pi, b2_pi));
            const Concave seen = StarShaped(SilhouetteVertices(stage.Rng(), choice.vertices));
            OutlinedBody(choice.bodies, seen, tolerance).AddTo(stage, body, Material(1.0f, 0.4f));
        }
    }

    static Vertices SilhouetteVertices(Random &random, int points) {
        constexpr int lobes = 4;
        float amplitude[lobes], phase[lobes];
        for (int k = 0; k < lobes; ++k) {
            amplitude[k] = random.Uniform(0.02f, 0.14f);
            phase[k] = random.Uniform(-b2_pi, b2_pi);
        }
        Vertices vertices;
        for (int i = 0; i < points; ++i) {
            const float angle = 2.0f * b2_pi * static_cast<float>(i) / static_cast<float>(points);
            float radius = 1.0f + random.Uniform(-0.003f, 0.003f);
            for (int k = 0; k < lobes; ++k)
                radius += amplitude[k] * std::cos(static_cast<float>(k + 2) * angle + phase[k]);
            vertices.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        }
        return vertices;
    }

    static constexpr float tolerance = 0.02f; ///< a hundredth of their size
};

/// One static outline with a hole for each cave; stones, coins and boxes lie about in them.
class Caves final : public Scene {
    void Build(Stage &stage, int size) override {
        const PolygonChoice &choice = stage.Polygons();
        const int points = std::max(choice.vertices / 8, 2) * 8;
        Concave rock;
        std::vector<b2Vec2> middles;
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column)
                middles.push_back({side * (static_cast<float>(column) - 0.5f * (columns - 1)),
                                   side * (static_cast<float>(row) - 0.5f * (rows - 1))});
        for (const b2Vec2 &middle : middles)
            AddCave(stage.Rng(), middle, points, &rock);
        const float x = 0.5f * side * columns, y = 0.5f * side * rows;
        rock.ring = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
        OutlinedBody(choice.bodies, rock)
            .AddTo(stage, stage.AddBody(b2_staticBody, {0.0f, 0.0f}), Material(0.0f, 0.6f));
        for (int i = 0; i < size; ++i) {
            const int cave = i % static_cast<int>(middles.size());
            const int place = i / static_cast<int>(middles.size());
            const b2Vec2 at = middles[static_cast<std::size_t>(cave)] +
                              b2Vec2(1.1f * static_cast<float>(place % 5 - 2),
                                     1.1f * static_cast<float>(place / 5 % 4) - 1.6f);
            AddThing(stage, stage.AddBody(b2_dynamicBody, at, stage.Rng().Uniform(-b2_pi, b2_pi)), i);
        }
    }

    /// A cave in the middle of a square. Each of its points has one straight outwards on the square's rim: so
    /// the square's four corners are among those.
    static void AddCave(Random &random, b2Vec2 middle, int points, Concave *rock) {
        Vertices cave, rim;
        float radius = 4.0f;
        for (int i = 0; i < points; ++i) {
            const float angle = 2.0f * b2_pi * static_cast<float>(i) / static_cast<float>(points);
            const b2Vec2 out(std::cos(angle), std::sin(angle));
            radius = std::clamp(radius + random.Uniform(-0.35f, 0.35f), 3.3f, 4.6f);
            cave.push_back(middle + radius * out);
            rim.push_back(middle + 0.5f * side / std::max(std::abs(out.x), std::abs(out.y)) * out);
        }
        for (std::size_t i = 0, last = cave.size() - 1; i < cave.size(); last = i++) {
            rock->triangles.push_back({cave[last], rim[last], rim[i]});
            rock->triangles.push_back({cave[last], rim[i], cave[i]});
        }
        rock->holes.push_back(std::move(cave));
    }

    static void AddThing(Stage &stage, b2Body *body, int number) {
        const b2FixtureDef stone = Material(1.0f, 0.5f, 0.2f);
        const float size = stage.Rng().Uniform(0.25f, 0.45f);
        switch (number / (rows * columns) % 4) {
        case 0: {
            const Concave star = StarShaped(StarVertices(12, 0.6f * size, 1.2f * size));
            OutlinedBody(stage.Polygons().bodies, star).AddTo(stage, body, stone);
            break;
        }
        case 1:
            stage.AddFixture(body, stone, MakeCircle(size));
            break;
        case 2:
            stage.AddFixture(body, stone, MakeBox(size, 0.6f * size));
            break;
        default:
            stage.AddFixture(body, stone, MakeRegular(8, size));
        }
    }

    static constexpr int rows = 2, columns = 3;
    static constexpr float side = 10.0f;
};

} // namespace

void AddOutlines(std::vector<SceneInfo> &scenes) {
    const auto add = [&](int points, const SceneInfo &info) {
        scenes.push_back(WithPolygons(info, {BodyKind::One, points}));
    };
    add(500, {"silhouettes", "scanned silhouettes, within a hundredth of their size, pile up", "outlines", 48,
              300, CreateScene<Silhouettes>});
    add(48, {"caves", "stars, coins, boxes and octagons fall in the caves of one rock", "outlines", 120, 300,
             CreateScene<Caves>});
}

} // namespace testbed
