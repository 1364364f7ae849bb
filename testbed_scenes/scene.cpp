// SPDX-License-Identifier: MIT
#include "scene.h"

namespace testbed {

void Scene::BeforeStep(Stage &, int) {}
void Scene::OnBegin(b2Contact &) {}
void Scene::OnEnd(b2Contact &) {}
void Scene::OnPreSolve(b2Contact &, const b2Manifold &) {}
void Scene::OnPostSolve(b2Contact &, const b2ContactImpulse &) {}
void Scene::OnGoodbye(b2Joint &) {}

SceneInfo SceneOfAFile(const char *name, const char *description, int steps, float timeStep,
                       std::unique_ptr<Scene> (*create)()) {
    SceneInfo info = {};
    info.name = name;
    info.description = description;
    info.group = name;
    info.size = 1;
    info.steps = steps;
    info.create = create;
    info.seed = 1;
    info.timeStep = timeStep;
    info.velocityIterations = 8;
    info.positionIterations = 3;
    return info;
}

} // namespace testbed
