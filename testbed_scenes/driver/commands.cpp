// SPDX-License-Identifier: MIT
#include "commands.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <sstream>

#include <unistd.h>

#include "command_line/nearest.h"
#include "compare.h"
#include "progress.h"
#include "table.h"
#include "theory/figure.h"

namespace testbed {
namespace {

int CompareExitCode(const std::vector<SceneResult> &results) {
    int code = kExitOk;
    for (const SceneResult &result : results) {
        // A failed worker outweighs a difference: without it nothing is known of the scene.
        if (result.verdict == Verdict::Failed)
            return kExitWorker;
        if (result.verdict == Verdict::Different)
            code = kExitDifferent;
    }
    return code;
}

} // namespace

void FailUnknown(const std::string &what, const std::string &name, const std::vector<std::string> &names,
                 const std::string &where) {
    throw UsageError("there is no " + what + " \"" + name + "\"" + command_line::NearestClause(name, names) +
                     " (" + where + ")");
}

const SceneInfo &FindScene(const std::vector<SceneInfo> &scenes, const std::string &name) {
    std::vector<std::string> names;
    for (const SceneInfo &scene : scenes) {
        if (scene.name == name)
            return scene;
        names.push_back(scene.name);
    }
    FailUnknown("scene", name, names, "boomerang-testbed list shows all");
}

int List(const Workers &workers) {
    const std::vector<SceneInfo> scenes = workers.List();
    const bool colour = WantsColour(STDOUT_FILENO);
    size_t width = 0;
    for (const SceneInfo &scene : scenes)
        width = std::max(width, scene.name.size());
    std::string group;
    for (const SceneInfo &scene : scenes) {
        if (scene.group != group) {
            std::cout << (group.empty() ? "" : "\n") << Styled(scene.group, Style::Strong, colour) << '\n';
            group = scene.group;
        }
        std::cout << "  " << scene.name << std::string(width + 2 - scene.name.size(), ' ')
                  << scene.description << ' '
                  << Styled("(size " + std::to_string(scene.size) + ", " + std::to_string(scene.steps) +
                                " steps)",
                            Style::Faint, colour)
                  << '\n';
    }
    return kExitOk;
}

int Execute(const RunCommand &command, const Workers &workers) {
    const SceneInfo scene = FindScene(workers.List(), command.scene);
    WorkerRequest request;
    request.side = command.plugin ? Side::Plugin : StockFor(scene);
    request.scene = scene.name;
    request.steps = command.steps.value_or(scene.steps);
    request.mode = command.hash ? "hash" : command.time ? "time" : "count";
    Progress progress(1, command.hash);
    progress.Show(scene.name, 0.0);
    const nlohmann::json summary = workers.Summarise(
        request, command.worker, [&progress] { progress.Tick(); },
        [&command](const std::string &line) {
            if (command.hash)
                std::cout << line << '\n';
        });
    progress.Clear();
    std::cout << summary.dump(2) << '\n';
    return kExitOk;
}

namespace {

/// A nudge after the last step would be no control: nothing could show it.
void CheckPerturb(const std::vector<SceneInfo> &scenes, const CompareOptions &options) {
    for (const SceneInfo &scene : scenes) {
        const long steps = options.steps.value_or(scene.steps);
        if (options.perturb && *options.perturb >= steps)
            throw UsageError("--perturb " + std::to_string(*options.perturb) + ": " + scene.name +
                             " has only the steps 0 to " + std::to_string(steps - 1));
    }
}

} // namespace

int Execute(const CompareCommand &command, const Workers &workers) {
    const std::vector<SceneInfo> all = workers.List();
    std::vector<SceneInfo> scenes = command.scenes.empty() ? all : std::vector<SceneInfo>();
    for (const std::string &name : command.scenes)
        scenes.push_back(FindScene(all, name));
    CheckPerturb(scenes, command.options);
    const bool colour = WantsColour(STDOUT_FILENO);
    const int runsPerScene = RunsPerScene(workers, command.options);

    if (!workers.CanCount() && !command.quiet)
        std::cerr << "note: libboomerang-count.so is not built: calls of Box2D stay uncounted\n";
    if (!workers.CanPreload() && !command.quiet)
        std::cerr << "note: libboomerang_box2d.so is not beside the workers: nothing is preloaded\n";
    std::vector<SceneResult> results;
    {
        Progress progress(runsPerScene * static_cast<int>(scenes.size()), command.quiet);
        for (const SceneInfo &scene : scenes) {
            results.push_back(CompareScene(workers, scene, command.options, progress));
            progress.FinishUpTo(runsPerScene * static_cast<int>(results.size()));
            if (results.back().verdict != Verdict::Identical) {
                progress.Clear();
                // At once, not after the other scenes: this is what somebody waits for.
                std::cout << Explain(results.back()) << std::endl;
            }
        }
    }
    const bool hasFigures = std::any_of(results.begin(), results.end(), [](const auto &result) {
        return result.verdict == Verdict::Identical;
    });
    if (!command.quiet)
        PrintQuestions(std::cout, results, colour);
    PrintVerdict(std::cout, results, colour);
    if (!command.quiet && hasFigures)
        PrintTables(std::cout, results, command.options, command.details, colour);
    return CompareExitCode(results);
}

namespace {

const FigureInfo &FindFigure(const std::string &name) {
    const std::vector<FigureInfo> &figures = AllFigures();
    const auto found = std::find_if(figures.begin(), figures.end(),
                                    [&name](const FigureInfo &figure) { return name == figure.name; });
    if (found != figures.end())
        return *found;
    std::vector<std::string> names;
    for (const FigureInfo &figure : figures)
        names.emplace_back(figure.name);
    FailUnknown("figure", name, names);
}

void ListFigures() {
    constexpr size_t kNameWidth = 22, kSectionWidth = 18;
    for (const FigureInfo &figure : AllFigures()) {
        std::string line = figure.name;
        line.resize(std::max(kNameWidth, line.size() + 1), ' ');
        line += figure.section;
        line.resize(std::max(kNameWidth + kSectionWidth, line.size() + 1), ' ');
        std::cout << line << figure.title << '\n';
    }
}

void Draw(const FigureInfo &figure, const std::string &path) {
    Canvas canvas(path, figure.width, figure.height);
    figure.draw(canvas);
    canvas.Write();
    std::cout << path << '\n';
}

} // namespace

int Execute(const FiguresCommand &command) {
    std::vector<const FigureInfo *> wanted;
    for (const std::string &name : command.names)
        wanted.push_back(&FindFigure(name));
    if (command.list) {
        ListFigures();
        return kExitOk;
    }
    if (wanted.empty())
        for (const FigureInfo &figure : AllFigures())
            wanted.push_back(&figure);
    std::error_code error;
    std::filesystem::create_directories(command.directory, error);
    if (error)
        throw std::runtime_error("cannot make the directory " + command.directory + ": " + error.message());
    for (const FigureInfo *figure : wanted)
        for (const char *format : {"svg", "png"})
            if (command.format == format || command.format == "both")
                Draw(*figure,
                     (std::filesystem::path(command.directory) / figure->name).string() + "." + format);
    return kExitOk;
}

} // namespace testbed
