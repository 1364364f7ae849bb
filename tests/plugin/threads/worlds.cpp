// SPDX-License-Identifier: MIT
#include "worlds.h"

#include <cinttypes>
#include <cstdio>

namespace threads {

namespace {

/// Boxes, circles, edges and chains, bodies of many fixtures, bullets, sensors and joints; things that are
/// made and destroyed all the time.
constexpr Chosen kScenes[] = {
    {"pyramid", 6, 0}, {"bullets", 15, 0}, {"sensors", 20, 0}, {"chain-rocks", 30, 0}, {"coins-gas", 14, 0},
    {"gears", 1, 0},   {"terrain", 15, 0}, {"planks", 30, 0},  {"car", 2, 0},          {"compound", 1, 0}};
constexpr int kCountScenes = static_cast<int>(sizeof kScenes / sizeof *kScenes);
/// Polygons of any size, which stock has not.
const std::vector<Chosen> kScenesOfThePlugin = {
#if defined(WITH_PLUGIN)
    {"any-gas", 12, 64},           {"any-gas", 12, 64},          {"any-bag", 20, 24},  {"any-bag", 20, 24},
    {"any-bullets", 8, 20},        {"any-bullets", 8, 20},       {"any-wheels", 4, 9}, {"any-wheels", 4, 9},
    {"asteroids-outline", 12, 24}, {"asteroids-outline", 12, 24}
#endif
};
/// Worlds of the actor that stock Box2D survives.
constexpr int kSeeds[] = {1, 2, 3, 4, 7, 8, 11, 16};
constexpr int kRandomWorlds = static_cast<int>(sizeof kSeeds / sizeof *kSeeds);

/// nullptr: the actor's.
const Chosen *SceneOf(int number) {
    if (number < kCountScenes)
        return &kScenes[number];
    const int after = number - kCountScenes - kRandomWorlds;
    return after < 0 ? nullptr : &kScenesOfThePlugin[static_cast<size_t>(after)];
}

} // namespace

int World::Count() {
    return kCountScenes + kRandomWorlds + static_cast<int>(kScenesOfThePlugin.size());
}

void World::Build() {
    const Chosen *chosen = SceneOf(m_number);
    if (chosen == nullptr) {
        m_bytes = actor::BytesOf(static_cast<uint32_t>(kSeeds[m_number - kCountScenes]));
        m_actor = std::make_unique<actor::Actor>(m_bytes.data(), m_bytes.size());
        return;
    }
    const testbed::SceneInfo *info = testbed::FindScene(chosen->scene);
    m_scene = info->create();
    m_timeStep = info->timeStep;
    m_stage = std::make_unique<testbed::Stage>(*m_scene, testbed::kSeed, &m_recorder);
    m_stage->SetPolygons(chosen->vertices != 0
                             ? testbed::PolygonChoice{testbed::BodyKind::One, chosen->vertices}
                             : info->polygons);
    m_recorder.StartStep(false);
    m_scene->Build(*m_stage, chosen->size);
}

void World::Step() {
    const int step = static_cast<int>(m_lines.size());
    testbed::StateHashes h = {};
    if (m_actor != nullptr) {
        actor::Record record;
        if (m_actor->PlayOn(&record))
            h = {record.bodies, record.contacts, record.events};
    } else {
        m_recorder.StartStep(false);
        m_scene->BeforeStep(*m_stage, step);
        m_stage->World().Step(m_timeStep, 8, 3);
        h = testbed::HashState(m_stage->World(), m_recorder);
    }
    char line[128];
    std::snprintf(line, sizeof line, "%d %d %016" PRIx64 " %016" PRIx64 " %016" PRIx64, m_number, step,
                  h.bodies, h.contacts, h.events);
    m_lines.emplace_back(line);
}

void World::Destroy() {
    m_stage = nullptr;
    m_scene = nullptr;
    m_actor = nullptr;
}

} // namespace threads
