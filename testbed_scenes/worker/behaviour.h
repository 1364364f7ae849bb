// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_BEHAVIOUR_H
#define BOOMERANG_TESTBED_BEHAVIOUR_H

#include <cstdint>
#include <map>

#include <nlohmann/json.hpp>

#include <box2d/box2d.h>

namespace testbed {

/// How a world moves, so that worlds whose bits cannot be compared can be held against each other.
class Behaviour {
public:
    /// After each step.
    void AddStep(const b2World &world);

    /// awake: dynamic bodies awake at the end. asleep_from: the step from which on all sleep, null where they
    /// do not. overlap: the deepest of all touching contacts' points at the end, metres below the skins;
    /// overlap_deepest: of any step. energy: kinetic and potential, joules, at the end; energy_start: after
    /// the first step; energy_gain: the most that it was above that. moved: metres between where a dynamic
    /// body is and where the first step left it, on average; moved_most: of all.
    nlohmann::json ToJson() const;

private:
    void AddMoved(const b2World &world);

    std::map<uint32_t, b2Vec2> m_places; ///< of dynamic bodies after the first step, by number
    long m_steps = 0, m_asleepFrom = -1;
    int m_awake = 0;
    float m_overlap = 0.0f, m_deepest = 0.0f;
    double m_energy = 0.0, m_energyStart = 0.0, m_energyGain = 0.0;
    double m_moved = 0.0, m_movedMost = 0.0;
};

} // namespace testbed

#endif
