// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_COMMAND_LINE_NEAREST_H
#define BOOMERANG_COMMAND_LINE_NEAREST_H

#include <string>
#include <vector>

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

} // namespace command_line

#endif
