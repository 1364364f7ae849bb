// SPDX-License-Identifier: MIT
//
// Things that are moved: by a motor, by gravity, by being shot.
#include "scene.h"
#include "shapes.h"

namespace testbed {
namespace {

class Tumbler final : public Scene {
    void Build(Stage &stage, int size) override {
        m_left = size;
        b2Body *ground = stage.AddBody(b2_staticBody, {0.0f, 0.0f});
        b2BodyDef def;
        def.type = b2_dynamicBody;
        def.allowSleep = false;
        def.position = center;
        b2Body *drum = stage.AddBody(def);
        stage.AddFixture(drum, MakeBox(0.5f, 10.0f, {10.0f, 0.0f}), 5.0f);
        stage.AddFixture(drum, MakeBox(0.5f, 10.0f, {-10.0f, 0.0f}), 5.0f);
        stage.AddFixture(drum, MakeBox(10.0f, 0.5f, {0.0f, 10.0f}), 5.0f);
        stage.AddFixture(drum, MakeBox(10.0f, 0.5f, {0.0f, -10.0f}), 5.0f);
        b2RevoluteJointDef hinge;
        hinge.Initialize(ground, drum, center);
        hinge.motorSpeed = 0.05f * b2_pi;
        hinge.maxMotorTorque = 1e8f;
        hinge.enableMotor = true;
        stage.AddJoint(hinge);
    }

    void BeforeStep(Stage &stage, int step) override {
        if (step == 0 || m_left == 0)
            return;
        --m_left;
        stage.AddFixture(stage.AddBody(b2_dynamicBody, center), MakeBox(0.125f, 0.125f), 1.0f);
    }

    const b2Vec2 center{0.0f, 10.0f};
    int m_left = 0;
};

class Dominos final : public Scene {
    void Build(Stage &stage, int size) override {
        b2Body *ground = stage.AddBody(b2_staticBody, {0.0f, 0.0f});
        stage.AddFixture(ground, MakeEdge({-40.0f, 0.0f}, {40.0f, 0.0f}), 0.0f);
        AddDominos(stage, size);
        b2Body *post = stage.AddBody(b2_staticBody, {-7.0f, 4.0f});
        stage.AddFixture(post, MakeBox(0.25f, 1.5f), 0.0f);
        // The hammer that swings into the first domino.
        b2Body *hammer = stage.AddBody(b2_dynamicBody, {-10.0f, 15.0f});
        stage.AddFixture(hammer, MakeBox(0.25f, 0.25f), 10.0f);
        stage.AddHinge(post, hammer, {-7.0f, 15.0f});
        AddSeesawAndBucket(stage, ground);
    }

    static void AddDominos(Stage &stage, int count) {
        b2Body *shelf = stage.AddBody(b2_staticBody, {-1.5f, 10.0f});
        stage.AddFixture(shelf, MakeBox(6.0f, 0.25f), 0.0f);
        b2Body *slide = stage.AddBody(b2_staticBody, {1.0f, 6.0f});
        stage.AddFixture(slide, MakeBox(7.0f, 0.25f, {0.0f, 0.0f}, 0.3f), 0.0f);
        const float spacing = 10.0f / static_cast<float>(count); // as many as there are, they share the shelf
        for (int i = 0; i < count; ++i) {
            b2Body *domino = stage.AddBody(b2_dynamicBody, {-6.0f + spacing * static_cast<float>(i), 11.25f});
            stage.AddFixture(domino, Material(20.0f, 0.1f), MakeBox(0.1f, 1.0f));
        }
    }

