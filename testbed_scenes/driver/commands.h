// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_COMMANDS_H
#define BOOMERANG_TESTBED_COMMANDS_H

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compare.h"
#include "pictures.h"
#include "workers.h"
#include "worlds/world.h"

namespace CLI {
class App;
}

namespace testbed {

/// What the program returns, as its --help says.
enum ExitCode { kExitOk = 0, kExitDifferent = 1, kExitUsage = 2, kExitWorker = 3 };

/// A request that makes no sense: reported on stderr, exit code 2.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Throws a UsageError: there is no such thing of that name, and which one is nearest.
[[noreturn]] void FailUnknown(const std::string &what, const std::string &name,
                              const std::vector<std::string> &names,
                              const std::string &where = "--list shows all");

struct RunCommand {
    std::string scene;
    std::optional<int64_t> steps;
    bool plugin = true;
    bool hash = false;
    bool time = false;
    WorkerOptions worker;
};

struct CompareCommand {
    std::vector<std::string> scenes;
    CompareOptions options;
    bool details = false;
    bool quiet = false;
};

struct FiguresCommand {
    std::vector<std::string> names; ///< none: all
    std::string directory = ".";
    std::string format = "svg";
    bool list = false;
};

// Each does its job and returns the exit code; errors are thrown (UsageError, WorkerError).
/// Shows the scenes.
int List(const Workers &workers);
int Execute(const RunCommand &command, const Workers &workers);
int Execute(const CompareCommand &command, const Workers &workers);
int Execute(const FiguresCommand &command);

/// The scene of that name; if there is none, a UsageError that names the nearest.
const SceneInfo &FindScene(const std::vector<SceneInfo> &scenes, const std::string &name);

struct RenderCommand {
    std::string scene;
    std::vector<std::string>
        polygons;        ///< or files of two polygons of one's own, A's and B's (one: both alike),
    std::string motion;  ///< and of their motion,
    int64_t steps = 300; ///< which takes so many steps
    bool plugin = true;
    bool quiet = false;
    PictureRequest pictures;
    WorkerOptions worker;
};

/// The options that are render's own; the scene's and the plugin's are added as for other commands.
CLI::App *AddRender(CLI::App &app, RenderCommand &command);

/// What --structure takes: the plugin's structures, and for two polygons of one's own those of the paper.
std::vector<std::string> RenderStructures();

/// Returns the exit code; errors are thrown (UsageError, WorkerError, std::runtime_error). Only scenes need
/// workers.
int Execute(const RenderCommand &command, const std::string &workersDirectory);

/// `boomerang-testbed world`: runs a kinetic world of many polygons and tells what it cost.
struct WorldCommand {
    std::string scene = "gas";
    // What is not told is the scene's own.
    std::optional<size_t> bodies;
    std::optional<std::string> shape, vertices, boundary, answer, zeno, structure;
    std::optional<double> sizes, density, speed, seconds, zenoSpeed;
    uint64_t seed = 1;
    bool allPairs = false, check = false, audit = false, quiet = false, list = false;
    std::string growth;      ///< N1,N2,..
    PictureRequest pictures; ///< without an output: none
    double rate = 30.0;      ///< steps for each unit of time
};

/// Adds the subcommand with its options, which write into `command`.
CLI::App *AddWorld(CLI::App &app, WorldCommand &command);
/// What the command asks for. Throws UsageError.
WorldChoice ChoiceFor(const WorldCommand &command);
/// Returns the exit code: 1 if a check failed.
int Execute(const WorldCommand &command);

/// The same density with each of these numbers of bodies, as a table: what grows, and what does not.
std::vector<WorldFigures> MeasureGrowth(const WorldCommand &command);

/// `boomerang-testbed events`: counts the events of every structure along every motion.
struct EventsCommand {
    std::vector<std::string> motions;    ///< none: all
    std::vector<std::string> structures; ///< names or groups; none: "default"
    size_t n = 64;
    std::string shape = "ellipse:disc";
    std::string ratios = "8:2048";
    unsigned seeds = 3;
    std::vector<std::string> polygons;
    std::string motion;
    std::string csv;
    bool audit = false, noOptimum = false, quiet = false, list = false, box2d = false;
};

/// Adds the subcommand with its options, which write into `command`.
CLI::App *AddEvents(CLI::App &app, EventsCommand &command);

int Execute(const EventsCommand &command, const std::string &workersDirectory);

} // namespace testbed

#endif
