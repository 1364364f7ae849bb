// SPDX-License-Identifier: MIT
#include "workers.h"

#include <cstdlib>
#include <sstream>

namespace testbed {
namespace {

namespace fs = std::filesystem;

constexpr char kStepPrefix[] = "step ";
constexpr char kSummaryPrefix[] = "summary ";
/// As much of an unexpected line as helps to recognise it.
constexpr size_t kQuotedLength = 100;

const char *ValueOf(const char *variable) {
    const char *value = std::getenv(variable);
    return value != nullptr ? value : "";
}

bool StartsWith(const std::string &text, const std::string &prefix) {
    return text.compare(0, prefix.size(), prefix) == 0;
}

std::string Quote(const std::string &line) {
    return "\"" + (line.size() > kQuotedLength ? line.substr(0, kQuotedLength) + "..." : line) + "\"";
}

} // namespace

std::vector<SceneInfo> ParseSceneList(const std::string &text) {
    std::vector<SceneInfo> scenes;
    try {
        for (const nlohmann::json &entry : nlohmann::json::parse(text)) {
            SceneInfo scene;
            entry.at("name").get_to(scene.name);
            entry.at("description").get_to(scene.description);
            entry.at("group").get_to(scene.group);
            entry.at("size").get_to(scene.size);
            entry.at("seed").get_to(scene.seed);
            entry.at("steps").get_to(scene.steps);
            entry.at("vertices").get_to(scene.vertices);
            entry.at("bodies").get_to(scene.bodies);
            scenes.push_back(scene);
        }
    } catch (const nlohmann::json::exception &error) {
        throw WorkerError(std::string("the worker's list of scenes cannot be read: ") + error.what());
    }
    return scenes;
}

bool IsStepLine(const std::string &line) {
    return StartsWith(line, kStepPrefix);
}

bool IsSummaryLine(const std::string &line) {
    return StartsWith(line, kSummaryPrefix);
}

nlohmann::json ParseSummaryLine(const std::string &line) {
    try {
        nlohmann::json summary = nlohmann::json::parse(line.substr(sizeof kSummaryPrefix - 1));
        if (summary.is_object())
            return summary;
    } catch (const nlohmann::json::exception &) {
        // Reported below, like a summary that is no object.
    }
    throw WorkerError("printed a summary that cannot be read: " + Quote(line));
}

DumpField ParseDumpLine(const std::string &line) {
    const size_t space = line.rfind(' ');
    if (space == std::string::npos || space == 0 || space + 1 == line.size())
        throw WorkerError("printed something unexpected: " + Quote(line));
    return {line.substr(0, space), line.substr(space + 1)};
}

std::string Readable(const std::string &value) {
    if (!StartsWith(value, "0x") && !StartsWith(value, "-0x"))
        return value;
    char *end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    // A hash or a set of flags in hexadecimal has no exponent, and is clearer as it is.
    if (*end != '\0' || value.find('p') == std::string::npos)
        return value;
    std::ostringstream text;
    text.precision(9);
    text << number << " (" << value << ")";
    return text.str();
}

std::optional<double> NumberAt(const nlohmann::json &json, const std::string &pointer) {
    const nlohmann::json::json_pointer path(pointer);
    if (!json.contains(path) || !json.at(path).is_number())
        return std::nullopt;
    return json.at(path).get<double>();
}

const char *NameOf(Side side) {
    static constexpr const char *names[] = {"stock", "linked", "preloaded", "accelerated", "off"};
    return names[static_cast<size_t>(side)];
}

Side StockFor(const SceneInfo &scene) {
    return scene.NeedsPlugin() ? Side::Off : Side::Stock;
}

Workers::Workers(const fs::path &directory) {
    std::error_code ignored;
    m_directory = directory.empty() ? fs::read_symlink("/proc/self/exe", ignored).parent_path() : directory;
    if (!fs::exists(ProgramOf(Side::Stock), ignored))
        throw WorkerError("no worker in " + m_directory.string() +
                          " (boomerang-scene is not built, or lies elsewhere: "
                          "see --workers)");
    // Absolute, for a library to preload must be found from wherever the worker looks.
    m_directory = fs::absolute(m_directory).lexically_normal();
    m_countLibrary = FindLibrary("libboomerang-count.so");
    m_plugin = FindLibrary("libboomerang_box2d.so");
}

fs::path Workers::FindLibrary(const char *name) const {
    std::error_code ignored;
    for (const fs::path &place :
         {m_directory / ".." / "lib", m_directory, m_directory / BOOMERANG_LIBRARY_DIRECTORY,
          m_directory / BOOMERANG_LIBRARY_DIRECTORY / "boomerang"}) {
        fs::path library = (place / name).lexically_normal();
        if (fs::exists(library, ignored))
            return library;
    }
    return {};
}

bool Workers::CanAccelerate() const {
    std::error_code ignored;
    return fs::exists(ProgramOf(Side::Accelerated), ignored);
}

fs::path Workers::ProgramOf(Side side) const {
    if (side == Side::Accelerated)
        return m_directory / "boomerang-scene-accelerated";
    const bool stock = side == Side::Stock || side == Side::Preloaded;
    return m_directory / (stock ? "boomerang-scene" : "boomerang-scene-plugin");
}

/// What a worker is told, whatever habits the caller's environment has. An empty value counts as none.
std::vector<std::string> Workers::EnvironmentOf(const WorkerRequest &request,
                                                const WorkerOptions &options) const {
    std::string mode, preload;
    auto preloaded = [&preload](const std::string &library) {
        preload += (preload.empty() ? "" : ":") + library;
    };
    if (request.side == Side::Off)
        mode = "off";
    if (request.side == Side::Preloaded) {
        mode = "on";
        preloaded(m_plugin.string());
    }
    if (request.mode == "count" && CanCount()) {
        // Behind the plugin: what is counted is what reaches Box2D.
        if (request.side != Side::Stock && request.side != Side::Preloaded && CanPreload())
            preloaded(m_plugin.string());
        preloaded(m_countLibrary.string());
    }
    std::vector<std::string> environment = {"BOOMERANG=" + mode, "BOOMERANG_PAIRS_BY=" + options.structure,
                                            "BOOMERANG_VERBOSE="};
    if (!preload.empty()) {
        if (*ValueOf("LD_PRELOAD") != '\0')
            preloaded(ValueOf("LD_PRELOAD"));
        environment.push_back("LD_PRELOAD=" + preload);
        // The address sanitizer refuses to start behind a preloaded library, which here is built with it as
        // well.
        const std::string sanitizer = ValueOf("ASAN_OPTIONS");
        environment.push_back("ASAN_OPTIONS=" + sanitizer + (sanitizer.empty() ? "" : ":") +
                              "verify_asan_link_order=0");
    }
    return environment;
}

std::vector<SceneInfo> Workers::List() const {
    std::string text;
    Process process({ProgramOf(Side::Stock).string(), "--list-json"}, {},
                    [&text](const std::string &line) { text += line + "\n"; });
    // Takes milliseconds; a program that is no worker may never end.
    RunAll({&process}, nullptr, std::chrono::seconds(20));
    if (!process.Succeeded())
        throw WorkerError(process.Describe());
    return ParseSceneList(text);
}

std::unique_ptr<Process> Workers::Start(const WorkerRequest &request, const WorkerOptions &options,
                                        Process::LineHandler onLine) const {
    std::vector<std::string> arguments = {ProgramOf(request.side).string(), "--steps",
                                          std::to_string(request.steps), "--mode", request.mode};
    if (request.course.empty())
        arguments.insert(arguments.begin() + 1, request.scene);
    auto add = [&arguments](const char *name, const std::string &value) {
        arguments.emplace_back(name);
        arguments.push_back(value);
    };
    if (!request.course.empty())
        add("--course", request.course);
    if (options.size)
        add("--size", std::to_string(*options.size));
    if (options.seed)
        add("--seed", std::to_string(*options.seed));
    arguments.insert(arguments.end(), request.extra.begin(), request.extra.end());

    return std::make_unique<Process>(std::move(arguments), EnvironmentOf(request, options),
                                     std::move(onLine));
}

nlohmann::json Workers::Summarise(const WorkerRequest &request, const WorkerOptions &options,
                                  const std::function<void()> &onTick,
                                  const Process::LineHandler &onLine) const {
    nlohmann::json summary;
    const std::unique_ptr<Process> process = Start(request, options, [&](const std::string &line) {
        if (IsSummaryLine(line))
            summary = ParseSummaryLine(line);
        else if (onLine)
            onLine(line);
    });
    RunAll({process.get()}, onTick);
    if (!process->Succeeded())
        throw WorkerError(process->Describe());
    if (summary.is_null())
        throw WorkerError(process->CommandLine() + ": ended without a summary");
    return summary;
}

} // namespace testbed
