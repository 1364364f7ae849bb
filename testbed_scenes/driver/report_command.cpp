// SPDX-License-Identifier: MIT
#include "report_command.h"

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include <CLI/CLI.hpp>
#include <unistd.h>

#include "commands.h"
#include "events_command.h"
#include "output_file.h"
#include "report.h"
#include "report/page.h"
#include "theory/event_tables.h"

namespace testbed {
namespace {

/// A page that is wanted now, not tonight: so many steps of a scene at most, unless told.
constexpr int64_t kModestSteps = 100;
/// The scene that shows how cost grows, for its bodies keep to one density; its sizes, and steps of each.
constexpr char kGrowingScene[] = "coins-gas";
constexpr int64_t kGrowingSizes[] = {30, 60, 120, 240, 480};
constexpr int64_t kGrowingSteps = 40;
/// Motions of convex and of winding translations, and of rotations.
const std::vector<std::string> kMotions = {"line", "orbit", "spin", "tumble"};
/// Vertices at which the events are counted over all ratios, and at one ratio for their growth with n.
constexpr size_t kVertices = 64;
constexpr size_t kOtherVertices[] = {16, 256, 1024};
constexpr char kRatios[] = "8:2048", kOneRatio[] = "128";
constexpr unsigned kSeeds = 2;
/// What the progress bar takes the counting of events for, in runs of a worker.
constexpr int kEventUnits = 12;

bool Wants(const ReportCommand &command, const char *part) {
    return command.parts.empty() ||
           std::find(command.parts.begin(), command.parts.end(), part) != command.parts.end();
}

/// Everything that is measured now, one thing after the other, under one progress bar.
class Measurement {
public:
    Measurement(const ReportCommand &command, const Workers &workers, Numbers &numbers)
        : m_workers(workers), m_numbers(numbers),
          m_scenes(Wants(command, "scenes") ? SelectScenes(workers.List(), command.scenes)
                                            : std::vector<SceneInfo>()),
          m_bodies(Wants(command, "bodies")), m_events(Wants(command, "events")), m_steps(command.steps) {
        m_options.repeat = command.repeat;
        const size_t compared = m_scenes.size() + (m_bodies ? std::size(kGrowingSizes) : 0);
        m_progress.emplace(RunsPerScene(m_workers, m_options) * static_cast<int>(compared) +
                               (m_events ? kEventUnits * static_cast<int>(1 + std::size(kOtherVertices)) : 0),
                           command.quiet);
    }

    void Run() {
        std::vector<SceneResult> results;
        for (const SceneInfo &scene : m_scenes) {
            m_options.steps = m_steps.value_or(static_cast<int>(std::min(scene.steps, kModestSteps)));
            results.push_back(Compare(scene));
        }
        if (!results.empty())
            Add(results, "measured now, " + std::to_string(m_options.repeat) + " timed runs of each side");
        if (m_bodies)
            Bodies();
        if (m_events) {
            Events(kVertices, kRatios);
            for (const size_t n : kOtherVertices)
                Events(n, kOneRatio);
        }
        m_progress->Clear();
    }

private:
    SceneResult Compare(const SceneInfo &scene) {
        SceneResult result = CompareScene(m_workers, scene, m_options, *m_progress);
        Advance(RunsPerScene(m_workers, m_options));
        return result;
    }

    void Add(const std::vector<SceneResult> &results, const std::string &source) {
        m_numbers.AddJson(ToJson(results, m_options), source);
    }

    void Bodies() {
        const SceneInfo scene = FindScene(m_workers.List(), kGrowingScene);
        m_options.steps = kGrowingSteps;
        std::vector<SceneResult> results;
        for (const int64_t size : kGrowingSizes) {
            m_options.worker.size = size;
            results.push_back(Compare(scene));
            results.back().scene.size = size;
        }
        m_options.worker.size.reset();
        Add(results,
            "measured now, " + std::to_string(std::size(kGrowingSizes)) + " sizes of " + kGrowingScene);
    }

    void Events(size_t n, const std::string &ratios) {
        EventsCommand command;
        command.motions = kMotions;
        command.n = n;
        command.ratios = ratios;
        command.seeds = kSeeds;
        std::vector<testbed::Run> runs =
            Perform(ExperimentFor(command), [this](const std::string &what, size_t done, size_t total) {
                m_progress->Show(what, 0.0);
                m_progress->FinishUpTo(m_done + static_cast<int>(static_cast<size_t>(kEventUnits) * done /
                                                                 std::max<size_t>(total, 1)));
            });
        Advance(kEventUnits);
        m_numbers.AddRuns(std::move(runs), "measured now, n = " + std::to_string(n));
    }

    void Advance(int units) {
        m_done += units;
        m_progress->FinishUpTo(m_done);
    }

