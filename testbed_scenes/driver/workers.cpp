// SPDX-License-Identifier: MIT
#include "workers.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <fstream>
#include <memory>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace testbed {
namespace {

namespace fs = std::filesystem;

constexpr char kSummaryPrefix[] = "summary ";

const char *ValueOf(const char *variable) {
    const char *value = std::getenv(variable);
    return value != nullptr ? value : "";
}

bool StartsWith(const std::string &text, const std::string &prefix) {
    return text.compare(0, prefix.size(), prefix) == 0;
}

/// What this process has open, once more and from its beginning.
std::ifstream Opened(int descriptor) {
    return std::ifstream("/dev/fd/" + std::to_string(descriptor));
}

/// A command line for messages: the directory of the program says little and fills the line.
std::string LineOf(const std::vector<std::string> &arguments) {
    std::string line = fs::path(arguments[0]).filename();
    for (size_t i = 1; i < arguments.size(); ++i)
        line += " " + arguments[i];
    return line;
}

/// How a program failed, with the last lines that it wrote to its errors.
[[noreturn]] void Fail(const std::vector<std::string> &arguments, int status, std::ifstream errors) {
    // Enough for an assertion, a sanitizer's headline or a backtrace's top.
    constexpr size_t kErrorLines = 12;
    std::string text = LineOf(arguments) + ": ";
    if (WIFSIGNALED(status))
        text +=
            "killed by signal " + std::to_string(WTERMSIG(status)) + " (" + strsignal(WTERMSIG(status)) + ")";
    else
        text += "exit status " + std::to_string(WEXITSTATUS(status));
    std::deque<std::string> lines;
    for (std::string line; std::getline(errors, line);) {
        lines.push_back(line);
        if (lines.size() > kErrorLines)
            lines.pop_front();
    }
    for (const std::string &line : lines)
        text += "\n    | " + line;
    throw WorkerError(text);
}

/// Starts a program with this process's environment and some additions to it ("NAME=value"). It writes into
/// these files.
pid_t Spawn(const std::vector<std::string> &arguments, const std::vector<std::string> &environment,
            int output, int errors) {
    std::vector<std::string> words = {"env"};
    words.insert(words.end(), environment.begin(), environment.end());
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char *> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string &word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
    pid_t child = -1;
    const int failure = posix_spawnp(&child, "env", &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failure != 0)
        throw WorkerError("cannot start " + arguments[0] + ": " + std::strerror(failure));
    return child;
}

/// Runs a program to its end. Throws WorkerError if it fails; what onLine throws ends it.
void RunProgram(const std::vector<std::string> &arguments, const std::vector<std::string> &environment,
                const LineHandler &onLine) {
    const std::unique_ptr<FILE, int (*)(FILE *)> errors(std::tmpfile(), std::fclose);
    int ends[2];
    // Close-on-exec, so that a worker started meanwhile does not hold another's pipe open.
    if (errors == nullptr || pipe2(ends, O_CLOEXEC) != 0)
        throw WorkerError(std::string("cannot start a worker: ") + std::strerror(errno));
    const pid_t child = Spawn(arguments, environment, ends[1], fileno(errors.get()));
    std::ifstream output = Opened(ends[0]);
    close(ends[0]);
    close(ends[1]);
    int status = 0;
    try {
        for (std::string line; std::getline(output, line);)
            onLine(line);
    } catch (...) {
        kill(child, SIGKILL);
        waitpid(child, &status, 0);
        throw;
    }
    waitpid(child, &status, 0);
    if (status != 0)
        Fail(arguments, status, Opened(fileno(errors.get())));
}

} // namespace

// The list of scenes as a worker writes it.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SceneInfo, name, description, group, size, steps, vertices, bodies)

std::optional<double> NumberAt(const nlohmann::json &json, const std::string &pointer) {
    const nlohmann::json::json_pointer path(pointer);
    if (!json.contains(path) || !json.at(path).is_number())
        return std::nullopt;
    return json.at(path).get<double>();
}

const char *NameOf(Side side) {
    static constexpr const char *names[] = {"stock", "linked", "preloaded", "off"};
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

fs::path Workers::ProgramOf(Side side) const {
    const bool stock = side == Side::Stock || side == Side::Preloaded;
    return m_directory / (stock ? "boomerang-scene" : "boomerang-scene-plugin");
}

/// The environment variables that a worker gets. Boomerang's own are always among them, so that those of the
/// caller's shell change nothing; an empty value counts as none.
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
    RunProgram({ProgramOf(Side::Stock).string(), "--list-json"}, {},
               [&text](const std::string &line) { text += line + "\n"; });
    try {
        return nlohmann::json::parse(text).get<std::vector<SceneInfo>>();
    } catch (const nlohmann::json::exception &error) {
        throw WorkerError(std::string("the worker's list of scenes cannot be read: ") + error.what());
    }
}

nlohmann::json Workers::Run(const WorkerRequest &request, const WorkerOptions &options,
                            const LineHandler &onLine) const {
    std::vector<std::string> arguments = {ProgramOf(request.side).string()};
    auto add = [&arguments](const char *name, const std::string &value) {
        arguments.emplace_back(name);
        arguments.push_back(value);
    };
    if (request.course.empty())
        arguments.push_back(request.scene);
    else
        add("--course", request.course);
    add("--steps", std::to_string(request.steps));
    add("--mode", request.mode);
    if (options.size)
        add("--size", std::to_string(*options.size));
    if (options.seed)
        add("--seed", std::to_string(*options.seed));
    arguments.insert(arguments.end(), request.extra.begin(), request.extra.end());
    nlohmann::json summary;
    try {
        RunProgram(arguments, EnvironmentOf(request, options), [&](const std::string &line) {
            if (StartsWith(line, kSummaryPrefix))
                summary = nlohmann::json::parse(line.substr(sizeof kSummaryPrefix - 1));
            else if (onLine)
                onLine(line);
        });
    } catch (const nlohmann::json::exception &error) {
        throw WorkerError(LineOf(arguments) + ": printed what cannot be read: " + error.what());
    }
    if (!summary.is_object())
        throw WorkerError(LineOf(arguments) + ": ended without a summary");
    return summary;
}

} // namespace testbed
