// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_SUMMARY_H
#define BOOMERANG_TESTBED_SUMMARY_H

#include <cstdint>
#include <optional>

#include <box2d/box2d.h>
#include <nlohmann/json.hpp>

#include "count/count.h"
#include "scene.h"
#include "state/snapshot.h"
#include "worker/options.h"

namespace testbed {

/// Gathers, step by step, what the last line of a run says.
class Summary {
public:
    Summary(const SceneInfo &info, const Options &options);

    void AddStep(const b2World &world, long nanoseconds);
    void AddHashes(const StateHashes &hashes);

    /// In every mode: scene, program, mode, size, seed, steps (done), bodies, contacts and polygon_contacts
    /// (means per step; in time mode contacts only). Hash: hash. Time: step_ns_total, collide_ms_total.
    /// Count: see AddCalls in summary.cpp; plugin (null for stock). Scenes with polygons
    /// to choose: vertices, kind.
    nlohmann::json ToJson(const b2World &world) const;

private:
    const SceneInfo &m_info;
    const Options &m_options;
    long m_steps = 0;
    long m_contacts = 0, m_polygonContacts = 0;
    HashSink m_hash;
    long m_nanoseconds = 0;
    double m_collide = 0.0; ///< of Box2D's profile, in milliseconds
    uint32_t m_toiRunsBefore, m_gjkRunsBefore;
    std::optional<boomerang_counts> m_callsBefore; ///< the plugin makes some when it is installed
};

} // namespace testbed

#endif