    const Workers &m_workers;
    Numbers &m_numbers;
    std::vector<SceneInfo> m_scenes;
    bool m_bodies, m_events;
    std::optional<int> m_steps;
    CompareOptions m_options;
    std::optional<Progress> m_progress;
    int m_done = 0;
};

/// Today, or the day that a reproducible build says it is
/// (https://reproducible-builds.org/specs/source-date-epoch).
std::string Today() {
    const char *epoch = std::getenv("SOURCE_DATE_EPOCH");
    const std::time_t now = epoch != nullptr && *epoch != '\0'
                                ? static_cast<std::time_t>(std::strtoll(epoch, nullptr, 10))
                                : std::time(nullptr);
    std::tm parts = {};
    gmtime_r(&now, &parts);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%d", &parts);
    return text;
}

void WriteFigures(const Numbers &numbers, const std::string &directory) {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error)
        throw std::runtime_error("cannot make the directory " + directory + ": " + error.message());
    for (const Picture &picture : AllPictures(numbers)) {
        const std::string path = (std::filesystem::path(directory) / (picture.name + ".svg")).string();
        OutputFile file(path);
        WriteSvg(file.Stream(), picture);
        file.Close();
        std::cout << path << '\n';
    }
}

int ExitCodeOf(const Numbers &numbers) {
    int code = kExitOk;
    for (const auto *scenes : {&numbers.scenes, &numbers.others})
        for (const SceneNumbers &scene : *scenes) {
            if (scene.verdict == "failed")
                return kExitWorker;
            if (scene.verdict == "different")
                code = kExitDifferent;
        }
    return code;
}

} // namespace

CLI::App *AddReport(CLI::App &app, ReportCommand &command) {
    CLI::App *report = app.add_subcommand(
        "report",
        "Show the comparison of all scenes, the events and the costs as one page of tables and plots");
    CLI::Option *scenes = report->add_option("scenes", command.scenes,
                                             "Scenes to measure, as `list` shows them (default: all)");
    CLI::Option *json =
        report
            ->add_option("--json", command.json,
                         "Show what `compare --json` or `events --json` wrote, and measure nothing")
            ->check(CLI::ExistingFile)
            ->allow_extra_args(false);
    report
        ->add_option("--costs", command.costs,
                     "Show costs too: a line of headings, then series,x,y, as tests/bench/measure_costs.sh "
                     "writes")
        ->check(CLI::ExistingFile)
        ->allow_extra_args(false);
    report->add_option("-o,--output", command.output, "The page; - for standard output");
    report->add_option("--figures", command.figures,
                       "Write each plot into this directory too, as SVG; made if missing");
    CLI::Option *parts = report
                             ->add_option("--parts", command.parts,
                                          "What to measure: scenes, events, bodies (default: all of them)")
                             ->delimiter(',')
                             ->check(CLI::IsMember({"scenes", "events", "bodies"}));
    CLI::Option *steps = report
                             ->add_option("--steps", command.steps,
                                          "Steps of each scene (default: the scene's own, but at most " +
                                              std::to_string(kModestSteps) + ")")
                             ->check(CLI::Range(1, 100000000));
    CLI::Option *repeat =
        report->add_option("--repeat", command.repeat, "Timed runs of each side, interleaved")
            ->check(CLI::Range(1, 1000))
            ->capture_default_str();
    for (CLI::Option *option : {scenes, parts, steps, repeat})
        json->excludes(option);
    report->add_option("--title", command.title, "The page's title")->capture_default_str();
    report->add_flag("--quiet", command.quiet, "No progress bar");
    return report;
}

int Execute(const ReportCommand &command, const std::string &workersDirectory) {
    const bool page = !command.output.empty() || command.figures.empty();
    const bool piped = command.output == "-" || command.output.empty();
    if (page && command.output.empty() && isatty(STDOUT_FILENO) != 0)
        throw UsageError("a page is nothing for a terminal: name a file with -o, or - for standard output");
    if (page && piped && !command.figures.empty())
        throw UsageError("the names of the figures take standard output: give -o a file");
    OutputFile file(page && !piped ? command.output : "");
    Numbers numbers;
    try {
        for (const std::string &path : command.json)
            numbers.AddJsonFile(path);
        for (const std::string &path : command.costs)
            numbers.AddCosts(path);
    } catch (const NumbersError &error) {
        throw UsageError(error.what());
    }
    // Costs alone are a report too, if nobody asks for more.
    if (command.json.empty() &&
        (command.costs.empty() || !command.parts.empty() || !command.scenes.empty())) {
        const Workers workers(workersDirectory);
        Measurement(command, workers, numbers).Run();
    }
    if (!command.figures.empty())
        WriteFigures(numbers, command.figures);
    if (page) {
        std::ostream &out = piped ? std::cout : file.Stream();
        WritePage(out, numbers,
                  {command.title, "Written by boomerang-testbed " BOOMERANG_VERSION ", " + Today() + "."});
        if (!piped) {
            file.Close();
            std::cout << command.output << '\n';
        }
    }
    return ExitCodeOf(numbers);
}

} // namespace testbed
