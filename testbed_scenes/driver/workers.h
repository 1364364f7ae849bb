// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_WORKERS_H
#define BOOMERANG_TESTBED_WORKERS_H

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "process.h"

/// @file
/// The worker programs: how they are started, and how what they print is read.

namespace testbed {

/// A scene as a worker's --list-json describes it.
struct SceneInfo {
    std::string name;
    std::string description;
    std::string group;
    int64_t size = 0;
    uint64_t seed = 0;
    int64_t steps = 0;
    int64_t vertices = 0; ///< of its polygons unless told otherwise; 0: that cannot be chosen
    std::string bodies;   ///< and what they are: one, many or circle
    /// Whether it is made of what stock Box2D does not have.
    bool NeedsPlugin() const { return vertices > 8 && bodies == "one"; }
};

std::vector<SceneInfo> ParseSceneList(const std::string &text);

/// `step <i> <bodies> <contacts> <events>`, where the last three are hashes.
bool IsStepLine(const std::string &line);

bool IsSummaryLine(const std::string &line);
nlohmann::json ParseSummaryLine(const std::string &line);

/// A line of --dump: everything but the last word names the field ("body 12 position.x"), the last word is
/// its value.
struct DumpField {
    std::string name;
    std::string value;
};

DumpField ParseDumpLine(const std::string &line);
/// A value as people read it: "0x1.8p+3" becomes "12 (0x1.8p+3)"; what is no hexadecimal float stays as it
/// is.
std::string Readable(const std::string &value);

/// The number at a JSON pointer ("/plugin/checks"), or nothing where there is none (absent, null, not a
/// number).
std::optional<double> NumberAt(const nlohmann::json &json, const std::string &pointer);

/// Stock Box2D, or Box2D with the plugin: never in one process. Plugin: the program that was linked
/// with it. Preloaded: stock's program, with the plugin in
/// LD_PRELOAD. Accelerated: a program with a Box2D inside that boomerang_accelerate was called for, where one
/// was built. Off: as Plugin, but told to be off, which leaves polygons of any size and nothing else.
enum class Side { Stock, Plugin, Preloaded, Accelerated, Off };

const char *NameOf(Side side);
/// The side that the plugin's is held against: stock, or the plugin told to be off where stock Box2D does not
/// have the scene's polygons.
Side StockFor(const SceneInfo &scene);

/// What a command's options say about every worker it starts.
struct WorkerOptions {
    std::optional<int64_t> size;
    std::optional<uint64_t> seed;
    /// For the plugin's worker alone: the structure of the paper that holds every pair. Empty: as games have
    /// it.
    std::string structure;
};

/// One run of a worker.
struct WorkerRequest {
    Side side = Side::Stock;
    std::string scene;
    int64_t steps = 0;
    std::string mode = "hash";
    /// --dump, --perturb, --frames with their values.
    std::vector<std::string> extra = {};
    std::string course = {}; ///< a file that takes the scene's place
};

/// The worker programs, and how they are started.
class Workers {
public:
    /// The directory that holds them; empty means the one this program lies in. The counting library is
    /// looked up in its neighbour `lib`, then beside the workers, and so is the plugin. Throws WorkerError if
    /// there is no worker.
    explicit Workers(const std::filesystem::path &directory);

    /// The scenes the stock worker knows.
    std::vector<SceneInfo> List() const;
    /// Whether calls can be counted: without the library they stay unknown.
    bool CanCount() const { return !m_countLibrary.empty(); }
    /// Whether there is a plugin to preload.
    bool CanPreload() const { return !m_plugin.empty(); }
    /// Whether there is a worker with an accelerated Box2D inside (BOOMERANG_BOX2D_SOURCE).
    bool CanAccelerate() const;

    std::unique_ptr<Process> Start(const WorkerRequest &request, const WorkerOptions &options,
                                   Process::LineHandler onLine) const;
    /// Runs a worker to its end and returns its summary; the other lines go to `onLine`. Throws WorkerError
    /// if it fails or gives none.
    nlohmann::json Summarise(const WorkerRequest &request, const WorkerOptions &options,
                             const std::function<void()> &onTick = nullptr,
                             const Process::LineHandler &onLine = nullptr) const;

private:
    std::filesystem::path ProgramOf(Side side) const;
    std::filesystem::path FindLibrary(const char *name) const;
    std::vector<std::string> EnvironmentOf(const WorkerRequest &request, const WorkerOptions &options) const;

    std::filesystem::path m_directory;
    std::filesystem::path m_countLibrary, m_plugin;
};

} // namespace testbed

#endif
