// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_SUMMARY_H
#define BOOMERANG_TESTBED_SUMMARY_H

#include <optional>
#include <vector>

#include <nlohmann/json.hpp>

#include "count/count.h"
#include "scene.h"
#include "state/snapshot.h"
#include "worker/behaviour.h"
#include "worker/options.h"

namespace testbed {

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
