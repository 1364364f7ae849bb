// SPDX-License-Identifier: MIT
//
// Concave bodies and level terrain as outlines: asteroids and gears as in the scenes of those names, scanned
// silhouettes, and a rock full of caves.
#include <algorithm>
#include <cmath>

#include "any_size.h"
#include "scene.h"

namespace testbed {
namespace {

class AsteroidsOutline final : public Scene {
    // Draws what the scene `asteroids` draws: of at most 63 points the bodies are the same.
    void Build(Stage &stage, int size) override {
        stage.World().SetGravity({0.0f, 0.0f});
        const PolygonChoice &choice = stage.Polygons();
        const Grid grid(size, 15, 4.9f);
        AddArena(stage, {0.0f, 0.0f}, grid.halfWidth, grid.halfHeight, 1.0f);
        for (int i = 0; i < size; ++i) {
            const b2BodyDef def = Drifting(stage.Rng(), grid.Place(i), 0.5f, 3.0f, 1.0f);
            const int points = fewest + stage.Rng().Index(std::max(choice.vertices - fewest, 0) + 1);
            const Concave rock = StarShaped(RoughOutline(stage.Rng(), points, 1.0f, 1.8f));
            OutlinedBody(choice.bodies, rock).AddTo(stage, stage.AddBody(def), Material(1.0f, 0.1f, 1.0f));
        }
    }

    static constexpr int fewest = 10;
};

/// The scene `gears` with each gear in one outline.
class GearsOutline final : public Scene {
    void Build(Stage &stage, int size) override {
        constexpr int columns = 6;
        b2Body *frame = stage.AddBody(b2_staticBody, {0.0f, 0.0f});
        const int rows = (size + columns - 1) / columns;
        const float halfWidth = pitchRadius * columns + 0.5f;
        m_top = 2.0f * pitchRadius * static_cast<float>(rows) + 20.0f;
        for (const float side : {-1.0f, 1.0f})
            stage.AddFixture(frame, MakeBox(0.5f, 0.5f * m_top, {side * (halfWidth + 0.5f), 0.5f * m_top}),
                             0.0f);
        const PolygonChoice &choice = stage.Polygons();
        const int pointsOfTooth = std::max(choice.vertices / teeth, 4);
        // Every other one is turned by half a tooth: so they mesh.
        const OutlinedBody gears[] = {
            OutlinedBody(choice.bodies, StarShaped(GearOutline(pointsOfTooth, 0.0f))),
            OutlinedBody(choice.bodies, StarShaped(GearOutline(pointsOfTooth, b2_pi / teeth)))};
        for (int i = 0; i < size; ++i) {
            const int row = i / columns, column = i % columns;
            const b2Vec2 center(pitchRadius * static_cast<float>(2 * column - columns + 1),
                                pitchRadius * static_cast<float>(2 * row + 1));
            b2Body *gear = stage.AddBody(b2_dynamicBody, center);
            gears[(row + column) % 2].AddTo(stage, gear, Material(5.0f, 0.1f));
            AddAxle(stage, frame, gear, i == 0, 1e5f);
        }
    }

    void BeforeStep(Stage &stage, int step) override { DropOctagon(stage, step, m_top); }

    /// Tooth by tooth: its right foot, its tip, which is round where there are points for that, its left
    /// foot.
    static Outline GearOutline(int pointsOfTooth, float phase) {
        Outline outline;
        for (int tooth = 0; tooth < teeth; ++tooth) {
            const b2Rot turn(phase + 2.0f * b2_pi * static_cast<float>(tooth) / teeth);
            outline.push_back(b2Mul(turn, b2Vec2(rootRadius, -rootHalf)));
            const int tips = pointsOfTooth - 2;
            for (int i = 0; i < tips; ++i) {
                const float along = static_cast<float>(i) / static_cast<float>(tips - 1);
                const float bulge = 0.5f * tipHalf * std::sin(b2_pi * along);
                outline.push_back(b2Mul(turn, b2Vec2(tipRadius + bulge, tipHalf * (2.0f * along - 1.0f))));
            }
            outline.push_back(b2Mul(turn, b2Vec2(rootRadius, rootHalf)));
        }
        return outline;
    }

    static constexpr int teeth = 24;
    static constexpr float pitchRadius = 2.0f, rootRadius = 1.75f, tipRadius = 2.17f;
    // Half widths of a tooth, as in the scene `gears`.
    static constexpr float rootHalf = 0.135f, tipHalf = 0.06f;
    float m_top = 0.0f;
};

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
            b2BodyDef def;
            def.type = b2_dynamicBody;
            def.position.Set(spacing * (static_cast<float>(i % columns) - 0.5f * (columns - 1)),
                             1.6f + spacing * static_cast<float>(i / columns));
            def.angle = stage.Rng().Uniform(-b2_pi, b2_pi);
            const Concave seen = StarShaped(SilhouetteOutline(stage.Rng(), choice.vertices));
            OutlinedBody(choice.bodies, seen, tolerance)
                .AddTo(stage, stage.AddBody(def), Material(1.0f, 0.4f));
        }
    }

    static Outline SilhouetteOutline(Random &random, int points) {
        constexpr int lobes = 4;
        float amplitude[lobes], phase[lobes];
        for (int k = 0; k < lobes; ++k) {
            amplitude[k] = random.Uniform(0.02f, 0.14f);
            phase[k] = random.Uniform(-b2_pi, b2_pi);
        }
        Outline outline;
        for (int i = 0; i < points; ++i) {
            const float angle = 2.0f * b2_pi * static_cast<float>(i) / static_cast<float>(points);
            float radius = 1.0f + random.Uniform(-0.003f, 0.003f);
            for (int k = 0; k < lobes; ++k)
                radius += amplitude[k] * std::cos(static_cast<float>(k + 2) * angle + phase[k]);
            outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        }
        return outline;
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
        Outline cave, rim;
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
            const Concave star = StarShaped(StarOutline(12, 0.6f * size, 1.2f * size));
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
    add(63, {"asteroids-outline", "the asteroids, each cut into few convex pieces", "outlines", 150, 300,
             CreateScene<AsteroidsOutline>});
    add(96, {"gears-outline", "octagons fall on gears in mesh, each of them one outline", "outlines", 18, 300,
             CreateScene<GearsOutline>});
    add(500, {"silhouettes", "scanned silhouettes, within a hundredth of their size, pile up", "outlines", 48,
              300, CreateScene<Silhouettes>});
    add(48, {"caves", "stars, coins, boxes and octagons fall in the caves of one rock", "outlines", 120, 300,
             CreateScene<Caves>});
}

} // namespace testbed
