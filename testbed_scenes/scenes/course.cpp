// SPDX-License-Identifier: MIT
#include <fstream>

#include "scene.h"
#include "shapes.h"

namespace testbed {
namespace {

struct PosedBody {
    b2Vec2 position;
    float angle;
};

struct CourseFile {
    int steps = 0;
    float timeStep = 0.0f;
    Vertices polygons[2];
    std::vector<PosedBody> poses[2];
};

/// The scene is made by a function without arguments.
CourseFile loaded;

/// Throws std::ios_base::failure where something is missing.
CourseFile ReadCourse(const std::string &file) {
    std::ifstream stream;
    stream.exceptions(std::ios::failbit);
    stream.open(file);
    CourseFile course;
    std::string word;
    stream >> word >> course.steps >> course.timeStep;
    for (Vertices &polygon : course.polygons) {
        std::size_t count = 0;
        stream >> word >> count;
        polygon.resize(count);
        for (b2Vec2 &vertex : polygon)
            stream >> vertex.x >> vertex.y;
    }
    for (int i = 0; i <= course.steps; ++i)
        for (std::vector<PosedBody> &poses : course.poses) {
            PosedBody pose = {};
            stream >> pose.position.x >> pose.position.y >> pose.angle;
            poses.push_back(pose);
        }
    return course;
}

class Course final : public Scene {
    void Build(Stage &stage, int /*size*/) override {
        stage.World().SetGravity({0.0f, 0.0f});
        for (int i = 0; i < 2; ++i) {
            b2BodyDef def;
            def.type = i == 0 ? b2_kinematicBody : b2_dynamicBody;
            def.bullet = i == 1;
            def.allowSleep = false;
            def.position = loaded.poses[i][0].position;
            def.angle = loaded.poses[i][0].angle;
            m_bodies[i] = stage.AddBody(def);
            AnySizePolygon(BodyKind::Many, loaded.polygons[i])
                .AddTo(stage, m_bodies[i], Material(1.0f, 0.0f));
        }
    }

    void BeforeStep(Stage & /*stage*/, int step) override {
        if (step >= loaded.steps)
            return;
        const float rate = 1.0f / loaded.timeStep;
        for (int i = 0; i < 2; ++i) {
            b2Body *body = m_bodies[i];
            const PosedBody &next = loaded.poses[i][static_cast<size_t>(step) + 1];
            const b2Transform target(next.position, b2Rot(next.angle));
            body->SetLinearVelocity(rate * (b2Mul(target, body->GetLocalCenter()) - body->GetWorldCenter()));
            body->SetAngularVelocity(rate * (next.angle - body->GetAngle()));
        }
    }

    b2Body *m_bodies[2] = {};
};

} // namespace

SceneInfo CourseScene(const std::string &file) {
    loaded = ReadCourse(file);
    SceneInfo info = {"course",           "two bodies led through given poses", "course", 1, loaded.steps,
                      CreateScene<Course>};
    info.timeStep = loaded.timeStep;
    return info;
}

} // namespace testbed
