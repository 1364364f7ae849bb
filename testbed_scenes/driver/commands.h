// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_COMMANDS_H
#define BOOMERANG_TESTBED_COMMANDS_H

#include <optional>
#include <string>
#include <vector>

#include "compare.h"
#include "workers.h"

namespace testbed {

/// What the program returns, as its --help says.
enum ExitCode { kExitOk = 0, kExitDifferent = 1, kExitUsage = 2, kExitWorker = 3 };

/// A request that makes no sense: reported on stderr, exit code 2.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

struct ListCommand {
    bool json = false;
};

struct RunCommand {
    std::string scene;
    std::optional<int64_t> steps;
    bool plugin = true;
    bool hash = false;
    bool time = false;
    bool json = false;
    std::string trace;
    WorkerOptions worker;
};

struct CompareCommand {
    std::vector<std::string> scenes;
    CompareOptions options;
    std::string json, csv, markdown;
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
int Execute(const ListCommand &command, const Workers &workers);
int Execute(const RunCommand &command, const Workers &workers);
int Execute(const CompareCommand &command, const Workers &workers);
int Execute(const FiguresCommand &command);

/// The scene of that name; if there is none, a UsageError that names the nearest.
const SceneInfo &FindScene(const std::vector<SceneInfo> &scenes, const std::string &name);
/// The scenes of these names, in this order; all where there are none.
std::vector<SceneInfo> SelectScenes(const std::vector<SceneInfo> &all, const std::vector<std::string> &names);

} // namespace testbed

#endif
