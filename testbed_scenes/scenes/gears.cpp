// SPDX-License-Identifier: MIT
//
// A wall of gears in mesh; octagons fall on them and are ground between them.
#include <cmath>

#include "scene.h"
#include "shapes.h"

namespace testbed {
namespace {

constexpr int teeth = 24;
constexpr float pitchRadius = 2.0f;
constexpr float rootRadius = 1.78f, tipRadius = 2.17f;
// Half widths of a tooth. At the pitch circle a tooth is 0.2 wide of the 0.26 it may have: Box2D keeps
// polygons 0.02 apart and the joints give a little.
constexpr float rootHalf = 0.135f, tipHalf = 0.06f;

class Gears final : public Scene {
    void Build(Stage &stage, int size) override {
        constexpr int columns = 6;
        b2Body *frame = stage.AddBody(b2_staticBody, {0.0f, 0.0f});
        const int rows = (size + columns - 1) / columns;
        const float halfWidth = pitchRadius * columns + 0.5f;
        const float top = 2.0f * pitchRadius * static_cast<float>(rows) + 20.0f;
        for (const float side : {-1.0f, 1.0f})
            stage.AddFixture(frame, MakeBox(0.5f, 0.5f * top, {side * (halfWidth + 0.5f), 0.5f * top}), 0.0f);
        for (int i = 0; i < size; ++i) {
            const int row = i / columns, column = i % columns;
            const b2Vec2 center(pitchRadius * static_cast<float>(2 * column - columns + 1),
                                pitchRadius * static_cast<float>(2 * row + 1));
            // Neighbours are straight above, below and beside, where a quarter turn is a whole number of
            // teeth: every other gear is turned by half a tooth, and they all mesh.
            const float phase = (row + column) % 2 == 0 ? 0.0f : b2_pi / teeth;
            AddGear(stage, frame, center, phase, i == 0);
        }
        m_top = top;
    }

    void BeforeStep(Stage &stage, int step) override { DropOctagon(stage, step, m_top); }

    static void AddGear(Stage &stage, b2Body *frame, b2Vec2 center, float phase, bool driven) {
        const b2FixtureDef steel = Material(5.0f, 0.1f);
        b2Body *gear = stage.AddBody(b2_dynamicBody, center);
        AddConvex(stage, gear, RegularOutline(teeth, rootRadius, phase), steel);
        for (int i = 0; i < teeth; ++i) {
            const b2Rot turn(phase + 2.0f * b2_pi * static_cast<float>(i) / teeth);
            // The foot reaches below the hub's rim, so that nothing can get between.
            const b2Vec2 corners[] = {
                b2Mul(turn, b2Vec2(rootRadius - 0.05f, -rootHalf)), b2Mul(turn, b2Vec2(tipRadius, -tipHalf)),
                b2Mul(turn, b2Vec2(tipRadius, tipHalf)), b2Mul(turn, b2Vec2(rootRadius - 0.05f, rootHalf))};
            b2PolygonShape tooth;
            tooth.Set(corners, 4);
            stage.AddFixture(gear, steel, tooth);
        }
        AddAxle(stage, frame, gear, driven, 1e5f);
    }

    float m_top = 0.0f;
};

} // namespace

void AddGears(std::vector<SceneInfo> &scenes) {
    scenes.push_back({"gears", "150 octagons fall on gears of 24 teeth in mesh, one of which is driven",
                      "hard", 18, 300, CreateScene<Gears>});
}

} // namespace testbed
