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

/// Throws a CLI::ValidationError.
void CheckScene(const Options &options) {
    if (options.listJson || !options.course.empty())
        return;
    const SceneInfo *scene = FindScene(options.scene);
    if (scene == nullptr)
        throw CLI::ValidationError("there is no scene \"" + options.scene + "\"");
    if ((options.vertices || options.bodies) && scene->polygons.vertices == 0)
        throw CLI::ValidationError("the polygons of " + options.scene +
                                   " are what they are: --vertices and --bodies are for coins and any-...");
}

/// Fills `options`, or says why not (or prints the help) and returns the exit code.
std::optional<int> ParseOptions(int argc, char **argv, Options &options) {
    CLI::App app("Runs one scene of Box2D and prints what happened: a line of hashes for each step, and at "
                 "the end one line\n`summary {json}`.");
    const auto fromZero = CLI::Range(0, 100000000);
    app.add_flag("--list-json", options.listJson, "Print all scenes as JSON and exit");
    CLI::Option *scene = app.add_option("scene", options.scene, "The scene");
    app.add_option("--course", options.course, "Instead of a scene: two bodies and their poses, from a file")
        ->check(CLI::ExistingFile)
        ->excludes(scene);
    app.add_option(
           "--mode", options.mode,
           "hash: `step I BODIES CONTACTS EVENTS`, three hashes of the raw bits, after each step\n"
           "count: contacts and calls of Box2D's leaf functions (with libboomerang-count.so preloaded)\n"
           "time: wall time of b2World::Step and Box2D's own profile")
        ->transform(CLI::CheckedTransformer(modes));
    app.add_option("--steps", options.steps, "How many steps")->check(fromZero);
    app.add_option("--size", options.size, "How large the scene is")->check(CLI::Range(1, 1000000));
    app.add_option("--seed", options.seed, "Seed of the scene's random numbers");
    app.add_option("--vertices", options.vertices,
                   "Vertices of the polygons, in scenes that have this to choose")
        ->check(CLI::Range(3, 65535));
    app.add_option(
           "--bodies", options.bodies,
           "What such polygons are: one fixture (needs the plugin), many of at most 8 vertices each, or "
           "(if round) a circle")
        ->transform(CLI::CheckedTransformer(kinds));
    app.add_option("--dump", options.dump,
                   "Instead of hashes, print after this step (the first is 0) all that is hashed, a line per "
                   "field, and stop")
        ->check(fromZero);
    app.add_option(
           "--listener", options.listening,
           "A contact listener, ahead of the scene's own: it counts its calls; reads manifolds, impulses "
           "and bodies, too; or disables contacts, changes friction and pushes bodies, too")
        ->transform(CLI::CheckedTransformer(listenings));
    std::vector<int> range;
    app.add_option("--frames", range,
                   "FIRST:LAST:EVERY: instead of hashes, print the world after each of these steps "
                   "(testbed_scenes/picture/frame.h), and stop after the last")
        ->delimiter(':')
        ->expected(3)
        ->check(fromZero);
    app.add_option("--perturb", options.perturb,
                   "After this step, nudge the velocity of one body by one ulp: the control for comparisons, "
                   "which must notice it at that very step")
        ->check(fromZero);
    if (PluginName() != std::string("stock"))
        app.add_option("--structure", options.structure,
                       "The structure of the paper that holds each pair of bodies (bmr::Options::pairsBy)")
            ->envname("BOOMERANG_PAIRS_BY")
            ->check(CLI::IsMember({"lazy-compass", "lazy-dudley", "free-direction", "two-lines"}));
    try {
        app.parse(argc, argv);
        CheckScene(options);
        if (range.size() == 3)
            options.frames = {range[0], range[1], std::max(range[2], 1)};
    } catch (const CLI::ParseError &error) {
        return app.exit(error) == 0 ? exitOk : exitUsage;
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
