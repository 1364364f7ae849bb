// SPDX-License-Identifier: MIT
#include "workers.h"

#include <cstdlib>

namespace testbed {
namespace {

namespace fs = std::filesystem;

constexpr char kCountLibrary[] = "libboomerang-count.so";

/// The environment of a run that counts calls.
std::vector<std::string> CountingEnvironment(const fs::path &library) {
    const char *preloaded = std::getenv("LD_PRELOAD");
    const char *sanitizer = std::getenv("ASAN_OPTIONS");
    std::string preload = library.string();
    if (preloaded != nullptr && preloaded[0] != '\0')
        preload += std::string(":") + preloaded;
    // The address sanitizer refuses to start behind a preloaded library, which here is built with it as well.
    std::string options = "verify_asan_link_order=0";
    if (sanitizer != nullptr && sanitizer[0] != '\0')
        options = std::string(sanitizer) + ":" + options;
    return {"LD_PRELOAD=" + preload, "ASAN_OPTIONS=" + options};
}

} // namespace

const char *NameOf(Side side) {
    return side == Side::Stock ? "stock" : "plugin";
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
    for (const fs::path &place : {m_directory / ".." / "lib", m_directory}) {
        const fs::path library = (place / kCountLibrary).lexically_normal();
        if (fs::exists(library, ignored)) {
            m_countLibrary = library;
            break;
        }
    }
}

fs::path Workers::ProgramOf(Side side) const {
    return m_directory / (side == Side::Stock ? "boomerang-scene" : "boomerang-scene-plugin");
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
    std::vector<std::string> arguments = {ProgramOf(request.side).string(), request.scene, "--steps",
                                          std::to_string(request.steps),    "--mode",      request.mode};
    auto add = [&arguments](const char *name, const std::string &value) {
        arguments.emplace_back(name);
        arguments.push_back(value);
    };
    if (options.size)
        add("--size", std::to_string(*options.size));
    if (options.seed)
        add("--seed", std::to_string(*options.seed));
    if (request.side == Side::Plugin && !options.structure.empty())
        add("--structure", options.structure);
    if (request.side == Side::Plugin && !options.prefilter.empty())
        add("--prefilter", options.prefilter);
    arguments.insert(arguments.end(), request.extra.begin(), request.extra.end());

    std::vector<std::string> environment;
    if (request.mode == "count" && CanCount())
        environment = CountingEnvironment(m_countLibrary);
    return std::make_unique<Process>(std::move(arguments), environment, std::move(onLine));
}

nlohmann::json Workers::Summarise(const WorkerRequest &request, const WorkerOptions &options,
                                  const std::function<void()> &onTick) const {
    nlohmann::json summary;
    const std::unique_ptr<Process> process = Start(request, options, [&summary](const std::string &line) {
        if (IsSummaryLine(line))
            summary = ParseSummaryLine(line);
        else if (!IsStepLine(line))
            ParseDumpLine(line); // throws on what is no field either
    });
    RunAll({process.get()}, onTick);
    if (!process->Succeeded())
        throw WorkerError(process->Describe());
    if (summary.is_null())
        throw WorkerError(process->CommandLine() + ": ended without a summary");
    return summary;
}

} // namespace testbed
