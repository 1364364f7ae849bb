// SPDX-License-Identifier: MIT
//
// What games are made of, in their numbers: a large pile, wheels, rocks on a chain, ragdolls, shapes of every
// kind.
#include <algorithm>

#include "scene.h"
#include "shapes.h"

namespace testbed {
namespace {

/// Cars drive to and fro on a rolling road and push the crates between them.
class Cars final : public Scene {
    void Build(Stage &stage, int size) override {
        const float width = spacing * static_cast<float>(size) + 20.0f;
        AddEdges(stage, MakeHills(stage.Rng(), {-10.0f, 0.0f}, width, {0.12f, 0.8f, 0.1f}), roadFriction);
        for (int i = 0; i < size; ++i) {
            const float x = spacing * (static_cast<float>(i) + 0.5f);
            m_motors.push_back(AddCar(stage, {x, 1.5f}));
            for (int crate = 0; crate < 3; ++crate) {
                const b2Vec2 place(x + 0.5f * spacing, 2.0f + 0.7f * static_cast<float>(crate));
                stage.AddFixture(stage.AddBody(b2_dynamicBody, place), Material(0.3f, 0.4f),
                                 MakeBox(0.3f, 0.3f));
            }
        }
    }

    void BeforeStep(Stage &, int step) override {
        constexpr int turn = 150;
        for (std::size_t i = 0; i < m_motors.size(); ++i) {
            const bool back = (step / turn + static_cast<int>(i)) % 2 == 1;
            m_motors[i]->SetMotorSpeed(back ? 15.0f : -15.0f);
        }
    }

    static constexpr float spacing = 7.0f, roadFriction = 0.6f;
    std::vector<b2WheelJoint *> m_motors;
};

/// A landslide: rocks roll down a chain. Who arrives is destroyed, and another one made on top.
class ChainRocks final : public Scene {
    void Build(Stage &stage, int size) override {
        Vertices slope = MakeHills(stage.Rng(), {0.0f, 0.0f}, width, {0.4f, 0.6f, 0.2f});
        for (std::size_t i = 0; i + 1 < slope.size(); ++i) // the wall at the top goes up with it
            slope[i].y += fall * (width - slope[i].x);
        AddChain(stage, slope);
        for (int i = 0; i < size; ++i) {
            const float x =
                2.0f + (width - 4.0f) * static_cast<float>(i / layers * layers) / static_cast<float>(size);
            m_rocks.push_back(
                AddRock(stage, {x, fall * (width - x) + 2.5f + 1.3f * static_cast<float>(i % layers)}));
        }
    }

    void BeforeStep(Stage &stage, int) override {
        for (b2Body *&rock : m_rocks) {
            if (rock->GetPosition().x < width - 4.0f)
                continue;
            stage.World().DestroyBody(rock);
            const float x = stage.Rng().Uniform(3.0f, 8.0f);
            rock = AddRock(stage, {x, fall * width + stage.Rng().Uniform(3.0f, 12.0f)});
            rock->SetLinearVelocity({2.0f, 0.0f});
        }
    }

    static b2Body *AddRock(Stage &stage, b2Vec2 place) {
        b2Body *rock = stage.AddBody(b2_dynamicBody, place, stage.Rng().Uniform(-b2_pi, b2_pi));
        const Vertices corners = RoughVertices(stage.Rng(), 8, 0.3f, 0.6f);
        b2PolygonShape hull;
        hull.Set(corners.data(), 8);
        stage.AddFixture(rock, Material(2.0f, 0.4f, 0.1f), hull);
        return rock;
    }

    static constexpr float width = 60.0f, fall = 0.4f;
    static constexpr int layers = 3;
    std::vector<b2Body *> m_rocks;
};

/// A bone of a ragdoll that stands upright, in metres from its feet. Its joint leads to an earlier one.
struct Bone {
    float x, y, halfWidth, halfHeight; ///< without height: a disc
    int parent;
    b2Vec2 joint;
    float lower, upper; ///< limits of the joint's angle
};

constexpr float armX = 0.27f, legX = 0.1f;
const Bone kBones[] = {
    {0.0f, 1.30f, 0.18f, 0.17f, -1, {0.0f, 0.0f}, 0.0f, 0.0f},  // the chest
    {0.0f, 1.00f, 0.15f, 0.13f, 0, {0.0f, 1.13f}, -0.4f, 0.4f}, // the belly
    {0.0f, 1.62f, 0.13f, 0.00f, 0, {0.0f, 1.48f}, -0.5f, 0.5f}, // the head
    {-armX, 1.28f, 0.06f, 0.17f, 0, {-armX, 1.43f}, -2.5f, 0.8f},
    {-armX, 0.96f, 0.05f, 0.16f, 3, {-armX, 1.12f}, 0.0f, 2.4f},
    {armX, 1.28f, 0.06f, 0.17f, 0, {armX, 1.43f}, -0.8f, 2.5f},
    {armX, 0.96f, 0.05f, 0.16f, 5, {armX, 1.12f}, 0.0f, 2.4f},
    {-legX, 0.66f, 0.08f, 0.21f, 1, {-legX, 0.87f}, -0.4f, 1.6f},
    {-legX, 0.23f, 0.06f, 0.22f, 7, {-legX, 0.45f}, -2.4f, 0.0f},
    {legX, 0.66f, 0.08f, 0.21f, 1, {legX, 0.87f}, -0.4f, 1.6f},
    {legX, 0.23f, 0.06f, 0.22f, 9, {legX, 0.45f}, -2.4f, 0.0f},
};

/// Ragdolls tumble down stairs.
class Ragdolls final : public Scene {
    void Build(Stage &stage, int size) override {
        b2Body *ground = stage.AddBody(b2_staticBody, {0.0f, 0.0f});
        const float end = 2.0f * stair.x * stairs;
        stage.AddFixture(ground, MakeEdge({-20.0f, 0.0f}, {end + 20.0f, 0.0f}), 0.0f);
        const b2Vec2 wall(0.0f, stair.y * stairs);
        stage.AddFixture(ground, MakeEdge(wall, wall + b2Vec2(0.0f, 6.0f)), 0.0f);
        for (int i = 0; i < stairs; ++i) {
            const float height = stair.y * static_cast<float>(stairs - i);
            const b2Vec2 center((2.0f * static_cast<float>(i) + 1.0f) * stair.x, 0.5f * height);
            stage.AddFixture(ground, Material(0.0f, 0.5f), MakeBox(stair.x, 0.5f * height, center));
        }
        for (int i = 0; i < size; ++i) {
            const float x = 1.0f + (end - 2.0f) * static_cast<float>(i) / static_cast<float>(size);
            const float y = stair.y * (stairs - 0.5f * x / stair.x) + 1.0f + static_cast<float>(i % 3);
            AddRagdoll(stage, {x, y}, static_cast<int16>(-1 - i));
        }
    }

