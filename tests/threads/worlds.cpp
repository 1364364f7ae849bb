// SPDX-License-Identifier: MIT
#include "worlds.h"

#include <cinttypes>
#include <cstdio>

#include "../differential/random_world.h"
#include "program.h"

namespace threads {

namespace {

/// Boxes, circles, edges and chains, bodies of many fixtures, bullets, sensors and joints; things that are
/// made and destroyed all the time.
constexpr Chosen kScenes[] = {{"pyramid", 6, 0},    {"bullets", 15, 0}, {"sensors", 20, 0}, {"churn", 30, 0},
                              {"coins-gas", 14, 0}, {"gears", 1, 0},    {"terrain", 15, 0}, {"planks", 30, 0},
                              {"car", 2, 0},        {"compound", 1, 0}};
constexpr int kCountScenes = static_cast<int>(sizeof kScenes / sizeof *kScenes);
constexpr int kRandomWorlds = 6, kRandomSize = 10;

/// nullptr: the world is a random one.
const Chosen *SceneOf(int number) {
    if (number < kCountScenes)
        return &kScenes[number];
    const int after = number - kCountScenes - kRandomWorlds;
    return after < 0 ? nullptr : &ScenesOfThePlugin()[static_cast<size_t>(after)];
}

} // namespace

int World::Count() {
    return kCountScenes + kRandomWorlds + static_cast<int>(ScenesOfThePlugin().size());
}

void World::Build() {
    const Chosen *chosen = SceneOf(m_number);
    const testbed::SceneInfo *info = chosen != nullptr ? testbed::FindScene(chosen->scene) : nullptr;
    if (info != nullptr) {
        m_scene = info->create();
        m_timeStep = info->timeStep;
    } else {
        m_scene = std::make_unique<differential::RandomWorld>();
    }
    const unsigned long seed = info != nullptr ? info->seed : static_cast<unsigned long>(m_number);
    m_stage = std::make_unique<testbed::Stage>(*m_scene, seed, &m_recorder);
    if (chosen != nullptr && chosen->vertices != 0)
        m_stage->SetPolygons({testbed::BodyKind::One, chosen->vertices});
    m_recorder.StartStep(false);
    m_scene->Build(*m_stage, chosen != nullptr ? chosen->size : kRandomSize);
}

void World::Step() {
    const int step = static_cast<int>(m_lines.size());
    m_recorder.StartStep(false);
    m_scene->BeforeStep(*m_stage, step);
    const auto *random = dynamic_cast<const differential::RandomWorld *>(m_scene.get());
    m_stage->World().Step(random != nullptr ? random->TimeStep() : m_timeStep, 8, 3);
    const testbed::StateHashes h = testbed::HashState(m_stage->World(), m_recorder);
    char line[128];
    std::snprintf(line, sizeof line, "%d %d %016" PRIx64 " %016" PRIx64 " %016" PRIx64, m_number, step,
                  h.bodies, h.contacts, h.events);
    m_lines.emplace_back(line);
}

void World::Destroy() {
    m_stage = nullptr;
    m_scene = nullptr;
}

} // namespace threads
