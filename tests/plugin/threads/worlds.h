// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_THREADS_WORLDS_H
#define BOOMERANG_TEST_THREADS_WORLDS_H

#include <memory>
#include <string>
#include <vector>

#include "../../as_stock/actor/actor.h"
#include "scene.h"
#include "state/snapshot.h"

namespace threads {

/// A scene of the testbed. Stock Box2D has no polygons of `vertices`, where that is not 0.
struct Chosen {
    const char *scene;
    int size;
    int vertices;
};

/// A world that remembers a line of hashes for each of its steps. It may be made, stepped and destroyed on
/// any threads, one at a time.
class World {
public:
    /// Of so many: scenes of the testbed, random worlds, and what the plugin alone has.
    static int Count();

    explicit World(int number) : m_number(number) {}
    World(const World &) = delete;
    World &operator=(const World &) = delete;

    void Build();
    void Step();
    /// The lines stay.
    void Destroy();
    const std::vector<std::string> &Lines() const { return m_lines; }

private:
    const int m_number;
    float m_timeStep = 1.0f / 60.0f;
    std::unique_ptr<testbed::Scene> m_scene;
    testbed::EventRecorder m_recorder;
    std::unique_ptr<testbed::Stage> m_stage;
    std::vector<uint8_t> m_bytes; ///< the actor's
    std::unique_ptr<actor::Actor> m_actor;
    std::vector<std::string> m_lines;
};

} // namespace threads

#endif
