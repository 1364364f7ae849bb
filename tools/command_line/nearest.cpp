// SPDX-License-Identifier: MIT
#include "command_line/nearest.h"

#include <algorithm>

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

} // namespace command_line
