// SPDX-License-Identifier: MIT
//
// Things held together by joints.
#include "scene.h"
#include "shapes.h"

namespace testbed {
namespace {

/// A chain of hinged planks between two points of the ground, which are `count` plank lengths apart.
void AddBridge(Stage &stage, b2Body *ground, b2Vec2 from, int count, float halfLength,
               const b2FixtureDef &def) {
    const float length = 2.0f * halfLength;
    const b2PolygonShape plank = MakeBox(halfLength, 0.125f);
    b2Body *last = ground;
    for (int i = 0; i < count; ++i) {
        const b2Vec2 anchor(from.x + length * static_cast<float>(i), from.y);
        b2Body *body = stage.AddBody(b2_dynamicBody, {anchor.x + halfLength, anchor.y});
        stage.AddFixture(body, def, plank);
        stage.AddHinge(last, body, anchor);
        last = body;
    }
    stage.AddHinge(last, ground, {from.x + length * static_cast<float>(count), from.y});
}

class Bridge final : public Scene {
    void Build(Stage &stage, int size) override {
        b2Body *ground = stage.AddBody(b2_staticBody, {0.0f, 0.0f});
        stage.AddFixture(ground, MakeEdge({-40.0f, 0.0f}, {40.0f, 0.0f}), 0.0f);
        AddBridge(stage, ground, {-0.5f * static_cast<float>(size), 5.0f}, size, 0.5f, Material(20.0f));
        const b2Vec2 corners[] = {b2Vec2(-0.5f, 0.0f), b2Vec2(0.5f, 0.0f), b2Vec2(0.0f, 1.5f)};
        b2PolygonShape triangle;
        triangle.Set(corners, 3);
        for (int i = 0; i < 4; ++i) {
            const float x = 8.0f * static_cast<float>(i) - 12.0f;
            stage.AddFixture(stage.AddBody(b2_dynamicBody, {x, 12.0f}), triangle, 1.0f);
            stage.AddFixture(stage.AddBody(b2_dynamicBody, {x + 2.0f, 10.0f}), MakeCircle(0.5f), 1.0f);
            stage.AddFixture(stage.AddBody(b2_dynamicBody, {x + 4.0f, 11.0f}), MakeRegular(8, 0.5f), 1.0f);
        }
    }
};

/// A car on wheel joints drives over hills, a plank and a bridge into a stack.
class Car final : public Scene {
    void Build(Stage &stage, int size) override {
        b2Body *ground = stage.AddBody(b2_staticBody, {0.0f, 0.0f});
        const float bridge = AddRoad(stage, ground);
        AddBridge(stage, ground, {bridge, -0.125f}, 20, 1.0f, Material(1.0f, 0.6f));
        const float end = bridge + 40.0f;
        AddRoadPiece(stage, ground, {end, 0.0f}, {end + 60.0f, 0.0f});
        AddRoadPiece(stage, ground, {end + 60.0f, 0.0f}, {end + 60.0f, 20.0f});
        for (int i = 0; i < size; ++i) {
            b2Body *box = stage.AddBody(b2_dynamicBody, {end + 30.0f, 0.5f + static_cast<float>(i)});
            stage.AddFixture(box, MakeBox(0.5f, 0.5f), 0.5f);
        }
        m_motor = AddCar(stage, {0.0f, 0.0f});
    }

    void BeforeStep(Stage &, int step) override {
        constexpr int cycle = 240; // drive for three quarters of it, then brake
        m_motor->SetMotorSpeed(step % cycle < 3 * cycle / 4 ? -50.0f : 0.0f);
    }

    static void AddRoadPiece(Stage &stage, b2Body *ground, b2Vec2 from, b2Vec2 to) {
        stage.AddFixture(ground, Material(0.0f, 0.6f), MakeEdge(from, to));
    }

    /// Returns where the gap for the bridge begins.
    static float AddRoad(Stage &stage, b2Body *ground) {
        const float heights[] = {0.25f, 1.0f, 3.0f, 0.0f, 0.0f, -1.0f, -2.0f, -2.0f, -1.25f, 0.0f};
        AddRoadPiece(stage, ground, {-20.0f, 20.0f}, {-20.0f, 0.0f});
        AddRoadPiece(stage, ground, {-20.0f, 0.0f}, {10.0f, 0.0f});
        b2Vec2 at(10.0f, 0.0f);
        for (const float height : heights) {
            AddRoadPiece(stage, ground, at, {at.x + 5.0f, height});
            at.Set(at.x + 5.0f, height);
        }
        AddRoadPiece(stage, ground, at, {at.x + 20.0f, 0.0f});
        b2Body *plank = stage.AddBody(b2_dynamicBody, {at.x + 10.0f, 1.0f});
        stage.AddFixture(plank, MakeBox(6.0f, 0.2f), 1.0f);
        b2RevoluteJointDef seesaw;
        seesaw.Initialize(ground, plank, plank->GetPosition());
        seesaw.lowerAngle = -8.0f * b2_pi / 180.0f;
        seesaw.upperAngle = 8.0f * b2_pi / 180.0f;
        seesaw.enableLimit = true;
        stage.AddJoint(seesaw);
        plank->ApplyAngularImpulse(100.0f, true);
        return at.x + 20.0f;
    }

    b2WheelJoint *m_motor = nullptr;
};

} // namespace

void AddClassicJoints(std::vector<SceneInfo> &scenes) {
    scenes.push_back({"bridge", "triangles, discs and octagons fall on a hinged bridge", "classic", 30, 300,
                      CreateScene<Bridge>});
    scenes.push_back(
        {"car", "a car drives over hills and a bridge into a stack", "classic", 5, 900, CreateScene<Car>});
}

} // namespace testbed
