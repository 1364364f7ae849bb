// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_WORLD_FIGURES_H
#define BOOMERANG_TESTBED_WORLD_FIGURES_H

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "worlds/run.h"

namespace testbed {

/// What a run of a kinetic world is told to do beside its choice.
struct MeasureOptions {
    bool check = false; ///< CheckOverlaps at the end
    bool audit = false; ///< bmr_world_audit some times in the run, and at the end
    int slices = 100;   ///< equally long parts of the run
    /// Told at the beginning and after each slice how much is done, from 0 to 1. It is not part of what is
    /// timed.
    std::function<void(const WorldRun &, double part)> onSlice;
    WorldRun::ContactHandler onContact;
    WorldRun::EventHandler onEvent;
};

/// What a run came to.
struct WorldFigures {
    WorldChoice choice;
    double side = 0.0; ///< of the box
    bmr_world_counts counts = {};
    uint64_t plans = 0; ///< that bodies got; beside the events, of which the plan's pieces are some
    double clock = 0.0; ///< seconds of the processor, without making the bodies
    /// Changes since the start: of energy as a share of it; of momentum, as a share of the sum of mass *
    /// speed; of angular momentum, as a share of that times the box's side. None where something takes it
    /// from outside: a plan, a wall, an answer that is not elastic.
    std::optional<double> energy, momentum, angular;
    double energyLeft = 1.0; ///< as a share of that at the start
    std::optional<OverlapCheck> check;
    size_t audits = 0;

    uint64_t Events() const;
    /// Of one kind, or of all: for each body and unit of time.
    double Rate(uint64_t events) const;
    double MicrosecondsAnEvent() const;
};

/// Runs a setup's world for the choice's time. Throws WorldStopped.
WorldFigures Measure(const WorldSetup &setup, const MeasureOptions &options);

nlohmann::json ToJson(const WorldFigures &figures);

const char *NameOf(bmr_boundary boundary);
/// "elastic", "restitution 0.9", "stick" or "pass".
std::string NameOf(const bmr_response &response);

} // namespace testbed

#endif
