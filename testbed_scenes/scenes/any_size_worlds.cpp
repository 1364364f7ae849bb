// SPDX-License-Identifier: MIT
//
// Polygons of any size among other things: bullets at thin targets, and a bag of everything on a chain.
#include <cmath>

#include "scene.h"
#include "shapes.h"

namespace testbed {
namespace {

Vertices EllipseVertices(int count, float halfWidth, float halfHeight) {
    Vertices vertices = RegularVertices(count, 1.0f);
    for (b2Vec2 &vertex : vertices)
        vertex.Set(halfWidth * vertex.x, halfHeight * vertex.y);
    return vertices;
}

class BulletsAtThin final : public Scene {
    void Build(Stage &stage, int size) override {
        AddArena(stage, {0.0f, 0.0f}, halfWidth, halfHeight, 0.5f);
        AddTargets(stage);
        const PolygonChoice &choice = stage.Polygons();
        const Fixtures ball = AnySizePolygon(choice, 0.15f);
        const Fixtures shell = AnySizePolygon(choice.bodies, EllipseVertices(choice.vertices, 0.25f, 0.1f));
        for (int i = 0; i < size; ++i) {
            b2BodyDef def;
            def.type = b2_dynamicBody;
            def.bullet = true;
            b2Body *bullet = stage.AddBody(def);
            (i % 2 == 0 ? ball : shell).AddTo(stage, bullet, Material(1.0f, 0.2f, 0.5f));
            m_bullets.push_back(bullet);
            Shoot(stage, bullet);
        }
    }

    // They take turns, so that at any time some fly and some have come to rest.
    void BeforeStep(Stage &stage, int step) override {
        constexpr int interval = 120;
        for (std::size_t i = 0; i < m_bullets.size(); ++i)
            if (step > 0 && (static_cast<int>(i) + step) % interval == 0)
                Shoot(stage, m_bullets[i]);
    }

    /// Columns of planks, of bare edges and of zigzag chains, one behind the other.
    static void AddTargets(Stage &stage) {
        constexpr int columns = 9, rows = 8;
        for (int column = 0; column < columns; ++column) {
            const float x = 5.0f * (static_cast<float>(column) - 0.5f * (columns - 1));
            b2Body *body = stage.AddBody(b2_staticBody, {x, 0.0f});
            Vertices zigzag;
            for (int row = 0; row < rows; ++row) {
                const float y = 3.4f * (static_cast<float>(row) - 0.5f * (rows - 1));
                const float turn = stage.Rng().Uniform(-0.7f, 0.7f);
                zigzag.push_back({row % 2 == 0 ? -0.6f : 0.6f, y});
                if (column % 3 == 0)
                    stage.AddFixture(body, MakeBox(0.02f, 1.2f, {0.0f, y}, turn), 0.0f);
                else if (column % 3 == 1)
                    stage.AddFixture(body, MakeEdge({-turn, y - 1.1f}, {turn, y + 1.1f}), 0.0f);
            }
            if (column % 3 == 2) {
                b2ChainShape chain;
                chain.CreateChain(zigzag.data(), rows, zigzag.front() - b2Vec2(0.0f, 1.0f),
                                  zigzag.back() + b2Vec2(0.0f, 1.0f));
                stage.AddFixture(body, chain, 0.0f);
            }
        }
    }

    static void Shoot(Stage &stage, b2Body *bullet) {
        const float side = stage.Rng().OnceIn(2) ? -1.0f : 1.0f;
        const float angle = stage.Rng().Uniform(-b2_pi, b2_pi);
        const float height = stage.Rng().Uniform(-0.9f, 0.9f) * halfHeight;
        bullet->SetTransform({side * (halfWidth - 1.0f), height}, angle);
        bullet->SetLinearVelocity(
            {-side * stage.Rng().Uniform(60.0f, 110.0f), stage.Rng().Uniform(-20.0f, 20.0f)});
        bullet->SetAngularVelocity(stage.Rng().Uniform(-10.0f, 10.0f));
    }

    static constexpr float halfWidth = 25.0f, halfHeight = 15.0f;
    std::vector<b2Body *> m_bullets;
};

/// Polygons of 3 vertices to all that were asked for, ellipses, capsules, circles and boxes.
class Bag final : public Scene {
    void Build(Stage &stage, int size) override {
        AddHills(stage);
        m_left = size;
    }

    void BeforeStep(Stage &stage, int step) override {
        constexpr int every = 2;
        if (step % every != 0 || m_left == 0)
            return;
        --m_left;
        const b2Vec2 at(stage.Rng().Uniform(-8.0f, 8.0f), 14.0f);
        AddThing(stage, stage.AddBody(b2_dynamicBody, at, stage.Rng().Uniform(-b2_pi, b2_pi)));
    }

    static void AddHills(Stage &stage) {
        constexpr float wall = 25.0f, halfWidth = 12.0f;
        Vertices hills{{-halfWidth, wall}};
        for (float x = -halfWidth; x <= halfWidth; x += 0.5f)
            hills.push_back({x, 1.2f * std::cos(0.8f * x) + 0.02f * x * x});
        hills.push_back({halfWidth, wall});
        AddChain(stage, hills);
    }

    static void AddThing(Stage &stage, b2Body *body) {
        const b2FixtureDef wood = Material(1.0f, 0.4f);
        PolygonChoice choice = stage.Polygons();
        const float size = stage.Rng().Uniform(0.25f, 0.6f);
        switch (stage.Rng().Index(5)) {
        case 0: // evenly in the logarithm
            choice.vertices = static_cast<int>(
                3.0f * std::pow(static_cast<float>(choice.vertices) / 3.0f, stage.Rng().Uniform(0.0f, 1.0f)));
            AnySizePolygon(choice, size).AddTo(stage, body, wood);
            break;
        case 1:
            AnySizePolygon(choice.bodies, EllipseVertices(choice.vertices, size, 0.5f * size))
                .AddTo(stage, body, wood);
            break;
        case 2:
            AnySizePolygon(choice.bodies, CapsuleVertices(choice.vertices, size, 0.4f * size))
                .AddTo(stage, body, wood);
            break;
        case 3:
            stage.AddFixture(body, wood, MakeCircle(0.7f * size));
            break;
        default:
            stage.AddFixture(body, wood, MakeBox(size, 0.6f * size));
        }
    }

    /// An even number of vertices: half of them around each end.
    static Vertices CapsuleVertices(int count, float half, float radius) {
        const int each = count / 2;
        Vertices vertices;
        for (int i = 0; i < 2 * each; ++i) {
            const int side = i / each;
            const float t = b2_pi * (static_cast<float>(i % each) / static_cast<float>(each - 1) - 0.5f +
                                     static_cast<float>(side));
            vertices.push_back({(side == 0 ? half : -half) + radius * std::cos(t), radius * std::sin(t)});
        }
        return vertices;
    }

    int m_left = 0;
};

} // namespace

void AddAnySizeWorlds(std::vector<SceneInfo> &scenes) {
    const auto add = [&](int vertices, const SceneInfo &info) {
        scenes.push_back(WithPolygons(info, {BodyKind::One, vertices}));
    };
    add(256, {"any-bullets", "round bullets hit thin planks, bare edges and chains", "any-size", 120, 300,
              CreateScene<BulletsAtThin>});
    add(512, {"any-bag", "polygons of all sizes, ellipses, capsules, circles and boxes fall on a chain",
              "any-size", 150, 420, CreateScene<Bag>});
}

} // namespace testbed
