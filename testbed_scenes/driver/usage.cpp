// SPDX-License-Identifier: MIT
#include "commands.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <regex>
#include <sstream>

namespace testbed {
namespace {

/// The fewest insertions, deletions, replacements and swaps of neighbours that turn one word into the other
/// (optimal string alignment). O(|a| |b|).
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

/// The candidate that is nearest to the word, if one is near: one that begins with the word or contains it
/// (three letters at least) goes before any that needs editing, and of those a third of the word's letters
/// may be wrong. Empty if none is. Ties go to the earlier candidate.
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

std::string NearestClause(const std::string &word, const std::vector<std::string> &candidates) {
    const std::string nearest = Nearest(word, candidates);
    return nearest.empty() ? "" : "; the nearest is \"" + nearest + "\"";
}

std::string ExplainUsage(const CLI::App &app, const CLI::ParseError &error) {
    const std::vector<CLI::App *> parsed = app.get_subcommands();
    const CLI::App &command = parsed.empty() ? app : *parsed.front();
    const std::string name = parsed.empty() ? "" : command.get_name();
    const std::string help = " (" + app.get_name() + (name.empty() ? "" : " " + name) + " --help shows all)";
    const std::vector<std::string> left = app.remaining(true);
    if (parsed.empty() && (left.empty() || left[0][0] != '-')) {
        std::vector<std::string> names;
        std::string all;
        for (const CLI::App *other : app.get_subcommands({})) {
            names.push_back(other->get_name());
            all += (all.empty() ? "" : ", ") + names.back();
        }
        if (left.empty())
            return "a command is wanted: " + all + help;
        return "there is no command \"" + left[0] + "\"" + NearestClause(left[0], names) + help;
    }
    for (const std::string &word : left) {
        if (word.size() < 2 || word[0] != '-')
            continue;
        const std::string unknown = word.substr(0, word.find('='));
        std::vector<std::string> names;
        for (const CLI::App *its : {&command, &app})
            for (const CLI::Option *option : its->get_options())
                for (const std::string &known : option->get_lnames())
                    names.push_back("--" + known);
        return (name.empty() ? "there is" : name + " has") + " no option \"" + unknown + "\"" +
               NearestClause(unknown, names) + help;
    }
    // The option's name begins what CLI11 says, or follows its first words.
    static const std::regex option("(?:Could not convert: )?([\\w-]+).*");
    const std::string said = error.what();
    std::smatch found;
    const CLI::Option *its = nullptr;
    for (const CLI::App *may : {&app, &command})
        if (std::regex_match(said, found, option) && may->get_option_no_throw(found[1].str()) != nullptr)
            its = may->get_option_no_throw(found[1].str());
    return (name.empty() ? "" : name + ": ") + said + NearestOf(said) +
           (its != nullptr ? Described(its) : help);
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
