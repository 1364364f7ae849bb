// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_SUMMARY_H
#define BOOMERANG_TESTBED_SUMMARY_H

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include <box2d/box2d.h>
#include <nlohmann/json.hpp>

#include "count/count.h"
#include "scene.h"
#include "state/snapshot.h"
#include "worker/options.h"

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

/// Gathers, step by step, what the last line of a run says.
class Summary {
public:
    Summary(const SceneInfo &info, const Options &options, int steps);

    void AddStep(const b2World &world, long nanoseconds);
    void AddHashes(const StateHashes &hashes);

    /// In every mode: scene, program, mode, size, seed, steps (done), bodies, contacts and polygon_contacts
    /// (means per step; in time mode contacts only). Hash: hash. Time: step_ns_total, step_ns_median,
    /// collide_ms_total, solve_ms, broadphase_ms, solveTOI_ms. (Run adds steps_processor_s.) Count: see
    /// AddCalls in summary.cpp; plugin (null for stock); what Behaviour says. Scenes with polygons to choose:
    /// vertices, kind.
    nlohmann::json ToJson(const b2World &world) const;

private:
    void AddTimes(nlohmann::json &json) const;

    const SceneInfo &m_info;
    const Options &m_options;
    const int m_stepsWanted;
    long m_steps = 0;
    long m_contacts = 0, m_polygonContacts = 0;
    Behaviour m_behaviour;
    HashSink m_hash;
    std::vector<long> m_nanoseconds;
    // Box2D's profile, summed: floats of milliseconds.
    double m_collide = 0.0, m_solve = 0.0, m_broadphase = 0.0, m_solveToi = 0.0;
    uint32_t m_toiRunsBefore, m_gjkRunsBefore;
    std::optional<boomerang_counts> m_callsBefore; ///< the plugin makes some when it is installed
};

} // namespace testbed

#endif
