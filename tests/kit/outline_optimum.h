// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_OUTLINE_OPTIMUM_H
#define BMR_TEST_OUTLINE_OPTIMUM_H

#include <algorithm>
#include <cstdint>
#include <vector>

#include "outline_oracle.h"

/// @file
/// The fewest convex pieces of a simple polygon, cut from corner to corner: every convex piece beside every
/// segment is tried. Polynomial, and nothing of core's; slow. (Cuts that end in no notch are left out: what
/// they part is convex without them.)

namespace outlines {

class Optimum {
public:
    /// Counter-clockwise, without holes and touches.
    explicit Optimum(std::vector<bmr_vec2> corners)
        : m_corners(std::move(corners)), m_count(m_corners.size()), m_ahead(m_count),
          m_fewest(m_count * m_count, kUnknown) {
        for (size_t i = 0; i < m_count; ++i)
            for (size_t k = i + 1; k < m_count; ++k)
                if (k == i + 1 || ((IsNotch(i) || IsNotch(k)) && IsCut(i, k)))
                    m_ahead[i].push_back(k);
    }

    size_t Pieces() { return Fewest(0, m_count - 1); }

private:
    static constexpr size_t kUnknown = SIZE_MAX, kNever = SIZE_MAX / 4;

    int Turn(size_t a, size_t b, size_t c) const {
        return exact::Orientation(m_corners[a], m_corners[b], m_corners[c]);
    }

    bool IsNotch(size_t i) const { return Turn((i + m_count - 1) % m_count, i, (i + 1) % m_count) < 0; }

    /// Left, or straight on.
    bool IsConvex(size_t a, size_t b, size_t c) const {
        const int turn = Turn(a, b, c);
        return turn > 0 ||
               (turn == 0 && Before(m_corners[a], m_corners[b]) == Before(m_corners[b], m_corners[c]));
    }

    /// Does the way from i to k begin inside of the corner i?
    bool BeginsInside(size_t i, size_t k) const {
        const size_t next = (i + 1) % m_count, before = (i + m_count - 1) % m_count;
        const bool left_of_next = Turn(i, next, k) > 0, right_of_before = Turn(i, before, k) < 0;
        return Turn(before, i, next) > 0 ? left_of_next && right_of_before : left_of_next || right_of_before;
    }

    /// Of three on one line.
    bool IsBetween(size_t a, size_t b, size_t c) const {
        return Before(m_corners[a], m_corners[b]) == Before(m_corners[b], m_corners[c]);
    }

    /// Is the open segment in the open inside?
    bool IsCut(size_t i, size_t k) const {
        if ((k + 1) % m_count == i || !BeginsInside(i, k) || !BeginsInside(k, i))
            return false;
        for (size_t a = 0; a < m_count; ++a) {
            const size_t b = (a + 1) % m_count;
            if (a == i || a == k || b == i || b == k)
                continue;
            const int side_a = Turn(i, k, a), side_b = Turn(i, k, b);
            if (side_a == 0 && side_b == 0 ? IsBetween(i, a, k) || IsBetween(i, b, k) || IsBetween(a, i, b)
                                           : side_a * side_b <= 0 && Turn(a, b, i) * Turn(a, b, k) <= 0)
                return false;
        }
        return true;
    }

    /// Of the part i, i + 1, .., k: the piece beside the segment is a chain from i to k.
    size_t Fewest(size_t i, size_t k) {
        size_t &known = m_fewest[i * m_count + k];
        if (known != kUnknown)
            return known;
        size_t fewest = kNever;
        for (const size_t first : m_ahead[i])
            if (first < k && IsConvex(k, i, first))
                fewest = std::min(fewest, ByChain(i, first, k, fewest));
        return m_fewest[i * m_count + k] = fewest;
    }

    size_t Beside(size_t a, size_t b) { return b == a + 1 ? 0 : Fewest(a, b); }

    /// Of chains that begin with one link, the fewest, if that is less than `limit`.
    size_t ByChain(size_t i, size_t first, size_t k, size_t limit) {
        std::vector<std::vector<std::pair<size_t, size_t>>> reached(m_count); // from where, at what cost
        reached[first].emplace_back(i, Beside(i, first));
        size_t least = limit;
        for (size_t a = first; a < k; ++a) {
            if (reached[a].empty())
                continue;
            for (const size_t b : m_ahead[a]) {
                size_t cost = kNever;
                for (const auto &[from, before] : reached[a])
                    if (before < cost && before + 1 < least && IsConvex(from, a, b))
                        cost = before;
                if (b > k || cost + 1 >= least || (b == k && !IsConvex(a, k, i)))
                    continue;
                cost += Beside(a, b);
                if (b == k)
                    least = std::min(least, cost + 1);
                else
                    reached[b].emplace_back(a, cost);
            }
        }
        return std::min(least, kNever);
    }

    std::vector<bmr_vec2> m_corners;
    size_t m_count;
    std::vector<std::vector<size_t>> m_ahead;
    std::vector<size_t> m_fewest;
};

} // namespace outlines

#endif
