// SPDX-License-Identifier: MIT
//
// boomerang-scene: runs one scene on whatever Box2D it is linked with. boomerang-testbed starts it twice,
// once stock and once with the plugin, and compares what the two print: stock must be stock, so they are
// never one process. This file is its command line.
#include "worker/options.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "command_line/usage.h"

namespace testbed {
namespace {

enum ExitCode : int { exitOk = 0, exitUsage = 2, exitInternal = 3 };

const std::map<std::string, Mode> modes = {
    {"hash", Mode::Hash}, {"count", Mode::Count}, {"time", Mode::Time}};

const std::map<std::string, BodyKind> kinds = {
    {"one", BodyKind::One}, {"many", BodyKind::Many}, {"circle", BodyKind::Circle}};

const std::map<std::string, Listening> listenings = {{"none", Listening::None},
                                                     {"counts", Listening::Counts},
                                                     {"reads", Listening::Reads},
                                                     {"acts", Listening::Acts}};

std::string ListScenes() {
    std::string text = "Scenes (default size, default steps):\n";
    for (const SceneInfo &scene : AllScenes()) {
        char line[200];
        std::snprintf(line, sizeof line, "  %-16s %4d %5d  %s\n", scene.name, scene.size, scene.steps,
                      scene.description);
        text += line;
    }
    return text + "\nExit codes: 0 done; 2 wrong usage; 3 internal error.";
}

void CheckScene(const Options &options) {
    if (options.listJson || !options.course.empty())
        return;
    if (options.scene.empty())
        throw CLI::ValidationError("a SCENE, --course or --list-json is wanted");
    const SceneInfo *scene = FindScene(options.scene);
    if (scene == nullptr) {
        std::vector<std::string> names;
        for (const SceneInfo &known : AllScenes())
            names.emplace_back(known.name);
        throw CLI::ValidationError("there is no scene \"" + options.scene + "\"" +
                                   command_line::NearestClause(options.scene, names));
    }
    if ((options.vertices || options.bodies) && scene->polygons.vertices == 0)
        throw CLI::ValidationError("the polygons of " + options.scene +
                                   " are what they are: --vertices and --bodies are for coins and any-...");
}

/// Fills `options`, or says why not (or prints the help) and returns the exit code.
std::optional<int> ParseOptions(int argc, char **argv, Options &options) {
    CLI::App app("Runs one scene of Box2D and prints what happened: a line of hashes for each step, and at "
                 "the end one "
                 "line\n`summary {json}`.",
                 argc > 0 ? std::filesystem::path(argv[0]).filename() : "boomerang-scene");
    app.footer(ListScenes());
    app.add_flag("--list-json", options.listJson, "Print all scenes as JSON and exit");
    CLI::Option *scene = app.add_option("scene", options.scene, "The scene")->option_text("SCENE");
    app.add_option("--course", options.course, "Instead of a scene: two bodies and their poses, from a file")
        ->option_text("FILE")
        ->check(CLI::ExistingFile.description(""))
        ->excludes(scene);
    app.add_option(
           "--mode", options.mode,
           "hash: `step I BODIES CONTACTS EVENTS`, three hashes of the raw bits, after each step\n"
           "count: contacts and calls of Box2D's leaf functions (with libboomerang-count.so preloaded)\n"
           "time: wall time of b2World::Step and Box2D's own profile")
        ->transform(CLI::CheckedTransformer(modes).description(""))
        ->option_text("hash|count|time [hash]");
    app.add_option("--steps", options.steps, "How many steps; each scene has its default")
        ->option_text("N")
        ->check(CLI::Range(0, 100000000).description(""));
    app.add_option("--size", options.size, "How large the scene is; each scene has its default")
        ->option_text("K")
        ->check(CLI::Range(1, 1000000).description(""));
    app.add_option("--seed", options.seed, "Seed of the scene's random numbers [1]")
        ->option_text("S")
        ->check(command_line::CheckSeed);
    app.add_option("--vertices", options.vertices,
                   "Vertices of the polygons; for scenes that have this to choose, each with its default")
        ->option_text("N")
        ->check(CLI::Range(3, 65535).description(""));
    app.add_option(
           "--bodies", options.bodies,
           "What such polygons are: one fixture (needs the plugin), many of at most 8 vertices each, or "
           "(if round) a circle")
        ->transform(CLI::CheckedTransformer(kinds).description(""))
        ->option_text("one|many|circle");
    app.add_option("--dump", options.dump,
                   "Instead of hashes, print after this step (the first is 0) all that is hashed, a line per "
                   "field, and "
                   "stop")
        ->option_text("STEP")
        ->check(CLI::Range(0, 100000000).description(""));
    app.add_option(
           "--listener", options.listening,
           "A contact listener, ahead of the scene's own: it counts its calls; reads manifolds, impulses "
           "and bodies,\ntoo; or disables contacts, changes friction and pushes bodies, too")
        ->transform(CLI::CheckedTransformer(listenings).description(""))
        ->option_text("none|counts|reads|acts [none]");
    bool boxes = false;
    std::vector<int> range;
    CLI::Option *frames = app.add_option("--frames", range,
                                         "Instead of hashes, print the world after each of these steps "
                                         "(testbed_scenes/picture/frame.h), and stop after the last")
                              ->option_text("FIRST:LAST:EVERY")
                              ->delimiter(':')
                              ->expected(3)
                              ->check(CLI::Range(0, 100000000).description(""));
    app.add_flag("--boxes", boxes, "With the boxes of the broad phase")->needs(frames);
    app.add_option("--perturb", options.perturb,
                   "After this step, nudge the velocity of one body by one ulp: the control for comparisons, "
                   "which must "
                   "notice it at that very step")
        ->option_text("STEP")
        ->check(CLI::Range(0, 100000000).description(""));
    if (PluginName() != std::string("stock"))
        app.add_option("--structure", options.structure,
                       "The structure of the paper that holds each pair of bodies (bmr::Options::pairsBy)")
            ->envname("BOOMERANG_PAIRS_BY")
            ->option_text("lazy-compass|lazy-dudley|free-direction|two-lines")
            ->check(CLI::IsMember({"lazy-compass", "lazy-dudley", "free-direction", "two-lines"})
                        .description(""));
    try {
        app.parse(argc, argv);
        CheckScene(options);
        if (range.size() == 3)
            options.frames = {range[0], range[1], std::max(range[2], 1), boxes};
    } catch (const CLI::ParseError &error) {
        if (error.get_exit_code() == 0)
            return app.exit(error); // help
        std::fprintf(stderr, "%s: %s\n", app.get_name().c_str(),
                     command_line::ExplainUsage(app, error, argc, argv).c_str());
        return exitUsage;
    }
    return std::nullopt;
}

void PrintList() {
    nlohmann::json list = nlohmann::json::array();
    for (const SceneInfo &scene : AllScenes())
        list.push_back({{"name", scene.name},
                        {"description", scene.description},
                        {"group", scene.group},
                        {"size", scene.size},
                        {"seed", scene.seed},
                        {"steps", scene.steps},
                        {"vertices", scene.polygons.vertices},
                        {"bodies", NameOf(scene.polygons.bodies)}});
    std::puts(list.dump(2).c_str());
}

int Run(int argc, char **argv) {
    Options options;
    if (const std::optional<int> code = ParseOptions(argc, argv, options))
        return *code;
    if (options.listJson)
        PrintList();
    else if (!options.course.empty())
        RunScene(CourseScene(options.course), options);
    else
        RunScene(*FindScene(options.scene), options);
    return exitOk;
}

} // namespace

const char *NameOf(Mode mode) {
    for (const auto &[name, value] : modes)
        if (value == mode)
            return name.c_str();
    return "";
}

PolygonChoice PolygonsOf(const SceneInfo &scene, const Options &options) {
    return {options.bodies.value_or(scene.polygons.bodies),
            options.vertices.value_or(scene.polygons.vertices)};
}

} // namespace testbed

int main(int argc, char **argv) {
    try {
        return testbed::Run(argc, argv);
    } catch (const std::exception &error) {
        std::fflush(stdout);
        std::fprintf(stderr, "%s: %s\n", std::filesystem::path(argv[0]).filename().c_str(), error.what());
        return testbed::exitInternal;
    }
}
