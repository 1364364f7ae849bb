// SPDX-License-Identifier: MIT
// boomerang: the plugin's program for the command line. `boomerang try ./game` says whether a game profits
// from Boomerang, without building anything.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>

#include <CLI/CLI.hpp>
#include <unistd.h>

#include "command_line/usage.h"
#include "try/elf_file.h"
#include "try/place.h"
#include "try/run.h"
#include "try/verdict.h"

namespace bmr::trial {
namespace {

constexpr int kColumns = 100;
constexpr const char *kLibrary = "libboomerang_box2d.so";

struct Options {
    std::vector<std::string> command;
    std::string library;
    bool isLibraryOfOurs = false; ///< and not --library's
    Limits limits;
    int rounds = 3;
    bool json = false, shown = false, quiet = false;
};

enum Exit { kDone = 0, kDiffers = 1, kUsage = 2, kNothing = 3, kFails = 4, kInterrupted = 130 };

int ExitOf(Outcome outcome) {
    switch (outcome) {
    case Outcome::kAtWork:
        return kDone;
    case Outcome::kDifference:
        return kDiffers;
    case Outcome::kNotAtWork:
        return kNothing;
    case Outcome::kFailsByItself:
        break;
    }
    return kFails;
}

/// Beside this program, as it is built and as it is installed.
std::string FindLibrary() {
    char path[4096];
    const ssize_t length = readlink("/proc/self/exe", path, sizeof path);
    std::string folder(path, length > 0 ? static_cast<size_t>(length) : 0);
    folder.erase(std::min(folder.rfind('/'), folder.size()));
    for (const char *place : {"/" BMR_BIN_TO_LIB "/", "/../lib/", "/"})
        if (const std::string found = folder + place + kLibrary; access(found.c_str(), R_OK) == 0) {
            char *whole = realpath(found.c_str(), nullptr);
            std::string made = whole != nullptr ? whole : found;
            std::free(whole);
            return made;
        }
    return "";
}

/// One line on a terminal that is written over, one for each run elsewhere; nothing with --quiet.
class Progress {
public:
    Progress(const Options &options, int runs)
        : m_shown(!options.quiet), m_terminal(isatty(STDERR_FILENO) != 0 && !options.shown), m_runs(runs),
          m_limits(options.limits) {}

