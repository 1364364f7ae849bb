// SPDX-License-Identifier: MIT
#include <boomerang/box2d.h>

#include "debug/statistics.h"
#include "program.h"

namespace threads {

const std::vector<Chosen> &ScenesOfThePlugin() {
    static const std::vector<Chosen> scenes = {{"any-gas", 12, 64},           {"any-gas", 12, 64},
                                               {"any-bag", 20, 24},           {"any-bag", 20, 24},
                                               {"any-bullets", 8, 20},        {"any-bullets", 8, 20},
                                               {"any-wheels", 4, 9},          {"any-wheels", 4, 9},
                                               {"asteroids-outline", 12, 24}, {"asteroids-outline", 12, 24}};
    return scenes;
}

bool Install(bool counting) {
    bmr::Options options;
    options.statistics = counting;
    return bmr::Install(options);
}

bool IsInstalled() {
    return bmr::IsInstalled();
}

bool StatisticsReader::Read() {
    const bmr::Counted s = bmr::internal::ReadCounts();
    const bool forward = s.steps >= steps && s.evaluations >= evaluations && s.differences == 0;
    steps = s.steps;
    evaluations = s.evaluations;
    return forward;
}

} // namespace threads