    /// Bones of one ragdoll do not collide with each other: they share a negative group.
    static void AddRagdoll(Stage &stage, b2Vec2 feet, int16 group) {
        std::vector<b2Body *> bones;
        for (const Bone &bone : kBones) {
            b2Body *body = stage.AddBody(b2_dynamicBody, feet + b2Vec2(bone.x, bone.y));
            b2FixtureDef def = Material(1.0f, 0.4f, 0.1f);
            def.filter.groupIndex = group;
            if (bone.halfHeight > 0.0f)
                stage.AddFixture(body, def, MakeBox(bone.halfWidth, bone.halfHeight));
            else
                stage.AddFixture(body, def, MakeCircle(bone.halfWidth));
            bones.push_back(body);
            if (bone.parent < 0)
                continue;
            b2RevoluteJointDef joint;
            joint.Initialize(bones[static_cast<std::size_t>(bone.parent)], body, feet + bone.joint);
            joint.enableLimit = true;
            joint.lowerAngle = bone.lower;
            joint.upperAngle = bone.upper;
            stage.AddJoint(joint);
        }
        bones[0]->SetLinearVelocity(stage.Rng().Direction(1.0f, 3.0f));
        bones[0]->SetAngularVelocity(stage.Rng().Uniform(-6.0f, 6.0f));
    }

    static constexpr int stairs = 12;
    const b2Vec2 stair{1.2f, 0.5f}; ///< half its width, and its height
};

/// Polygons, discs and bodies of three fixtures fall into a box, by turns.
class MixedPile final : public Scene {
    void Build(Stage &stage, int size) override {
        constexpr int columns = 12;
        constexpr float spacing = 1.5f, height = 20.0f;
        AddArena(stage, {0.0f, height}, 0.5f * spacing * columns + 0.5f, height, 0.0f);
        for (int i = 0; i < size; ++i) {
            const float x = spacing * (static_cast<float>(i % columns) - 0.5f * (columns - 1));
            const b2Vec2 place(x + stage.Rng().Uniform(-0.05f, 0.05f),
                               0.8f + spacing * static_cast<float>(i / columns));
            b2Body *body = stage.AddBody(b2_dynamicBody, place, stage.Rng().Uniform(-b2_pi, b2_pi));
            AddThing(stage, body, i % 3);
        }
    }

    static void AddThing(Stage &stage, b2Body *body, int kind) {
        const b2FixtureDef def = Material(1.0f, 0.4f, 0.1f);
        const float radius = stage.Rng().Uniform(0.35f, 0.6f);
        if (kind == 0) {
            stage.AddFixture(body, def, MakeRegular(3 + stage.Rng().Index(6), radius));
        } else if (kind == 1) {
            stage.AddFixture(body, def, MakeCircle(radius));
        } else { // a dumb-bell of a bar, a disc and a box
            stage.AddFixture(body, def, MakeBox(radius, 0.08f));
            stage.AddFixture(body, def, MakeCircle(0.25f, {radius, 0.0f}));
            stage.AddFixture(body, def, MakeBox(0.2f, 0.2f, {-radius, 0.0f}));
        }
    }
};

/// One of the scenes before these, at another size.
SceneInfo Resized(const std::vector<SceneInfo> &scenes, const char *of, const char *name,
                  const char *description, int size) {
    const auto found = std::find_if(scenes.begin(), scenes.end(), [of](const SceneInfo &scene) {
        return scene.name == std::string_view(of);
    });
    SceneInfo info = *found;
    info.name = name;
    info.description = description;
    info.group = "games";
    info.size = size;
    info.steps = 300;
    return info;
}

} // namespace

void AddGames(std::vector<SceneInfo> &scenes) {
    scenes.push_back(Resized(scenes, "pyramid", "pyramid-50", "the pyramid with 1275 boxes", 50));
    scenes.push_back({"cars", "cars drive to and fro among crates on a rolling road of edges", "games", 16,
                      300, CreateScene<Cars>});
    scenes.push_back({"chain-rocks", "rocks roll down a chain, are destroyed at its end, and made anew",
                      "games", 120, 300, CreateScene<ChainRocks>});
    scenes.push_back(
        {"ragdolls", "ragdolls of 11 bones tumble down stairs", "games", 16, 300, CreateScene<Ragdolls>});
    scenes.push_back(Resized(scenes, "needles", "needles-100", "the needles, a third of them", 100));
    scenes.push_back({"mixed-pile", "polygons, discs and bodies of three fixtures fall into a box", "games",
                      170, 300, CreateScene<MixedPile>});
}

} // namespace testbed