    void Begin(const char *name) {
        m_name = name;
        ++m_run;
        if (m_shown && !m_terminal)
            std::fprintf(stderr, "boomerang: run %d of %d: %s\n", m_run, m_runs, name);
    }
    void Tick(double seconds, uint32_t steps) const {
        if (!m_shown || !m_terminal)
            return;
        const double part = std::max(seconds / m_limits.seconds,
                                     m_limits.steps > 0 ? static_cast<double>(steps) / m_limits.steps : 0.0);
        const int done = static_cast<int>(std::lround(kWidth * std::min(part, 1.0)));
        std::fprintf(stderr, "\r[%.*s%*s] run %d of %d: %-8s %6.1f s %9u steps", done, kBar, kWidth - done,
                     "", m_run, m_runs, m_name, seconds, steps);
    }
    void End() const {
        if (m_shown && m_terminal)
            std::fputs("\r\033[K", stderr);
    }

private:
    static constexpr int kWidth = 24;
    static constexpr const char *kBar = "========================";
    bool m_shown, m_terminal;
    int m_run = 0, m_runs;
    Limits m_limits;
    const char *m_name = "";
};

/// The variable's value in this process.
std::string PreloadedBefore() {
    const char *before = std::getenv("LD_PRELOAD");
    return before != nullptr ? before : "";
}

Outcome RunAll(const Options &options, Trial *trial) {
    Progress progress(options, 2 + 2 * options.rounds);
    const auto run = [&](const char *name, const char *mode) {
        progress.Begin(name);
        std::vector<std::string> variables;
        if (mode != nullptr)
            variables = {"LD_PRELOAD=" + trial->preload, std::string("BOOMERANG=") + mode,
                         "BOOMERANG_VERBOSE=1"};
        Run made = RunGame(options.command, variables, mode != nullptr, options.shown, options.limits,
                           [&](double seconds, uint32_t steps) { progress.Tick(seconds, steps); });
        progress.End();
        return made;
    };
    trial->asItIs = run("as it is", nullptr);
    if (JudgeAsItIs(*trial) != Outcome::kAtWork || IsInterrupted())
        return Outcome::kFailsByItself;
    // A game that is linked with the library is tried as it was built.
    if (options.isLibraryOfOurs && HasBoomerang(trial->asItIs))
        trial->preload = PreloadedBefore();
    for (int round = 0; round < options.rounds && !IsInterrupted(); ++round) {
        trial->off.push_back(run("off", "off"));
        if (trial->off.front().steps == 0 || IsInterrupted())
            return Judge(*trial);
        trial->on.push_back(run("on", "on"));
        if (trial->on.front().way.empty())
            return Judge(*trial); // left alone: it says why
    }
    if (!IsInterrupted())
        trial->verify = run("verify", "verify");
    return Judge(*trial);
}

int Try(const Options &options) {
    Trial trial;
    trial.command = options.command;
    // Libraries that the user has in LD_PRELOAD stay behind ours.
    const std::string before = PreloadedBefore();
    trial.preload = options.library + (before.empty() ? "" : ":" + before);
    trial.preloadedAsItIs = before.find("libboomerang_box2d") != std::string::npos;
    trial.program = FindProgram(options.command[0]);
    if (trial.program.empty()) {
        std::cerr << "boomerang try: cannot start " << options.command[0] << ": "
                  << WhyNoProgram(options.command[0]) << '\n';
        return kUsage;
    }
    WatchForInterrupts();
    const Outcome outcome = RunAll(options, &trial);
    if (IsInterrupted()) {
        std::cerr << "boomerang try: interrupted; the game was ended\n";
        return kInterrupted;
    }
    std::cout << (options.json ? ExplainAsJson(trial, outcome) : Explain(trial, outcome, kColumns))
              << std::flush;
    if (!std::cout) {
        std::cerr << "boomerang try: what was found could not be written\n";
        return kUsage;
    }
    return ExitOf(outcome);
}

/// Where the game's command line begins: at `--`, or at the first word that is neither an option of `command`
/// nor the value of one.
char **FindGame(const CLI::App &command, char **words, char **end) {
    bool isValue = false, isOurs = true; // the program's own name, and the command's
    for (char **word = words; word != end; ++word) {
        const std::string text = *word;
        if (text == "--")
            return word;
        if (isOurs) {
            isOurs = text != command.get_name();
        } else if (isValue) {
            isValue = false;
        } else if (text.empty() || text[0] != '-') {
            return word;
        } else {
            const CLI::Option *option = command.get_option_no_throw(text);
            isValue = option != nullptr && option->get_items_expected_max() > 0;
        }
    }
    return end;
}

CLI::App *AddTry(CLI::App *app, Options *options) {
    app->set_version_flag("--version", "boomerang " BMR_VERSION);
    app->require_subcommand(1);
    CLI::App *command =
        app->add_subcommand("try", "Play a game as it is, and with Boomerang; say what it gains");
    command->add_option("--seconds", options->limits.seconds, "Each run is ended after so many seconds")
        ->check(CLI::Range(0.1, 86400.0))
        ->check([](const std::string &text) { // no Range is without a NaN
            return std::isnan(std::strtod(text.c_str(), nullptr))
                       ? "Value " + text + " not in range 0.1 to 86400"
                       : std::string();
        })
        ->capture_default_str();
    command
        ->add_option("--steps", options->limits.steps,
                     "and after so many steps, where --seconds is not over before")
        ->check(CLI::Range(1, 1000000000));
    command
        ->add_option("--rounds", options->rounds, "Runs off and on, in turns; each pair of them is one ratio")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command
        ->add_option("--library", options->library,
                     "libboomerang_box2d.so (default: the one beside this program)")
        ->check(CLI::ExistingFile);
    command->add_flag("--json", options->json, "Print what was found as JSON");
    command->add_flag("--show-output", options->shown, "Let the game write to this terminal");
    command->add_flag("--quiet", options->quiet, "No progress on stderr");
    command->footer(
        "The first word that is no option is the game; what follows is the game's own (-- may stand "
        "between).\n\n"
        "Plays the game as it is; preloaded but off, which tells stock's time for a step; on; and in mode\n"
        "verify, which compares each answer with Box2D's. Nothing is built, and nothing is changed.\n\n"
        "Exit status: 0, at work and nothing differs; 1, an answer differs, or the game ends otherwise;\n"
        "2, wrong usage; 3, Boomerang does nothing for this game as it is built; 4, the game fails by\n"
        "itself.\n\n"
        "  boomerang try --seconds 10 ./game --level 3");
    return command;
}

int Main(int count, char **words) {
    Options options;
    CLI::App app("Boomerang for the command line: is it for my game?", "boomerang");
    const CLI::App *const command = AddTry(&app, &options);
    // The game's command line is the game's: it is not parsed here.
    char **const end = words + count, **game = FindGame(*command, words, end);
    const int own = static_cast<int>(game - words);
    if (game != end && std::strcmp(*game, "--") == 0)
        ++game;
    options.command.assign(game, end);
    if (const std::string unknown = command_line::ExplainCommand(app, own, words); !unknown.empty()) {
        std::cerr << "boomerang: " << unknown << '\n';
        return kUsage;
    }
    try {
        app.parse(own, words);
    } catch (const CLI::Success &asked) { // help, the version
        return app.exit(asked);
    } catch (const CLI::ParseError &error) {
        std::cerr << "boomerang: " << command_line::ExplainUsage(app, error, own, words) << '\n';
        return kUsage;
    }
    if (options.command.empty()) {
        std::cerr << "boomerang try: which game? boomerang try ./game\n";
        return kUsage;
    }
    options.isLibraryOfOurs = options.library.empty();
    if (options.isLibraryOfOurs)
        options.library = FindLibrary();
    if (options.library.empty()) {
        std::cerr << "boomerang try: there is no " << kLibrary
                  << " beside this program; --library says where\n";
        return kUsage;
    }
    if (const ElfFile::Kind kind = LookAtFile(options.library).kind;
        kind == ElfFile::Kind::kOther || kind == ElfFile::Kind::kUnreadable) {
        std::cerr << "boomerang try: --library: " << options.library << " is no library\n";
        return kUsage;
    }
    return Try(options);
}

} // namespace
} // namespace bmr::trial

int main(int count, char **words) {
    try {
        return bmr::trial::Main(count, words);
    } catch (const std::exception &error) { // no process, no memory
        std::fprintf(stderr, "boomerang: %s\n", error.what());
        return bmr::trial::kUsage;
    }
}
