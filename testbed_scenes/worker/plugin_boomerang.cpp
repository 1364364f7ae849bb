// SPDX-License-Identifier: MIT
#include "worker/plugin.h"

#include <cinttypes>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include <CLI/CLI.hpp>
#include <boomerang/box2d.h>

#include "stage.h"

namespace testbed {
namespace {

struct Trace {
    std::FILE *file = nullptr;
    int step = 0;
};

// The plugin's options are for the whole process, and so is the trace.
Trace trace;

void WriteEvent(void *, const b2Body *bodyA, const b2Body *bodyB, const bmr_event &event) {
    std::fprintf(trace.file, "%d %" PRIu32 " %" PRIu32 " %s %d %d %d %.9g\n", trace.step, NumberOf(*bodyA),
                 NumberOf(*bodyB), bmr_event_name(event.kind), event.level_before, event.level_after,
                 static_cast<int>(event.pair->owner), event.gap);
}

void OpenTrace(const std::string &name) {
    trace.file = std::fopen(name.c_str(), "w");
    if (trace.file == nullptr)
        throw std::runtime_error("cannot write " + name);
    std::fputs("# step bodyA bodyB kind level_before level_after owner(0=A,1=B) gap\n", trace.file);
}

bmr_structure StructureOf(const std::string &name) {
    for (int i = 0; i < BMR_STRUCTURE_COUNT; ++i)
        if (name == bmr_structure_name(static_cast<bmr_structure>(i)))
            return static_cast<bmr_structure>(i);
    throw std::runtime_error("the plugin knows no structure " + name);
}

} // namespace

void AddPluginOptions(CLI::App &app, PluginOptions &options) {
    app.add_option("--structure", options.structure, "The kinetic structure of body pairs")
        ->option_text("lazy-compass|lazy-dudley|free-direction [free-direction]")
        ->check(CLI::IsMember({"lazy-compass", "lazy-dudley", "free-direction"}).description(""));
    app.add_option("--prefilter", options.prefilter, "Ask one remembered edge before the structure")
        ->option_text("on|off [on]")
        ->check(CLI::IsMember({"on", "off"}).description(""));
    app.add_option("--trace", options.trace, "Write each event of each pair to this file, a line per event")
        ->option_text("FILE");
}

void InstallPlugin(const PluginOptions &options, bool count) {
    bmr::Options install;
    install.structure = StructureOf(options.structure);
    install.prefilter = options.prefilter == "on";
    install.statistics = count || !options.trace.empty();
    if (!options.trace.empty()) {
        OpenTrace(options.trace);
        install.onEvent = WriteEvent;
    }
    if (!bmr::Install(install))
        throw std::runtime_error("the plugin would not install");
}

void SetTraceStep(int step) {
    trace.step = step;
}

void FinishTrace() {
    if (trace.file == nullptr)
        return;
    const bool written = std::ferror(trace.file) == 0;
    const bool closed = std::fclose(trace.file) == 0;
    trace.file = nullptr;
    if (!written || !closed)
        throw std::runtime_error("the trace could not be written to its end");
}

const char *PluginName() {
    return "plugin";
}

nlohmann::json PluginStatistics() {
    const bmr::Statistics counted = bmr::GetStatistics();
    nlohmann::json events;
    for (int kind = 0; kind < BMR_EVENT_KIND_COUNT; ++kind)
        events[bmr_event_name(static_cast<bmr_event_kind>(kind))] = counted.kinetic.events[kind];
    return {{"evaluations", counted.evaluations},
            {"edge_checks", counted.edgeChecks},
            {"edge_searches", counted.edgeSearches},
            {"verdicts_reused", counted.verdictsReused},
            {"proved_apart", counted.provedApart},
            {"handed_over", counted.handedOver},
            {"handed_over_touching", counted.handedOverTouching},
            {"touching_answered", counted.touchingAnswered},
            {"toi_queries", counted.toiQueries},
            {"toi_answered", counted.toiAnswered},
            {"overlap_queries", counted.overlapQueries},
            {"overlaps_answered", counted.overlapsAnswered},
            {"verified", counted.verified},
            {"differences", counted.differences},
            {"pairs", counted.pairs},
            {"hulls", counted.hulls},
            {"checks", counted.kinetic.checks},
            {"levels", counted.kinetic.levels},
            {"events", events}};
}

SlackFunction PluginSlack() {
    return bmr::CertifiedSlack;
}

} // namespace testbed
