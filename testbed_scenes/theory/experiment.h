// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_EXPERIMENT_H
#define BOOMERANG_TESTBED_EXPERIMENT_H

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "theory/course.h"

namespace testbed {

/// What is to be run: every motion with every structure that takes it, at every ratio, for every seed.
struct Experiment {
    std::vector<bmr_family> motions;
    std::vector<const bmr_kds_info *> structures;
    size_t n = 64;
    bmr_outline outlines[2] = {BMR_OUTLINE_ELLIPSE, BMR_OUTLINE_DISC};
    bool point = false;         ///< B is a point
    std::vector<double> ratios; ///< D/sigma, ascending
    std::vector<uint64_t> seeds;
    bool audit = false;
    bool optimum = true;
    /// Called for every course after its runs.
    std::function<void(const Course &course, const std::string &motion, size_t ratioIndex, uint64_t seed)>
        onCourse;

    // One's own bodies and motion instead of families and ratios.
    std::vector<std::string> polygonFiles; ///< of A and B; one: both alike
    std::string motionFile;
};

/// One run of one structure.
struct Run {
    std::string motion;
    const bmr_kds_info *structure = nullptr;
    size_t n = 0;
    double ratio = 0.0;       ///< D/sigma as measured; INFINITY where the two are in contact on the way
    double wantedRatio = 0.0; ///< as asked for; 0: a motion of one's own
    size_t ratioIndex = 0;
    uint64_t seed = 0;
    bool rigid = false, convex = false;
    Outcome outcome;
    std::optional<bmr_optimum> optimum; ///< the best offline cover of this course
};

/// Called before each run.
using ExperimentProgress = std::function<void(const std::string &what, size_t done, size_t total)>;

/// Runs it all.
std::vector<Run> Perform(const Experiment &experiment, const ExperimentProgress &progress);

} // namespace testbed

#endif
