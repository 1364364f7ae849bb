// SPDX-License-Identifier: MIT
//
// boomerang-testbed: runs scenes on stock Box2D and on Box2D with the plugin, in processes of their own, and
// compares them. This file is its command line; commands.cpp does what it says.
#include <iostream>

#include <CLI/CLI.hpp>

#include "command_line/usage.h"
#include "commands.h"

namespace testbed {
namespace {

constexpr char kExitCodes[] =
    "Exit codes: 0 done, nothing differs; 1 a difference was found; 2 the request makes no "
    "sense; 3 a worker failed, or the output could not be "
    "written.";

struct CommandLine {
    std::string directory;
    RunCommand run;
    CompareCommand compare;
    RenderCommand render;
    FiguresCommand figures;
    EventsCommand events;
    WorldCommand world;
    bool noTime = false;
};

void AddPluginOptions(CLI::App &app, WorkerOptions &worker,
                      const std::vector<std::string> &structures = {"lazy-compass", "lazy-dudley",
                                                                    "free-direction", "two-lines"}) {
    app.add_option("--structure", worker.structure,
                   "The structure of the paper that holds each pair of bodies (default: a line a contact, as "
                   "games have it)")
        ->check(CLI::IsMember(structures));
}

/// A whole number of a size that nobody means to reach; CLI11's own validators speak of limits with 300
/// digits.
CLI::Range AtLeast(int least) {
    return CLI::Range(least, 100000000);
}

void AddSceneOptions(CLI::App &app, WorkerOptions &worker) {
    app.add_option("--size", worker.size, "How much of everything there is (default: the scene's own)")
        ->check(AtLeast(1));
    app.add_option("--seed", worker.seed, "Seed of the scene's random numbers (default: the scene's own)")
        ->check(command_line::CheckSeed);
}

void AddPluginSwitch(CLI::App &app, bool &plugin) {
    app.add_option_function<std::string>(
           "--plugin", [&plugin](const std::string &value) { plugin = value == "on"; },
           "With the plugin, or stock Box2D (default: on)")
        ->check(CLI::IsMember({"on", "off"}));
}

CLI::App *AddRun(CLI::App &app, CommandLine &line) {
    CLI::App *run = app.add_subcommand("run", "Run one scene on one side");
    run->add_option("scene", line.run.scene, "A name that `list` shows")->required();
    run->add_option("--steps", line.run.steps, "Steps to simulate (default: the scene's own)")
        ->check(AtLeast(1));
    AddPluginSwitch(*run, line.run.plugin);
    AddPluginOptions(*run, line.run.worker);
    CLI::Option *hash = run->add_flag("--hash", line.run.hash, "Print the hashes of every step");
    run->add_flag("--time", line.run.time, "Time the steps instead of counting calls")->excludes(hash);
    AddSceneOptions(*run, line.run.worker);
    return run;
}

CLI::App *AddCompare(CLI::App &app, CommandLine &line) {
    CompareCommand &command = line.compare;
    CLI::App *compare = app.add_subcommand(
        "compare", "Compare stock Box2D with the plugin: bit by bit, call by call, and by the clock");
    compare->add_option("scenes", command.scenes, "Names that `list` shows (default: all)");
    compare->add_option("--steps", command.options.steps, "Steps of each scene (default: the scene's own)")
        ->check(AtLeast(1));
    CLI::Option *repeat =
        compare->add_option("--repeat", command.options.repeat, "Timed runs of each side, interleaved")
            ->check(CLI::Range(1, 1000))
            ->capture_default_str();
    compare->add_flag("--no-time", line.noTime, "Leave the timed runs out")->excludes(repeat);
    CLI::Option *details = compare->add_flag(
        "--details", command.details,
        "All tables: calls of Box2D, budgets, events and times, and what their columns mean");
    compare->add_flag("--quiet", command.quiet, "Only differences and the verdict")->excludes(details);
    AddPluginOptions(*compare, command.options.worker);
    AddSceneOptions(*compare, command.options.worker);
    compare
        ->add_option("--perturb", command.options.perturb,
                     "Control: after this step (the first is 0) nudge one velocity by one bit on the "
                     "plugin's side; the "
                     "difference must be found")
        ->check(AtLeast(0));
    return compare;
}

CLI::App *AddFigures(CLI::App &app, CommandLine &line) {
    CLI::App *figures = app.add_subcommand(
        "figures", "Draw the figures of the paper, and those that explain it, from the real structures");
    figures->add_option("names", line.figures.names, "Figures that --list shows (default: all)");
    figures->add_option("-o,--output", line.figures.directory, "The directory to write into; made if missing")
        ->capture_default_str();
    figures->add_option("--format", line.figures.format, "svg, png or both")
        ->check(CLI::IsMember({"svg", "png", "both"}))
        ->capture_default_str();
    figures->add_flag("--list", line.figures.list, "Show their names and draw nothing");
    return figures;
}

int Answer(int argc, char **argv) {
    CLI::App app("Scenes on stock Box2D and on Box2D with the Boomerang plugin, compared.",
                 "boomerang-testbed");
    CommandLine line;
    app.require_subcommand(1);
    app.set_version_flag("--version", "boomerang-testbed " BOOMERANG_VERSION);
    app.add_option("--workers", line.directory,
                   "Directory of boomerang-scene and boomerang-scene-plugin (default: this program's own)")
        ->check(CLI::ExistingDirectory);
    const CLI::App *list = app.add_subcommand("list", "Show the scenes");
    const CLI::App *run = AddRun(app, line);
    AddCompare(app, line);
    CLI::App *render = AddRender(app, line.render);
    AddPluginSwitch(*render, line.render.plugin);
    AddPluginOptions(*render, line.render.worker, RenderStructures());
    AddSceneOptions(*render, line.render.worker);
    const CLI::App *figures = AddFigures(app, line);
    const CLI::App *events = AddEvents(app, line.events);
    const CLI::App *world = AddWorld(app, line.world);
    for (CLI::App *subcommand : app.get_subcommands({})) {
        const std::string own = subcommand->get_footer();
        subcommand->footer(own.empty() ? kExitCodes : own + "\n\n" + kExitCodes);
        subcommand->fallthrough(); // so that --workers may stand behind the command as well
    }

    app.footer(kExitCodes); // not before: commands would inherit it, and have it twice

    const std::string unknown = command_line::ExplainCommand(app, argc, argv);
    if (!unknown.empty())
        throw UsageError(unknown);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError &error) {
        if (error.get_exit_code() == 0)
            return app.exit(error); // help, or the version
        throw UsageError(command_line::ExplainUsage(app, error, argc, argv));
    }
    line.compare.options.time = !line.noTime;

    if (app.got_subcommand(figures))
        return Execute(line.figures);
    if (app.got_subcommand(events))
        return Execute(line.events, line.directory);
    if (app.got_subcommand(world))
        return Execute(line.world);
    if (app.got_subcommand(render))
        return Execute(line.render, line.directory);
    const Workers workers(line.directory);
    if (app.got_subcommand(list))
        return List(workers);
    return app.got_subcommand(run) ? Execute(line.run, workers) : Execute(line.compare, workers);
}

} // namespace
} // namespace testbed

int main(int argc, char **argv) {
    try {
        const int status = testbed::Answer(argc, argv);
        // What nobody could read was not done.
        if (!std::cout.flush())
            throw std::runtime_error("the output could not be written");
        return status;
    } catch (const testbed::UsageError &error) {
        std::cerr << "boomerang-testbed: " << error.what() << '\n';
        return testbed::kExitUsage;
    } catch (const std::exception &error) {
        std::cout.flush();
        std::cerr << "boomerang-testbed: " << error.what() << '\n';
        return testbed::kExitWorker;
    }
}
