// SPDX-License-Identifier: MIT
//
// A wall of gears in mesh; octagons fall on them and are ground between them. A gear is a hub with teeth, or
// one outline.
#include <algorithm>
#include <cmath>

#include "scene.h"
#include "shapes.h"

namespace testbed {
namespace {

constexpr int teeth = 24;
constexpr float pitchRadius = 2.0f, tipRadius = 2.17f;
// Half widths of a tooth. At the pitch circle a tooth is 0.2 wide of the 0.26 it may have: Box2D keeps
// polygons 0.02 apart and the joints give a little.
constexpr float rootHalf = 0.135f, tipHalf = 0.06f;

/// In one outline unless the scene lets nothing be chosen.
class Gears final : public Scene {
    void Build(Stage &stage, int size) override {
        constexpr int columns = 6;
        b2Body *frame = stage.AddBody(b2_staticBody, {0.0f, 0.0f});
        const int rows = (size + columns - 1) / columns;
        const float halfWidth = pitchRadius * columns + 0.5f;
        m_top = 2.0f * pitchRadius * static_cast<float>(rows) + 20.0f;
        for (const float side : {-1.0f, 1.0f})
            stage.AddFixture(frame, MakeBox(0.5f, 0.5f * m_top, {side * (halfWidth + 0.5f), 0.5f * m_top}),
                             0.0f);
        // Neighbours are straight above, below and beside, where a quarter turn is a whole number of
        // teeth: every other gear is turned by half a tooth, and they all mesh.
        constexpr float phases[] = {0.0f, b2_pi / teeth};
        const PolygonChoice &choice = stage.Polygons();
        std::vector<Fixtures> outlined;
        for (const float phase : phases)
            if (choice.vertices != 0)
                outlined.push_back(
                    OutlinedBody(choice.bodies, StarShaped(GearVertices(choice.vertices / teeth, phase))));
        for (int i = 0; i < size; ++i) {
            const int row = i / columns, column = i % columns;
            const b2Vec2 center(pitchRadius * static_cast<float>(2 * column - columns + 1),
                                pitchRadius * static_cast<float>(2 * row + 1));
            const auto turned = static_cast<std::size_t>((row + column) % 2);
            b2Body *gear = stage.AddBody(b2_dynamicBody, center);
            if (outlined.empty())
                AddTeeth(stage, gear, phases[turned]);
            else
                outlined[turned].AddTo(stage, gear, steel);
            b2RevoluteJointDef axle;
            axle.Initialize(frame, gear, center);
            axle.enableMotor = i == 0;
            axle.motorSpeed = 1.0f;
            axle.maxMotorTorque = 1e5f;
            stage.AddJoint(axle);
        }
    }

    // An octagon before each of the first steps, for there is no room for all at once.
    void BeforeStep(Stage &stage, int step) override {
        constexpr int octagons = 150;
        if (step >= octagons)
            return;
        const float above = stage.Rng().Uniform(-2.0f, 2.0f);
        const float across = stage.Rng().Uniform(-10.0f, 10.0f);
        b2Body *body = stage.AddBody(b2_dynamicBody, {across, m_top - 6.0f + above});
        stage.AddFixture(body, Material(1.0f, 0.5f), MakeRegular(8, stage.Rng().Uniform(0.2f, 0.35f)));
    }

    void AddTeeth(Stage &stage, b2Body *gear, float phase) const {
        constexpr float hubRadius = 1.78f;
        AnySizePolygon(BodyKind::Many, RegularVertices(teeth, hubRadius, phase)).AddTo(stage, gear, steel);
        for (int i = 0; i < teeth; ++i) {
            const b2Rot turn(phase + 2.0f * b2_pi * static_cast<float>(i) / teeth);
            // The foot reaches below the hub's rim, so that nothing can get between.
            const b2Vec2 corners[] = {
                b2Mul(turn, b2Vec2(hubRadius - 0.05f, -rootHalf)), b2Mul(turn, b2Vec2(tipRadius, -tipHalf)),
                b2Mul(turn, b2Vec2(tipRadius, tipHalf)), b2Mul(turn, b2Vec2(hubRadius - 0.05f, rootHalf))};
            b2PolygonShape tooth;
            tooth.Set(corners, 4);
            stage.AddFixture(gear, steel, tooth);
        }
    }

    /// Tooth by tooth: its right foot, its tip, which is round where there are points for that, its left
    /// foot.
    static Vertices GearVertices(int pointsOfTooth, float phase) {
        constexpr float rootRadius = 1.75f;
        const int tips = std::max(pointsOfTooth, 4) - 2;
        Vertices vertices;
        for (int tooth = 0; tooth < teeth; ++tooth) {
            const b2Rot turn(phase + 2.0f * b2_pi * static_cast<float>(tooth) / teeth);
            vertices.push_back(b2Mul(turn, b2Vec2(rootRadius, -rootHalf)));
            for (int i = 0; i < tips; ++i) {
                const float along = static_cast<float>(i) / static_cast<float>(tips - 1);
                const float bulge = 0.5f * tipHalf * std::sin(b2_pi * along);
                vertices.push_back(b2Mul(turn, b2Vec2(tipRadius + bulge, tipHalf * (2.0f * along - 1.0f))));
            }
            vertices.push_back(b2Mul(turn, b2Vec2(rootRadius, rootHalf)));
        }
        return vertices;
    }

    const b2FixtureDef steel = Material(5.0f, 0.1f);
    float m_top = 0.0f;
};

} // namespace

void AddGears(std::vector<SceneInfo> &scenes) {
    scenes.push_back({"gears", "150 octagons fall on gears of 24 teeth in mesh, one of which is driven",
                      "hard", 18, 300, CreateScene<Gears>});
    scenes.push_back(
        WithPolygons({"gears-outline", "octagons fall on gears in mesh, each of them one outline", "outlines",
                      18, 300, CreateScene<Gears>},
                     {BodyKind::One, 96}));
}

} // namespace testbed
