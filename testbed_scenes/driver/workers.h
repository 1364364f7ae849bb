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

/// Stock Box2D, or Box2D with the plugin linked in front of it: two programs, never one.
enum class Side { Stock, Plugin };

const char *NameOf(Side side);

/// What a command's options say about every worker it starts.
struct WorkerOptions {
    std::optional<int64_t> size;
    std::optional<uint64_t> seed;
    /// For the plugin's worker alone; empty means its own default.
    std::string structure;
    std::string prefilter;
};

/// One run of a worker.
struct WorkerRequest {
    Side side = Side::Stock;
    std::string scene;
    int64_t steps = 0;
    std::string mode = "hash";
    /// --dump, --perturb, --outline, --trace with their values.
    std::vector<std::string> extra;
};

/// The worker programs, and how they are started.
class Workers {
public:
    /// The directory that holds them; empty means the one this program lies in. The counting library is
    /// looked up in its neighbour `lib`, then beside the workers. Throws WorkerError if there is no worker.
    explicit Workers(const std::filesystem::path &directory);

    /// The scenes the stock worker knows.
    std::vector<SceneInfo> List() const;
    /// Whether calls can be counted: without the library they stay unknown.
    bool CanCount() const { return !m_countLibrary.empty(); }

    std::unique_ptr<Process> Start(const WorkerRequest &request, const WorkerOptions &options,
                                   Process::LineHandler onLine) const;
    /// Runs a worker to its end and returns its summary. Throws WorkerError if it fails or gives none.
    nlohmann::json Summarise(const WorkerRequest &request, const WorkerOptions &options,
                             const std::function<void()> &onTick = nullptr) const;

private:
    std::filesystem::path ProgramOf(Side side) const;

    std::filesystem::path m_directory;
    std::filesystem::path m_countLibrary;
};

} // namespace testbed

#endif
