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
#include "protocol.h"

namespace testbed {

/// Stock Box2D, or Box2D with the plugin: never in one process. Plugin: the program that was linked
/// with it. Preloaded: stock's program, with the plugin in
/// LD_PRELOAD. Accelerated: a program with a Box2D inside that boomerang_accelerate was called for, where one
/// was built. Verify: as Plugin, but everything is computed twice. Off: as Plugin, but told to be off, which
/// leaves polygons of any size and nothing else.
enum class Side { Stock, Plugin, Preloaded, Accelerated, Verify, Off };

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
    /// What the worlds' contact listener does: "counts", "reads", "acts" or "records"; empty or "none": there
    /// is none.
    std::string listener;
};

/// One run of a worker.
struct WorkerRequest {
    Side side = Side::Stock;
    std::string scene;
    int64_t steps = 0;
    std::string mode = "hash";
    /// --dump, --perturb, --record, --trace with their values.
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
    /// Runs a worker to its end and returns its summary. Throws WorkerError if it fails or gives none.
    nlohmann::json Summarise(const WorkerRequest &request, const WorkerOptions &options,
                             const std::function<void()> &onTick = nullptr) const;

private:
    std::filesystem::path ProgramOf(Side side) const;
    std::filesystem::path FindLibrary(const char *name) const;
    std::vector<std::string> EnvironmentOf(const WorkerRequest &request, const WorkerOptions &options) const;

    std::filesystem::path m_directory;
    std::filesystem::path m_countLibrary, m_plugin;
};

} // namespace testbed

#endif
