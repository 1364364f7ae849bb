// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_COMMANDS_H
#define BOOMERANG_TESTBED_COMMANDS_H

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "workers.h"

namespace testbed {

/// What the program returns, as its --help says.
enum ExitCode { kExitOk = 0, kExitDifferent = 1, kExitUsage = 2, kExitWorker = 3 };

/// A request that makes no sense: reported on stderr, exit code 2.
class UsageError : public std::invalid_argument {
public:
    using std::invalid_argument::invalid_argument;
};

/// The program, as its commands see it.
struct Program {
    std::string directory; ///< of the workers; empty: this program's own
    int status = kExitOk;  ///< the exit code
};

// Each adds a command with its options. Its callback does the job and sets the exit code; errors are thrown
// (UsageError, WorkerError, std::runtime_error).
void AddList(CLI::App &app, Program &program);
void AddCompare(CLI::App &app, Program &program);
void AddRender(CLI::App &app, Program &program);
void AddFigures(CLI::App &app, Program &program);
void AddEvents(CLI::App &app, Program &program);
void AddWorld(CLI::App &app, Program &program);

// Options of several commands.
void AddStructureOption(CLI::App &app, WorkerOptions &worker, const std::vector<std::string> &structures);
void AddSceneOptions(CLI::App &app, WorkerOptions &worker);

/// "; the nearest is "planks"", or nothing where none is near.
std::string NearestClause(const std::string &word, const std::vector<std::string> &candidates);

/// What is wrong with a command line that CLI11 would not take: which command, which option, what it takes,
/// and the nearest name where one is near. The program's name, which stands ahead of that, is the caller's to
/// print. `app` has a name.
std::string ExplainUsage(const CLI::App &app, const CLI::ParseError &error);

/// Accepts the whole numbers from `least` to `most`. CLI11's own Range says of 3.5 that it is out of range,
/// and without a check CLI11 reads -1 as the largest unsigned number. The default of `most` is larger than
/// any count that a command can use.
CLI::Validator Whole(uint64_t least, uint64_t most = 100000000);

/// Throws a UsageError: there is no such thing of that name, and which one is nearest.
[[noreturn]] void FailUnknown(const std::string &what, const std::string &name,
                              const std::vector<std::string> &names,
                              const std::string &where = "--list shows all");
/// The place of a name among others; if it is not there, FailUnknown.
size_t IndexOf(const std::string &what, const std::string &name, const std::vector<std::string> &names,
               const std::string &where = "--list shows all");

/// The names of so many things.
template <class NameAt> std::vector<std::string> NamesOf(size_t count, NameAt nameAt) {
    std::vector<std::string> names;
    for (size_t i = 0; i < count; ++i)
        names.emplace_back(nameAt(i));
    return names;
}

/// The scene of that name; if there is none, a UsageError that names the nearest.
const SceneInfo &FindScene(const std::vector<SceneInfo> &scenes, const std::string &name);

/// The numbers of a list, whole ones or any, each from `least` to `most`. Throws a UsageError: "--ratios: "x"
/// is no number from 1 to 1e9".
std::vector<double> NumbersIn(const std::string &text, char separator, double least, double most,
                              const std::string &option, const std::string &what, bool whole = false);

} // namespace testbed

#endif
