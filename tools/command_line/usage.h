// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_COMMAND_LINE_USAGE_H
#define BOOMERANG_COMMAND_LINE_USAGE_H

#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
} // namespace CLI

namespace command_line {

/// The fewest insertions, deletions, replacements and swaps of neighbours that turn one word into the other
/// (optimal string alignment). O(|a| |b|).
int EditDistance(const std::string &a, const std::string &b);

/// The candidate that is nearest to the word, if one is near: one that begins with the word or contains it
/// (three letters at least) goes before any that needs editing, and of those a third of the word's letters
/// may be wrong. Empty if none is. Ties go to the earlier candidate.
std::string Nearest(const std::string &word, const std::vector<std::string> &candidates);

/// "; the nearest is "planks"", or nothing where none is near.
std::string NearestClause(const std::string &word, const std::vector<std::string> &candidates);

/// For a program with commands: what is wrong with the word that should be one, if it is none; else empty.
/// (CLI11 alone would only miss one.)
std::string ExplainCommand(const CLI::App &app, int argc, char **argv);

/// What is wrong with a command line that CLI11 would not take, in words like those of our own errors: which
/// command (if the program has some), which option, what it takes, and the nearest name where one is near.
/// The program's name, which stands ahead of that, is the caller's to print. `app` has a name.
std::string ExplainUsage(const CLI::App &app, const CLI::ParseError &error, int argc, char **argv);

/// For options that are seeds (CLI11 reads -1 as the largest number there is): what is wrong, or nothing.
std::string CheckSeed(const std::string &text);

} // namespace command_line

#endif
