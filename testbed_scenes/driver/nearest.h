// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_NEAREST_H
#define BOOMERANG_TESTBED_NEAREST_H

#include <string>
#include <vector>

namespace testbed {

/// The fewest insertions, deletions, replacements and swaps of neighbours that turn one word into the other
/// (optimal string alignment). O(|a| |b|).
int EditDistance(const std::string &a, const std::string &b);

/// The candidate that is nearest to the word; one that begins with the word, or contains it, goes before any
/// that needs editing. Empty if there are no candidates. Ties go to the earlier candidate.
std::string Nearest(const std::string &word, const std::vector<std::string> &candidates);

} // namespace testbed

#endif
