// SPDX-License-Identifier: MIT
#include "command_line/usage.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <regex>
#include <sstream>
#include <vector>

#include <CLI/CLI.hpp>
#include <sys/stat.h>

namespace command_line {

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
    /// "render needs ", or words for where there is no command.
    std::string Needs() const {
        return HasCommand() ? m_command->get_name() + " needs " : "what is missing is ";
    }
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
            const std::string name = word.substr(0, word.find('='));
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

std::string OptionName(const CLI::Option *option, const std::string &otherwise) {
    if (option == nullptr)
        return otherwise;
    return option->get_lnames().empty() ? option->get_name() : "--" + option->get_lnames().front();
}

/// "", or what the option is, on lines of its own.
std::string Described(const CLI::Option *option) {
    if (option == nullptr || option->get_description().empty())
        return "";
    static const std::regex newLine("\n");
    return "\n    " + OptionName(option, "") + ": " +
           std::regex_replace(option->get_description(), newLine, "\n        ");
}

/// Without the zeros that end a fraction.
std::string Shortened(const std::string &number) {
    static const std::regex zeros("\\.?0+$");
    return number.find('.') == std::string::npos ? number : std::regex_replace(number, zeros, "");
}

/// What a check of CLI11's says about a value.
std::string ExplainValue(const CLI::Option *option, const std::string &said) {
    static const std::regex range("Value (.*) not in range (\\S+) to (\\S+)"),
        words("(.*) not in \\{(.*)\\}"), mapped("Check (.*) value in \\{(.*?)\\} OR .*"),
        missing("(File|Directory) does not exist: (.*)");
    std::smatch found;
    if (std::regex_match(said, found, range)) {
        const bool whole = option != nullptr && option->get_type_name().find("INT") != std::string::npos;
        return "\"" + found[1].str() + "\" is no " + (whole ? "whole " : "") + "number from " +
               Shortened(found[2].str()) + " to " + Shortened(found[3].str());
    }
    if (std::regex_match(said, found, words) || std::regex_match(said, found, mapped)) {
        std::vector<std::string> names;
        std::istringstream list(found[2].str());
        std::string all;
        for (std::string name; std::getline(list, name, ',');) {
            name.erase(std::min(name.find("->"), name.size())); // what a name stands for
            all += (names.empty() ? "" : ", ") + name;
            names.push_back(name);
        }
        return "\"" + found[1].str() + "\" is none of " + all + NearestClause(found[1].str(), names);
    }
    if (std::regex_match(said, found, missing)) {
        struct stat ignored = {};
        const int error = stat(found[2].str().c_str(), &ignored) != 0 ? errno : ENOENT;
        return "cannot read " + found[2].str() + ": " + std::strerror(error);
    }
    return said;
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
    const auto is = [&error](CLI::ExitCodes code) { return error.get_exit_code() == static_cast<int>(code); };
    if (const std::string unknown = scope.UnknownOption(); !unknown.empty())
        return scope.Has() + " no option \"" + unknown + "\"" + NearestClause(unknown, scope.OptionNames()) +
               scope.Help();
    if (scope.LacksCommand()) {
        std::string all;
        for (const CLI::App *command : app.get_subcommands({}))
            all += (all.empty() ? "" : ", ") + command->get_name();
        return "a command is wanted: " + all + scope.Help();
    }
    if (is(CLI::ExitCodes::ExtrasError))
        return scope.Ahead() + "\"" + said.substr(said.find_last_of(" :") + 1) +
               "\" is one argument too many";
    if (is(CLI::ExitCodes::RequiredError)) {
        const CLI::Option *option = scope.Find(said.substr(0, said.find(' ')));
        if (option != nullptr)
            return scope.Needs() + OptionName(option, "") + Described(option);
    }
    static const std::regex excludes("(\\S+) excludes (\\S+)"), needs("(\\S+) requires (\\S+)");
    std::smatch found;
    if (std::regex_match(said, found, excludes))
        return scope.Ahead() + found[1].str() + " and " + found[2].str() + " do not go together";
    if (std::regex_match(said, found, needs))
        return scope.Ahead() + found[1].str() + " is nothing without " + found[2].str();
    static const std::regex convert("Could not convert: (\\S+) = (.*)");
    if (std::regex_match(said, found, convert)) {
        const CLI::Option *option = scope.Find(found[1].str());
        const bool whole = option != nullptr && option->get_type_name().find("INT") != std::string::npos;
        return scope.Ahead() + OptionName(option, found[1].str()) + ": \"" + found[2].str() + "\" is no " +
               (whole ? "whole " : "") + "number" + Described(option);
    }
    const size_t colon = said.find(": ");
    const CLI::Option *option = colon != std::string::npos ? scope.Find(said.substr(0, colon)) : nullptr;
    if (option == nullptr)
        return scope.Ahead() + said + scope.Help();
    const bool tooMany = said.find("At Most") != std::string::npos;
    const std::string what = is(CLI::ExitCodes::ArgumentMismatch)
                                 ? (tooMany ? "it is given more than once" : "a value is missing")
                                 : ExplainValue(option, said.substr(colon + 2));
    return scope.Ahead() + OptionName(option, "") + ": " + what + Described(option);
}

std::string CheckSeed(const std::string &text) {
    errno = 0;
    char *end = nullptr;
    std::strtoull(text.c_str(), &end, 10);
    const bool isDigits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
    return isDigits && errno == 0 ? "" : "\"" + text + "\" is no whole number from 0 to 18446744073709551615";
}

} // namespace command_line
