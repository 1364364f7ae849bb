// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_BAD_INPUT_BAD_POSES_H
#define BOOMERANG_TEST_BAD_INPUT_BAD_POSES_H

#include <string>
#include <vector>

#include "arguments.h"
#include "boomerang/pose.h"

/// @file
/// The rows of both tables of poses: a good one, and what is wrong with the others.

namespace bad_input {

struct BadPose {
    const char *name;
    bmr_pose pose;
};
inline const BadPose kPoses[] = {
    {"5 to the right (a good one)", {{5, 0}, 1, 0}},
    {"x is NaN", {{kNone, 0}, 1, 0}},
    {"y is NaN", {{5, kNone}, 1, 0}},
    {"x is infinite", {{kInfinite, 0}, 1, 0}},
    {"y is minus infinity", {{5, -kInfinite}, 1, 0}},
    {"x is 1e38", {{1e38, 0}, 1, 0}},
    {"x is 1e308", {{1e308, 0}, 1, 0}},
    {"x is 5 and y 1e-38", {{5, 1e-38}, 1, 0}},
    {"the cosine is NaN", {{5, 0}, kNone, 0}},
    {"the sine is infinite", {{5, 0}, 1, kInfinite}},
    {"the rotation is 0", {{5, 0}, 0, 0}},
    {"the rotation is 1 % too long", {{5, 0}, 1.01, 0}},
    {"the rotation is twice too long", {{5, 0}, 2, 0}},
    {"the rotation is 1e38", {{5, 0}, 1e38, 0}},
};

inline std::vector<std::string> PoseNames() {
    std::vector<std::string> names;
    for (const BadPose &pose : kPoses)
        names.emplace_back(pose.name);
    return names;
}

} // namespace bad_input

#endif
