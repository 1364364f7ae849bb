// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_WORKERS_H
#define BOOMERANG_TESTBED_WORKERS_H

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

/// @file
/// The worker programs: how they are started, and how what they print is read.

namespace testbed {

/// A worker that did not do its job: not started, crashed, left with an error, or printed nonsense.
class WorkerError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Gets a line that a worker prints.
using LineHandler = std::function<void(const std::string &line)>;

/// A scene as a worker's --list-json describes it.
struct SceneInfo {
    std::string name;
    std::string description;
    std::string group;
    int64_t size = 0;
    int64_t steps = 0;
    int64_t vertices = 0; ///< of its polygons without --vertices; 0: the scene does not take --vertices
    std::string bodies;   ///< and what they are: one, many or circle
    /// Whether it is made of what stock Box2D does not have.
    bool NeedsPlugin() const { return vertices > 8 && bodies == "one"; }
};

/// The number at a JSON pointer ("/plugin/checks"), or nothing where there is none (absent, null, not a
/// number).
std::optional<double> NumberAt(const nlohmann::json &json, const std::string &pointer);

/// Stock Box2D, or Box2D with the plugin: never in one process. Plugin: the program that was linked
/// with it. Preloaded: stock's program, with the plugin in LD_PRELOAD. Off: as Plugin, but switched off,
/// which leaves polygons of any size and nothing else.
enum class Side { Stock, Plugin, Preloaded, Off };

const char *NameOf(Side side);
/// The side that the plugin's is held against: stock, or the plugin switched off where stock Box2D does not
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

    /// Runs a worker to its end and returns its summary; the other lines go to `onLine`. Throws WorkerError
    /// if it fails or gives none, and what `onLine` throws. Several may run at once, on threads.
    nlohmann::json Run(const WorkerRequest &request, const WorkerOptions &options,
                       const LineHandler &onLine = nullptr) const;

private:
    std::filesystem::path ProgramOf(Side side) const;
    std::filesystem::path FindLibrary(const char *name) const;
    std::vector<std::string> EnvironmentOf(const WorkerRequest &request, const WorkerOptions &options) const;

    std::filesystem::path m_directory;
    std::filesystem::path m_countLibrary, m_plugin;
};

/// What Box2D did while it led two bodies along a course: steps; stock's calls of b2CollidePolygons,
/// b2TimeOfImpact and b2Distance (those that b2TimeOfImpact makes among them); the same with the plugin; and
/// the events of the plugin's structure and of contacts: pushes, stabs, rolls, contacts, leaves.
using Box2DCalls = std::array<double, 8>;

class Course;

/// Runs a course in Box2D: the polygons as bodies of fixtures of at most 8 vertices, one step for each tenth
/// of a radian or unit of length. The bodies are made large enough that Box2D's skins do not touch. Throws
/// WorkerError if a worker fails.
Box2DCalls RunInBox2D(const Course &course, const Workers &workers);

} // namespace testbed

#endif
