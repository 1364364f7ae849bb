// SPDX-License-Identifier: MIT
#include "usage.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <regex>
#include <sstream>

namespace testbed {

int EditDistance(const std::string &a, const std::string &b) {
    // Three rows of the table: a swap of neighbours looks two rows back.
    std::vector<int> beforeLast(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (size_t j = 0; j <= b.size(); ++j)
        last[j] = static_cast<int>(j);
    for (size_t i = 1; i <= a.size(); ++i) {
        row[0] = static_cast<int>(i);
        for (size_t j = 1; j <= b.size(); ++j) {
            const int replacement = a[i - 1] == b[j - 1] ? 0 : 1;
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + replacement});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], beforeLast[j - 2] + 1);
        }
        std::swap(beforeLast, last);
        std::swap(last, row);
    }
    return last[b.size()];
}

std::string Nearest(const std::string &word, const std::vector<std::string> &candidates) {
    constexpr size_t kLeastPart = 3;
    std::string best;
    // One that is as far off as this is as good as none.
    int bestScore = static_cast<int>(word.size() + 1) / 3 + 1;
    for (const std::string &candidate : candidates) {
        const size_t position = word.size() < kLeastPart ? std::string::npos : candidate.find(word);
        // "asteroid" means "asteroids" and "wall" means "bullets-wall", however many letters are missing.
        const int score = position == 0                   ? -2
                          : position != std::string::npos ? -1
                                                          : EditDistance(word, candidate);
        if (score < bestScore) {
            best = candidate;
            bestScore = score;
        }
    }
    return best;
}

std::string NearestClause(const std::string &word, const std::vector<std::string> &candidates) {
    const std::string nearest = Nearest(word, candidates);
    return nearest.empty() ? "" : "; the nearest is \"" + nearest + "\"";
}

namespace {

/// The place in argv of the word that should be a command; argc if there is none.
int CommandAt(const CLI::App &app, int argc, char **argv) {
    if (app.get_subcommands({}).empty())
        return argc;
    // Options of the program itself may stand ahead, each with its value.
    const auto takesValue = [&app](const char *word) {
        const CLI::Option *option = app.get_option_no_throw(word);
        return option != nullptr && option->get_expected_min() > 0;
    };
    int first = 1;
    while (first + 1 < argc && takesValue(argv[first]))
        first += 2;
    return first < argc && argv[first][0] != '-' ? first : argc;
}

/// A command with its options, and those of the program that may stand behind it.
class Scope {
public:
    Scope(const CLI::App &app, int argc, char **argv) : m_app(app), m_command(&app) {
        const int at = CommandAt(app, argc, argv);
        for (const CLI::App *command : app.get_subcommands({}))
            if (at < argc && command->get_name() == argv[at])
                m_command = command;
        m_words.assign(argv + std::min(argc, at == argc ? 1 : at + 1), argv + argc);
    }

    bool HasCommand() const { return m_command != &m_app; }
    bool LacksCommand() const { return !HasCommand() && !m_app.get_subcommands({}).empty(); }
    /// "render: ", or nothing where there is no command.
    std::string Ahead() const { return HasCommand() ? m_command->get_name() + ": " : ""; }
    /// "render has", or "there is" where there is no command.
    std::string Has() const { return HasCommand() ? m_command->get_name() + " has" : "there is"; }
    std::string Help() const {
        return " (" + m_app.get_name() + (HasCommand() ? " " + m_command->get_name() : "") +
               " --help shows all)";
    }

    const CLI::Option *Find(const std::string &name) const {
        const CLI::Option *own = m_command->get_option_no_throw(name);
        return own != nullptr ? own : m_app.get_option_no_throw(name);
    }
    /// The first word that looks like an option and is none; else empty.
    std::string UnknownOption() const {
        for (const std::string &word : m_words) {
            if (word == "--")
                break;
            const bool isOption = word.size() > 1 && word[0] == '-' && word[1] != '.' &&
                                  std::isdigit(static_cast<unsigned char>(word[1])) == 0;
            std::string name = word.substr(0, word.find('='));
            // Of a short option the value may follow at once.
            if (isOption && Find(name) == nullptr && (name[1] == '-' || Find(name.substr(0, 2)) == nullptr))
                return name;
        }
        return "";
    }
    std::vector<std::string> OptionNames() const {
        std::vector<std::string> names;
        for (const CLI::App *app : {m_command, &m_app})
            for (const CLI::Option *option : app->get_options())
                for (const std::string &name : option->get_lnames())
                    names.push_back("--" + name);
        return names;
    }

private:
    const CLI::App &m_app;
    const CLI::App *m_command;
    std::vector<std::string> m_words;
};

/// What the option is, on a line of its own.
std::string Described(const CLI::Option *option) {
    const std::vector<std::string> &names = option->get_lnames();
    return "\n    " + (names.empty() ? option->get_name() : "--" + names.front()) + ": " +
           option->get_description();
}

/// CLI11 names the words that an option takes: which of them is the nearest to what it was given?
std::string NearestOf(const std::string &said) {
    static const std::regex words("\\S+: (.*) not in \\{(.*)\\}");
    std::smatch found;
    if (!std::regex_match(said, found, words))
        return "";
    std::vector<std::string> names;
    std::istringstream list(found[2].str());
    for (std::string name; std::getline(list, name, ',');)
        names.push_back(name);
    return NearestClause(found[1].str(), names);
}

} // namespace

std::string ExplainCommand(const CLI::App &app, int argc, char **argv) {
    const int at = CommandAt(app, argc, argv);
    if (at == argc)
        return "";
    std::vector<std::string> names;
    for (const CLI::App *command : app.get_subcommands({})) {
        if (command->get_name() == argv[at])
            return "";
        names.push_back(command->get_name());
    }
    return std::string("there is no command \"") + argv[at] + "\"" + NearestClause(argv[at], names) + " (" +
           app.get_name() + " --help shows all)";
}

std::string ExplainUsage(const CLI::App &app, const CLI::ParseError &error, int argc, char **argv) {
    const Scope scope(app, argc, argv);
    const std::string said = error.what();
    if (const std::string unknown = scope.UnknownOption(); !unknown.empty())
        return scope.Has() + " no option \"" + unknown + "\"" + NearestClause(unknown, scope.OptionNames()) +
               scope.Help();
    if (scope.LacksCommand()) {
        std::string all;
        for (const CLI::App *command : app.get_subcommands({}))
            all += (all.empty() ? "" : ", ") + command->get_name();
        return "a command is wanted: " + all + scope.Help();
    }
    // The option's name begins what CLI11 says, or follows its first words.
    static const std::regex name("(?:Could not convert: )?([\\w-]+).*");
    std::smatch found;
    const bool isNamed = std::regex_match(said, found, name);
    const CLI::Option *option = isNamed ? scope.Find(found[1].str()) : nullptr;
    return scope.Ahead() + said + NearestOf(said) + (option != nullptr ? Described(option) : scope.Help());
}

CLI::Validator Whole(uint64_t least, uint64_t most) {
    const std::string range = std::to_string(least) + " to " + std::to_string(most);
    return CLI::Validator(
        [=](const std::string &text) {
            errno = 0;
            const bool isDigits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
            const uint64_t number = std::strtoull(text.c_str(), nullptr, 10);
            const bool isIn = isDigits && errno == 0 && number >= least && number <= most;
            return isIn ? "" : "\"" + text + "\" is no whole number from " + range;
        },
        range);
}

} // namespace testbed
