// SPDX-License-Identifier: MIT
#include "worlds/world.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iterator>
#include <numeric>

namespace testbed {
namespace {

/// How often a run is audited.
constexpr int kAudits = 4;

void SetDrifts(const WorldRun &run, const WorldSetup &setup, WorldFigures *figures) {
    const WorldChoice &choice = setup.choice;
    const bmr_world_totals from = run.TotalsAtStart(), to = run.Totals();
    const bool planned = setup.planEvery > 0.0;
    const bool elastic = choice.response.kind == BMR_RESPONSE_PASS ||
                         (choice.response.kind == BMR_RESPONSE_IMPULSE && choice.response.restitution == 1.0);
    if (from.energy > 0.0)
        figures->energyLeft = to.energy / from.energy;
    if (planned || !(from.energy > 0.0))
        return;
    if (elastic)
        figures->energy = (to.energy - from.energy) / from.energy;
    if (choice.boundary == BMR_WALLED)
        return;
    const bmr_vec2 change = bmr_sub(to.momentum, from.momentum);
    figures->momentum = std::hypot(change.x, change.y) / run.MomentumScale();
    if (choice.boundary == BMR_OPEN && choice.response.kind != BMR_RESPONSE_STICK)
        figures->angular = (to.angular - from.angular) / (run.MomentumScale() * figures->side);
}

} // namespace

uint64_t WorldFigures::Events() const {
    return std::accumulate(std::begin(counts.events), std::end(counts.events), uint64_t{0});
}

double WorldFigures::Rate(uint64_t events) const {
    return static_cast<double>(events) / (static_cast<double>(choice.bodies) * choice.seconds);
}

double WorldFigures::MicrosecondsAnEvent() const {
    return Events() > 0 ? 1e6 * clock / static_cast<double>(Events()) : 0.0;
}

WorldFigures Measure(const WorldSetup &setup, const MeasureOptions &options) {
    WorldFigures figures;
    figures.choice = setup.choice;
    figures.side = setup.high.x - setup.low.x;
    std::clock_t start = std::clock(); // of the processor, not on the wall
    WorldRun run(setup, options.onContact, options.onEvent);
    std::clock_t spent = std::clock() - start;
    if (options.onSlice)
        options.onSlice(run, 0.0);
    for (int slice = 1; slice <= options.slices; ++slice) {
        const double part = static_cast<double>(slice) / options.slices;
        start = std::clock();
        run.Advance(setup.choice.seconds * part);
        spent += std::clock() - start;
        if (options.audit && slice * kAudits / options.slices > (slice - 1) * kAudits / options.slices) {
            run.Audit();
            ++figures.audits;
        }
        if (options.onSlice)
            options.onSlice(run, part);
    }
    figures.clock = static_cast<double>(spent) / CLOCKS_PER_SEC;
    figures.counts = run.Counts();
    figures.plans = run.Plans();
    SetDrifts(run, setup, &figures);
    if (options.check)
        figures.check = CheckOverlaps(run, setup);
    return figures;
}

const char *NameOf(bmr_boundary boundary) {
    return boundary == BMR_OPEN ? "open" : boundary == BMR_WALLED ? "walls" : "periodic";
}

std::string NameOf(const bmr_response &response) {
    switch (response.kind) {
    case BMR_RESPONSE_PASS:
        return "pass";
    case BMR_RESPONSE_STICK:
        return "stick";
    default:
        break;
    }
    if (response.restitution == 1.0)
        return "elastic";
    char text[40];
    std::snprintf(text, sizeof text, "restitution %.6g", response.restitution);
    return text;
}

} // namespace testbed
