// SPDX-License-Identifier: MIT
#include "replay_command.h"

#include <cstdio>
#include <iostream>

#include <CLI/CLI.hpp>

#include "commands.h"
#include "output_file.h"
#include "progress.h"
#include "recorded_run.h"
#include "replay/collect.h"
#include "replay/page.h"

namespace testbed {
namespace {

/// More would be gigabytes here, and more than a browser holds with ease.
constexpr int64_t kMostSteps = 20000;

constexpr char kNotes[] =
    "The page holds its data, style and script: it opens from a file, without a network, in any browser of "
    "2023 or later.\nEach contact of two polygons has its events, and so have the hulls of bodies with many; "
    "with --prefilter off hulls alone.";

std::string Megabytes(size_t bytes) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f MB", static_cast<double>(bytes) / 1e6);
    return text;
}

/// Both runs of the scene, one after the other: a recording is as much work to read as to write.
replay::Collector Record(const RecordRequest &plugin, Side stockSide, const Workers &workers,
                         recording::Head *head, bool quiet) {
    replay::Collector collector;
    Progress progress(2, quiet);
    const auto run = [&](const RecordRequest &request, const std::string &what, const auto &add) {
        const double frames = static_cast<double>(request.last + 1);
        int64_t done = 0;
        progress.Show(request.scene + what, 0.0);
        RunRecorded(
            workers, request,
            [&](const recording::Head &its, recording::Frame frame) {
                if (request.side == Side::Plugin)
                    *head = its;
                add(frame);
                progress.Show(request.scene + what, static_cast<double>(++done) / frames);
            },
            [&progress] { progress.Tick(); });
        progress.Finish();
    };
    run(plugin, ", with the plugin", [&](const recording::Frame &frame) { collector.AddPlugin(frame); });
    RecordRequest stock = plugin;
    stock.side = stockSide;
    stock.boxes = false;
    run(stock, std::string(", ") + NameOf(stockSide),
        [&](const recording::Frame &frame) { collector.AddStock(frame); });
    return collector;
}

/// The page of a recording that is here already, of one run.
int ReplayRecording(const ReplayCommand &command, OutputFile *file) {
    replay::Collector collector;
    recording::Head head;
    ReadRecorded(command.recording, [&](const recording::Head &its, const recording::Frame &frame) {
        head = its;
        collector.AddPlugin(frame);
    });
    replay::Replay replay = collector.Finish();
    replay.pluginCalls.clear();
    replay.about = {{"scene", head.scene},
                    {"description", "a kinetic world, every event at its own time"},
                    {"structure", head.structure},
                    {"size", head.size},
                    {"seed", head.seed},
                    {"world", true},
                    {"period", {head.period.x, head.period.y}},
                    {"timeStep", static_cast<double>(head.time_step)}};
    const std::string page = replay::PageOf(replay);
    file->Stream() << page;
    file->Close();
    if (!command.quiet)
        std::cout << command.output << ": " << head.scene << ", " << replay.stepCount << " frames, "
                  << head.size << " bodies, " << Megabytes(page.size()) << '\n';
    return kExitOk;
}

nlohmann::json About(const SceneInfo &scene, const recording::Head &head) {
    return {{"scene", scene.name},
            {"description", scene.description},
            {"structure", head.structure},
            {"prefilter", head.prefilter ? "on" : "off"},
            {"size", head.size},
            {"seed", head.seed},
            {"stock", NameOf(StockFor(scene))},
            {"timeStep", static_cast<double>(head.time_step)}};
}

} // namespace

CLI::App *AddReplay(CLI::App &app, ReplayCommand &command) {
    CLI::App *replay = app.add_subcommand(
        "replay",
        "Write a page that plays a scene: what is proved, what happens to each pair, what stock does");
    CLI::Option *scene = replay->add_option("scene", command.scene, "A name that `list` shows");
    CLI::Option *steps =
        replay->add_option("--steps", command.steps, "Steps to play (default: the scene's own)")
            ->check(CLI::Range(static_cast<int64_t>(1), kMostSteps));
    replay->add_option("--recording", command.recording, "Instead of a scene: what `world --record` wrote")
        ->check(CLI::ExistingFile)
        ->excludes(scene)
        ->excludes(steps);
    replay->add_option("-o,--output", command.output, "The page: .html")->required();
    replay->add_flag("--quiet", command.quiet, "Say nothing but what is wrong");
    replay->footer(kNotes);
    return replay;
}

int Execute(const ReplayCommand &command, const Workers &workers) {
    if (!command.recording.empty()) {
        OutputFile file(command.output);
        return ReplayRecording(command, &file);
    }
    if (command.scene.empty())
        throw UsageError("a scene is wanted, or --recording FILE");
    const SceneInfo scene = FindScene(workers.List(), command.scene);
    OutputFile file(command.output);
    if (!workers.CanCount() && !command.quiet)
        std::cerr << "note: libboomerang-count.so is not built: calls of Box2D stay uncounted\n";
    RecordRequest request;
    request.scene = scene.name;
    request.last = command.steps.value_or(scene.steps) - 1;
    request.boxes = true;
    request.calls = true;
    request.compact = true;
    request.worker = command.worker;

    recording::Head head;
    replay::Collector collector = Record(request, StockFor(scene), workers, &head, command.quiet);
    const std::optional<int64_t> difference = collector.FirstDifference();
    replay::Replay replay = collector.Finish();
    replay.about = About(scene, head);
    if (!head.counts_calls) {
        replay.pluginCalls.clear();
        replay.stockCalls.clear();
    }
    if (difference)
        replay.about["difference"] = *difference;
    const std::string page = replay::PageOf(replay);
    file.Stream() << page;
    file.Close();
    if (!command.quiet)
        std::cout << command.output << ": " << scene.name << ", " << replay.stepCount << " steps, "
                  << replay.bodies.size() << " bodies, " << Megabytes(page.size()) << '\n';
    if (!difference)
        return kExitOk;
    std::cerr << "boomerang-testbed: the runs with and without the plugin differ after step " << *difference
              << "; `compare " << scene.name << "` says where\n";
    return kExitDifferent;
}

} // namespace testbed
