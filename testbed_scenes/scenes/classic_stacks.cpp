// SPDX-License-Identifier: MIT
//
// Things that stand: most contacts touch and go on touching.
#include <algorithm>

#include "scene.h"
#include "shapes.h"

namespace testbed {
namespace {

void AddGround(Stage &stage, float halfWidth) {
    b2Body *ground = stage.AddBody(b2_staticBody, {0.0f, 0.0f});
    stage.AddFixture(ground, MakeEdge({-halfWidth, 0.0f}, {halfWidth, 0.0f}), 0.0f);
}

/// Rows of unit boxes, each a box shorter than the one below; also what falls on the tiles.
void AddPyramid(Stage &stage, int base) {
    constexpr float width = 1.125f, height = 1.25f; // from centre to centre: an eighth and a quarter of air
    const b2PolygonShape box = MakeBox(0.5f, 0.5f);
    for (int row = 0; row < base; ++row) {
        const float left = -7.0f + 0.5f * width * static_cast<float>(row);
        const float y = 0.75f + height * static_cast<float>(row);
        for (int column = 0; column < base - row; ++column) {
            b2Body *body = stage.AddBody(b2_dynamicBody, {left + width * static_cast<float>(column), y});
            stage.AddFixture(body, box, 5.0f);
        }
    }
}

class Pyramid final : public Scene {
    void Build(Stage &stage, int size) override {
        AddGround(stage, std::max(40.0f, 2.0f * static_cast<float>(size)));
        AddPyramid(stage, size);
    }
};

class VerticalStack final : public Scene {
    void Build(Stage &stage, int size) override {
        constexpr int columns = 5;
        AddGround(stage, 40.0f);
        const b2PolygonShape box = MakeBox(0.5f, 0.5f);
        const b2FixtureDef def = Material(1.0f, 0.3f);
        for (int column = 0; column < columns; ++column) {
            for (int row = 0; row < size; ++row) {
                // A little crooked, for a perfect stack asks nothing of the solver.
                const float x =
                    -10.0f + 5.0f * static_cast<float>(column) + stage.Rng().Uniform(-0.02f, 0.02f);
                b2Body *body = stage.AddBody(b2_dynamicBody, {x, 0.55f + 1.1f * static_cast<float>(row)});
                stage.AddFixture(body, def, box);
            }
        }
    }

    void BeforeStep(Stage &stage, int step) override {
        constexpr int first = 120, interval = 90; // once the stacks rest, and again and again
        if (step < first || (step - first) % interval != 0)
            return;
        b2BodyDef def;
        def.type = b2_dynamicBody;
        def.bullet = true;
        def.position.Set(-31.0f, 5.0f);
        def.linearVelocity.Set(200.0f, stage.Rng().Uniform(-5.0f, 10.0f));
        stage.AddFixture(stage.AddBody(def), Material(20.0f, 0.2f, 0.05f), MakeRegular(6, 0.25f));
    }
};

class Tiles final : public Scene {
    void Build(Stage &stage, int size) override {
        constexpr int columns = 200, rows = 10;
        constexpr float half = 0.5f;
        b2Body *ground = stage.AddBody(b2_staticBody, {0.0f, -half});
        for (int row = 0; row < rows; ++row) {
            for (int column = 0; column < columns; ++column) {
                const b2Vec2 center(2.0f * half * static_cast<float>(column - columns / 2),
                                    -2.0f * half * static_cast<float>(row));
                stage.AddFixture(ground, MakeBox(half, half, center), 0.0f);
            }
        }
        AddPyramid(stage, size);
    }
};

} // namespace

void AddClassicStacks(std::vector<SceneInfo> &scenes) {
    scenes.push_back({"pyramid", "a pyramid of boxes settles", "classic", 20, 600, CreateScene<Pyramid>});
    scenes.push_back({"vertical-stack", "five stacks of boxes, shot at once they rest", "classic", 15, 600,
                      CreateScene<VerticalStack>});
    scenes.push_back({"tiles", "a pyramid falls on a ground body of 2000 square tiles", "classic", 20, 600,
                      CreateScene<Tiles>});
}

} // namespace testbed
