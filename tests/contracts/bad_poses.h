// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_CONTRACTS_BAD_POSES_H
#define BOOMERANG_TEST_CONTRACTS_BAD_POSES_H

#include <utility>

#include "boomerang/pose.h"
#include "contracts.h"

namespace contracts {

/// A table of poses: a good one, and what is wrong with the others.
inline Matrix
Poses(std::vector<std::pair<const char *, std::function<std::string(const bmr_pose &)>>> calls) {
    static const std::vector<std::pair<const char *, bmr_pose>> poses = {
        {"5 to the right (a good one)", {{5, 0}, 1, 0}},
        {"x is NaN", {{kNaN, 0}, 1, 0}},
        {"y is NaN", {{5, kNaN}, 1, 0}},
        {"x is infinite", {{kInfinity, 0}, 1, 0}},
        {"y is minus infinity", {{5, -kInfinity}, 1, 0}},
        {"x is 1e38", {{1e38, 0}, 1, 0}},
        {"x is 1e308", {{1e308, 0}, 1, 0}},
        {"x is 5 and y 1e-38", {{5, 1e-38}, 1, 0}},
        {"the cosine is NaN", {{5, 0}, kNaN, 0}},
        {"the sine is infinite", {{5, 0}, 1, kInfinity}},
        {"the rotation is 0", {{5, 0}, 0, 0}},
        {"the rotation is 1 % too long", {{5, 0}, 1.01, 0}},
        {"the rotation is twice too long", {{5, 0}, 2, 0}},
        {"the rotation is 1e38", {{5, 0}, 1e38, 0}},
    };
    Matrix matrix;
    for (const auto &call : calls)
        matrix.columns.emplace_back(call.first);
    for (const auto &pose : poses)
        matrix.rows.emplace_back(pose.first);
    matrix.answer = [calls](size_t row, size_t column) { return calls[column].second(poses[row].second); };
    return matrix;
}

} // namespace contracts

#endif
