// SPDX-License-Identifier: MIT
//
// Bodies that look about: each carries a fan-shaped sensor that reaches far beyond it.
#include <cmath>

#include "scene.h"
#include "shapes.h"

namespace testbed {
namespace {

/// A sector of a disc with its corner at the origin, in 8 vertices.
b2PolygonShape MakeFan(float reach, float halfAngle) {
    constexpr int onArc = b2_maxPolygonVertices - 1;
    Outline outline{{0.0f, 0.0f}};
    for (int i = 0; i < onArc; ++i) {
        const float angle = halfAngle * (2.0f * static_cast<float>(i) / (onArc - 1) - 1.0f);
        outline.emplace_back(reach * std::cos(angle), reach * std::sin(angle));
    }
    b2PolygonShape fan;
    fan.Set(outline.data(), static_cast<int32>(outline.size()));
    return fan;
}

class Sensors final : public Scene {
    void Build(Stage &stage, int size) override {
        constexpr float reach = 5.0f, halfAngle = 0.4f;
        stage.World().SetGravity({0.0f, 0.0f});
        const Grid grid(size, 15, 4.35f);
        b2Body *arena = AddArena(stage, {0.0f, 0.0f}, grid.halfWidth, grid.halfHeight, 1.0f);
        // The fans look at each other, not at the walls.
        for (b2Fixture *wall = arena->GetFixtureList(); wall != nullptr; wall = wall->GetNext()) {
            b2Filter filter;
            filter.categoryBits = walls;
            wall->SetFilterData(filter);
        }
        b2FixtureDef eye = Material(0.0f);
        eye.isSensor = true;
        eye.filter.maskBits = static_cast<uint16>(0xffff & ~walls);
        for (int i = 0; i < size; ++i) {
            const b2BodyDef def = Drifting(stage.Rng(), grid.Place(i), 0.5f, 3.0f, 1.5f);
            b2Body *body = stage.AddBody(def);
            AddConvex(stage, body, RegularOutline(32, 0.5f), Material(1.0f, 0.1f, 1.0f));
            stage.AddFixture(body, eye, MakeFan(reach, halfAngle));
        }
    }

    static constexpr uint16 walls = 0x0002;
};

} // namespace

void AddSensors(std::vector<SceneInfo> &scenes) {
    scenes.push_back({"sensors", "drifting 32-gons, each with a fan-shaped polygon sensor of reach 5", "hard",
                      150, 300, CreateScene<Sensors>});
}

} // namespace testbed