    static void AddSeesawAndBucket(Stage &stage, b2Body *ground) {
        b2Body *seesaw = stage.AddBody(b2_dynamicBody, {-0.9f, 1.0f}, -0.15f);
        stage.AddFixture(seesaw, MakeBox(6.0f, 0.125f), 10.0f);
        b2RevoluteJointDef hinge;
        hinge.Initialize(ground, seesaw, {-2.0f, 1.0f});
        hinge.collideConnected = true;
        stage.AddJoint(hinge);

        b2Body *bucket = stage.AddBody(b2_dynamicBody, {6.5f, 3.0f});
        const b2FixtureDef tin = Material(10.0f, 0.1f);
        stage.AddFixture(bucket, tin, MakeBox(1.0f, 0.1f, {0.0f, -0.9f}));
        stage.AddFixture(bucket, tin, MakeBox(0.1f, 1.0f, {-0.9f, 0.0f}));
        stage.AddFixture(bucket, tin, MakeBox(0.1f, 1.0f, {0.9f, 0.0f}));
        hinge.Initialize(ground, bucket, {6.0f, 2.0f});
        stage.AddJoint(hinge);
        b2Body *lid = stage.AddBody(b2_dynamicBody, {6.5f, 4.1f});
        stage.AddFixture(lid, MakeBox(1.0f, 0.1f), 30.0f);
        hinge.Initialize(bucket, lid, {7.5f, 4.0f});
        stage.AddJoint(hinge);

        b2Body *rod = stage.AddBody(b2_dynamicBody, {7.4f, 1.0f});
        stage.AddFixture(rod, MakeBox(0.1f, 1.0f), 10.0f);
        b2DistanceJointDef spring;
        spring.Initialize(seesaw, rod, seesaw->GetWorldPoint({6.0f, 0.0f}),
                          rod->GetWorldPoint({0.0f, -1.0f}));
        b2LinearStiffness(spring.stiffness, spring.damping, 1.0f, 1.0f, seesaw, rod);
        stage.AddJoint(spring);

        for (int i = 0; i < 4; ++i) {
            b2Body *ball = stage.AddBody(b2_dynamicBody, {5.9f + 0.4f * static_cast<float>(i), 2.4f});
            stage.AddFixture(ball, MakeCircle(0.2f), 10.0f);
        }
    }
};

/// Lanes of a plank, a post and a bullet that comes down on both.
class Bullet final : public Scene {
    struct Lane {
        float x;
        b2Body *plank, *bullet;
    };

    void Build(Stage &stage, int size) override {
        for (int i = 0; i < size; ++i) {
            const float x = 12.0f * static_cast<float>(i);
            b2Body *ground = stage.AddBody(b2_staticBody, {x, 0.0f});
            stage.AddFixture(ground, MakeEdge({-5.0f, 0.0f}, {5.0f, 0.0f}), 0.0f);
            stage.AddFixture(ground, MakeBox(0.2f, 1.0f, {0.5f, 1.0f}), 0.0f);
            b2Body *plank = stage.AddBody(b2_dynamicBody, {x, 4.0f});
            stage.AddFixture(plank, MakeBox(2.0f, 0.1f), 1.0f);
            b2BodyDef def;
            def.type = b2_dynamicBody;
            def.bullet = true;
            b2Body *bullet = stage.AddBody(def);
            stage.AddFixture(bullet, MakeBox(0.25f, 0.25f), 100.0f);
            m_lanes.push_back({x, plank, bullet});
            Launch(stage, m_lanes.back());
        }
    }

    void BeforeStep(Stage &stage, int step) override {
        if (step == 0 || step % 60 != 0)
            return;
        for (const Lane &lane : m_lanes)
            Launch(stage, lane);
    }

    static void Launch(Stage &stage, const Lane &lane) {
        lane.plank->SetTransform({lane.x, 4.0f}, 0.0f);
        lane.plank->SetLinearVelocity({0.0f, 0.0f});
        lane.plank->SetAngularVelocity(0.0f);
        lane.bullet->SetTransform({lane.x + stage.Rng().Uniform(-1.0f, 1.0f), 10.0f}, 0.0f);
        lane.bullet->SetLinearVelocity({0.0f, -50.0f});
        lane.bullet->SetAngularVelocity(0.0f);
    }

    std::vector<Lane> m_lanes;
};

} // namespace

void AddClassicMotion(std::vector<SceneInfo> &scenes) {
    scenes.push_back({"tumbler", "a slowly turning drum is filled with small boxes, one a step", "classic",
                      800, 600, CreateScene<Tumbler>});
    scenes.push_back(
        {"dominos", "a hammer, dominos, a seesaw and a bucket", "classic", 10, 600, CreateScene<Dominos>});
    scenes.push_back({"bullet", "bullets against a plank and a thin wall, shot again every second", "classic",
                      1, 600, CreateScene<Bullet>});
}

} // namespace testbed
