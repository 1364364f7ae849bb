// SPDX-License-Identifier: MIT
#include "commands.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>

#include <unistd.h>

#include "compare.h"
#include "terminal.h"
#include "theory/figure.h"

namespace testbed {

// --- what commands share ---

void FailUnknown(const std::string &what, const std::string &name, const std::vector<std::string> &names,
                 const std::string &where) {
    throw UsageError("there is no " + what + " \"" + name + "\"" + NearestClause(name, names) + " (" + where +
                     ")");
}

size_t IndexOf(const std::string &what, const std::string &name, const std::vector<std::string> &names,
               const std::string &where) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
        FailUnknown(what, name, names, where);
    return static_cast<size_t>(found - names.begin());
}

const SceneInfo &FindScene(const std::vector<SceneInfo> &scenes, const std::string &name) {
    return scenes[IndexOf("scene", name, NamesOf(scenes.size(), [&](size_t i) { return scenes[i].name; }),
                          "boomerang-testbed list shows all")];
}

std::vector<double> NumbersIn(const std::string &text, char separator, double least, double most,
                              const std::string &option, const std::string &what, bool whole) {
    std::vector<double> numbers;
    std::istringstream words(text + separator);
    for (std::string word; std::getline(words, word, separator);) {
        char *end = nullptr;
        const double number = std::strtod(word.c_str(), &end);
        if (word.empty() || *end != '\0' || !(number >= least && number <= most) ||
            (whole && number != std::floor(number)))
            throw UsageError(option + ": \"" + word + "\" is no " + what);
        numbers.push_back(number);
    }
    return numbers;
}

void AddStructureOption(CLI::App &app, WorkerOptions &worker, const std::vector<std::string> &structures) {
    app.add_option("--structure", worker.structure,
                   "The structure of the paper that holds each pair of bodies (default: a line a contact, as "
                   "games have it)")
        ->check(CLI::IsMember(structures));
}

void AddSceneOptions(CLI::App &app, WorkerOptions &worker) {
    app.add_option("--size", worker.size, "How much of everything there is (default: the scene's own)")
        ->check(Whole(1, 1000000));
    app.add_option("--seed", worker.seed, "Seed of the scene's random numbers (default: 1)")
        ->check(Whole(0, UINT64_MAX));
}

namespace {

const std::vector<std::string> kPluginStructures = {"lazy-compass", "lazy-dudley", "free-direction",
                                                    "two-lines"};

// --- list ---

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
        std::cout << "  " << Padded(scene.name, width + 2) << scene.description << ' '
                  << Styled("(size " + std::to_string(scene.size) + ", " + std::to_string(scene.steps) +
                                " steps)",
                            Style::Faint, colour)
                  << '\n';
    }
    return kExitOk;
}

// --- compare ---

struct CompareCommand {
    std::vector<std::string> scenes;
    CompareOptions options;
    bool noTime = false;
    bool details = false;
    bool quiet = false;
};

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

/// A nudge after the last step would be no control: nothing could show it.
void CheckPerturb(const std::vector<SceneInfo> &scenes, const CompareOptions &options) {
    for (const SceneInfo &scene : scenes) {
        const long steps = options.steps.value_or(scene.steps);
        if (options.perturb && *options.perturb >= steps)
            throw UsageError("--perturb " + std::to_string(*options.perturb) + ": " + scene.name +
                             " has only the steps 0 to " + std::to_string(steps - 1));
    }
}

int Execute(CompareCommand &command, const Workers &workers) {
    command.options.time = !command.noTime;
    const std::vector<SceneInfo> all = workers.List();
    std::vector<SceneInfo> scenes = command.scenes.empty() ? all : std::vector<SceneInfo>();
    for (const std::string &name : command.scenes)
        scenes.push_back(FindScene(all, name));
    CheckPerturb(scenes, command.options);
    const bool colour = WantsColour(STDOUT_FILENO);
    const int runsPerScene = RunsPerScene(command.options);

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

// --- figures ---

struct FiguresCommand {
    std::vector<std::string> names; ///< none: all
    std::string directory = ".";
    bool list = false;
};

int Execute(const FiguresCommand &command) {
    const std::vector<FigureInfo> &figures = AllFigures();
    std::vector<FigureInfo> wanted;
    const auto names = NamesOf(figures.size(), [&](size_t i) { return figures[i].name; });
    for (const std::string &name : command.names)
        wanted.push_back(figures[IndexOf("figure", name, names)]);
    if (command.list) {
        for (const FigureInfo &figure : figures)
            std::cout << Padded(Padded(figure.name, 22) + figure.section, 40) << figure.title << '\n';
        return kExitOk;
    }
    std::error_code error;
    std::filesystem::create_directories(command.directory, error);
    if (error)
        throw std::runtime_error("cannot make the directory " + command.directory + ": " + error.message());
    for (const FigureInfo &figure : wanted.empty() ? figures : wanted) {
        const auto path = std::filesystem::path(command.directory) / (std::string(figure.name) + ".svg");
        Canvas canvas(path, figure.width, figure.height);
        figure.draw(canvas);
        canvas.Write();
        std::cout << path.string() << '\n';
    }
    return kExitOk;
}

} // namespace

void AddList(CLI::App &app, Program &program) {
    app.add_subcommand("list", "Show the scenes")->callback([&program] {
        program.status = List(Workers(program.directory));
    });
}

void AddCompare(CLI::App &app, Program &program) {
    const auto command = std::make_shared<CompareCommand>();
    CompareOptions &options = command->options;
    CLI::App *compare = app.add_subcommand(
        "compare", "Compare stock Box2D with the plugin: bit by bit, call by call, and by the clock");
    compare->add_option("scenes", command->scenes, "Names that `list` shows (default: all)");
    compare->add_option("--steps", options.steps, "Steps of each scene (default: the scene's own)")
        ->check(Whole(1));
    CLI::Option *repeat =
        compare->add_option("--repeat", options.repeat, "Timed runs of each side, interleaved")
            ->check(Whole(1, 1000))
            ->capture_default_str();
    compare->add_flag("--no-time", command->noTime, "Leave the timed runs out")->excludes(repeat);
    CLI::Option *details = compare->add_flag(
        "--details", command->details,
        "All tables: calls of Box2D, budgets, events and times, and what their columns mean");
    compare->add_flag("--quiet", command->quiet, "Only differences and the verdict")->excludes(details);
    AddStructureOption(*compare, options.worker, kPluginStructures);
    AddSceneOptions(*compare, options.worker);
    compare
        ->add_option("--perturb", options.perturb,
                     "Control: after this step (the first is 0) nudge one velocity by one bit on the "
                     "plugin's side; the "
                     "difference must be found")
        ->check(Whole(0));
    compare->callback(
        [command, &program] { program.status = Execute(*command, Workers(program.directory)); });
}

void AddFigures(CLI::App &app, Program &program) {
    const auto command = std::make_shared<FiguresCommand>();
    CLI::App *figures = app.add_subcommand(
        "figures", "Draw the figures of the paper, and those that explain it, from the real structures");
    figures->add_option("names", command->names, "Figures that --list shows (default: all)");
    figures->add_option("-o,--output", command->directory, "The directory to write into; made if missing")
        ->capture_default_str();
    figures->add_flag("--list", command->list, "Show their names and draw nothing");
    figures->callback([command, &program] { program.status = Execute(*command); });
}

} // namespace testbed
