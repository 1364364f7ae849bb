// SPDX-License-Identifier: MIT
// scene_steps SCENE STEPS: so many steps of a scene of the testbed, and a hash of where its bodies are then.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>

#include "scene.h"

int main(int count, char **words) {
    const testbed::SceneInfo *info = count == 3 ? testbed::FindScene(words[1]) : nullptr;
    if (info == nullptr)
        return 2;
    const auto scene = info->create();
    testbed::Stage stage(*scene, info->seed, nullptr);
    stage.SetPolygons(info->polygons);
    scene->Build(stage, info->size);
    const int steps = std::atoi(words[2]);
    for (int step = 0; step < steps; ++step) {
        scene->BeforeStep(stage, step);
        stage.World().Step(info->timeStep, info->velocityIterations, info->positionIterations);
    }
    uint64_t hash = 0;
    for (const b2Body *body = stage.World().GetBodyList(); body != nullptr; body = body->GetNext())
        hash = hash * 1099511628211u + static_cast<uint64_t>(1e9 * body->GetPosition().x) +
               static_cast<uint64_t>(1e9 * body->GetPosition().y);
    std::printf("%016" PRIx64 "\n", hash);
    return 0;
}
