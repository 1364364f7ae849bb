// SPDX-License-Identifier: MIT
#include "commands.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include <CLI/CLI.hpp>

#include "output_file.h"
#include "progress.h"
#include "recorded_run.h"
#include "replay/collect.h"
#include "replay/encoding.h"
#include "theory/record_course.h"

namespace testbed {
namespace {

/// More would be gigabytes here, and more than a browser holds with ease.
constexpr int64_t kMostSteps = 20000;

constexpr char kNotes[] =
    "The page holds its data, style and script: it opens from a file, without a network, in any browser of "
    "2023 or later; its address has the step, the choice and the view.\nEach contact of two polygons has its "
    "events, and so have the hulls of bodies with many; "
    "with --structure hulls alone.";

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

/// Takes the frames of one run, and writes the page of a world without Box2D.
class KineticPage {
public:
    void Add(const recording::Head &head, const recording::Frame &frame) {
        m_head = head;
        m_collector.AddPlugin(frame);
    }
    int Write(const ReplayCommand &command, OutputFile *file, const nlohmann::json &more) {
        replay::Replay replay = m_collector.Finish();
        replay.pluginCalls.clear();
        replay.about = {{"scene", m_head.scene},
                        {"description", "a kinetic world, every event at its own time"},
                        {"structure", m_head.structure},
                        {"size", m_head.size},
                        {"seed", m_head.seed},
                        {"world", true},
                        {"period", {m_head.period.x, m_head.period.y}},
                        {"timeStep", static_cast<double>(m_head.time_step)}};
        replay.about.update(more);
        const std::string page = replay::PageOf(replay);
        file->Stream() << page;
        file->Close();
        if (!command.quiet)
            std::cout << command.output << ": " << replay.about["scene"].get<std::string>() << ", "
                      << replay.stepCount << " frames, " << m_head.size << " bodies, "
                      << Megabytes(page.size()) << '\n';
        return kExitOk;
    }

private:
    replay::Collector m_collector;
    recording::Head m_head;
};

/// The page of a recording that is here already, of one run.
int ReplayRecording(const ReplayCommand &command, OutputFile *file) {
    KineticPage page;
    ReadRecorded(command.recording, [&page](const recording::Head &head, const recording::Frame &frame) {
        page.Add(head, frame);
    });
    return page.Write(command, file, nlohmann::json::object());
}

const bmr_kds_info &PairStructure(const std::string &name) {
    const bmr_kds_info *found = nullptr;
    if (bmr_kds_find(name.empty() ? "lazy-compass" : name.c_str(), &found) != BMR_OK)
        throw UsageError("--structure: " + name +
                         " is the plugin's; of a pair of one's own it is one of the paper's "
                         "(events --list shows all)");
    return *found;
}

/// One's own two polygons on one's own motion.
int ReplayPair(const ReplayCommand &command) {
    constexpr int64_t kSteps = 300;
    if (command.polygons.empty() || command.polygons.size() > 2 || command.motion.empty())
        throw UsageError(
            "--polygon A --polygon B --motion M: a pair of one's own needs them all (one --polygon: both "
            "alike)");
    if (!command.scene.empty() || !command.recording.empty())
        throw UsageError("a scene, --recording FILE or --polygon and --motion: one of the three");
    if (command.worker.size || command.worker.seed)
        throw UsageError("--size and --seed are a scene's");
    const bmr_kds_info &structure = PairStructure(command.worker.structure);
    OutputFile file(command.output);
    KineticPage page;
    try {
        const auto a = std::make_shared<const Body>(ReadPolygonFile(command.polygons.front())),
                   b = std::make_shared<const Body>(ReadPolygonFile(command.polygons.back()));
        const MotionFile motion = ReadMotionFile(command.motion);
        const Course course(a, b, motion);
        if (!Takes(structure, course))
            throw UsageError(std::string("--structure: ") + structure.name +
                             " does not take two polygons that turn");
        RecordCourse(
            course, structure, command.steps.value_or(kSteps),
            [&page](const recording::Head &head, const recording::Frame &frame) { page.Add(head, frame); });
    } catch (const FileError &error) {
        throw UsageError(error.what());
    }
    return page.Write(command, &file,
                      {{"scene", std::filesystem::path(command.motion).filename().string()},
                       {"description", "two polygons of one's own, every event at its own time"},
                       {"boxes", false},
                       {"pair", true}});
}

nlohmann::json About(const SceneInfo &scene, const recording::Head &head) {
    return {{"scene", scene.name},
            {"description", scene.description},
            {"structure", head.structure},
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
    replay
        ->add_option("--polygon", command.polygons,
                     "Instead of a scene: a polygon of one's own, as for `events`; twice: A's and B's")
        ->check(CLI::ExistingFile)
        ->allow_extra_args(false);
    replay
        ->add_option("--motion", command.motion,
                     "Their motion, in the statements that `events --help` explains")
        ->check(CLI::ExistingFile);
    replay->add_option("-o,--output", command.output, "The page: .html")->required();
    replay->add_flag("--quiet", command.quiet, "Say nothing but what is wrong");
    replay->footer(kNotes);
    return replay;
}

std::vector<std::string> ReplayStructures() {
    std::vector<std::string> names = {"lazy-compass", "lazy-dudley", "free-direction"};
    for (size_t i = 0; i < bmr_kds_count(); ++i)
        if (std::find(names.begin(), names.end(), bmr_kds_at(i)->name) == names.end())
            names.emplace_back(bmr_kds_at(i)->name);
    return names;
}

int Execute(const ReplayCommand &command, const Workers &workers) {
    if (!command.polygons.empty() || !command.motion.empty())
        return ReplayPair(command);
    if (!command.recording.empty()) {
        OutputFile file(command.output);
        return ReplayRecording(command, &file);
    }
    if (command.scene.empty())
        throw UsageError("a scene is wanted, or --recording FILE, or --polygon A --polygon B --motion M");
    const std::string &structure = command.worker.structure;
    if (!structure.empty() && structure != "lazy-compass" && structure != "lazy-dudley" &&
        structure != "free-direction")
        throw UsageError("--structure: " + structure +
                         " is for --polygon and --motion; of a scene it is lazy-compass, "
                         "lazy-dudley or free-direction");
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
