// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_USAGE_H
#define BOOMERANG_TESTBED_USAGE_H

#include <cstdint>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace testbed {

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

/// What is wrong with a command line that CLI11 would not take: which command, which option, what it takes,
/// and the nearest name where one is near. The program's name, which stands ahead of that, is the caller's to
/// print. `app` has a name.
std::string ExplainUsage(const CLI::App &app, const CLI::ParseError &error, int argc, char **argv);

/// Takes the whole numbers of a range. (CLI11's own Range takes 3.5 for one that is too large or too small,
/// and without it -1 is the largest number there is.) Unless told otherwise `most` is more than anybody
/// means.
CLI::Validator Whole(uint64_t least, uint64_t most = 100000000);

} // namespace testbed

#endif
