// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_EVENT_TABLES_H
#define BOOMERANG_TESTBED_EVENT_TABLES_H

#include <cmath>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "theory/course.h"

/// @file
/// Every motion with every structure, and tables of what happened.

namespace testbed {

/// What is to be run: every motion with every structure that takes it, at every ratio, for every seed.
struct Experiment {
    std::vector<bmr_family> motions;
    std::vector<const bmr_kds_info *> structures;
    size_t n = 64;
    bmr_ngon ngons[2] = {BMR_NGON_ELLIPSE, BMR_NGON_DISC};
    bool point = false;         ///< B is a point
    std::vector<double> ratios; ///< D/sigma, ascending
    std::vector<uint64_t> seeds;
    bool audit = false;
    bool optimum = true;
    /// Called for every course after its runs.
    std::function<void(const Course &course, const std::string &motion, size_t ratioIndex, uint64_t seed)>
        onCourse;
};

/// One run of one structure.
struct Run {
    std::string motion;
    const bmr_kds_info *structure = nullptr;
    size_t n = 0;
    double ratio = 0.0;       ///< D/sigma as measured
    double wantedRatio = 0.0; ///< as asked for
    size_t ratioIndex = 0;
    uint64_t seed = 0;
    bool rigid = false, convex = false;
    bmr_run outcome = {};
    std::optional<bmr_optimum> optimum; ///< the best offline cover of this course
};

/// Called before each run.
using ExperimentProgress = std::function<void(const std::string &what, size_t done, size_t total)>;

/// Runs it all.
std::vector<Run> Perform(const Experiment &experiment, const ExperimentProgress &progress);

/// What a table counts of each run: certificates that failed, or separating lines that were replaced by
/// others.
using Count = double (*)(const Run &run);
double EventsOf(const Run &run);
double LinesOf(const Run &run);

/// The mean over seeds of one motion, structure and ratio; nothing where it did not run.
std::optional<double> MeanOver(const std::vector<Run> &runs, const std::string &motion,
                               const bmr_kds_info *structure, size_t ratioIndex, Count count = EventsOf);

/// The mean size of the offline optimum's covers (the lower bound) of one motion and ratio.
std::optional<double> MeanOptimum(const std::vector<Run> &runs, const std::string &motion, size_t ratioIndex);

/// Lines that a structure replaced over those that the optimum replaces, the first line of either not
/// counted; where the optimum never replaces any, it counts as one. Means over seeds first, then the
/// geometric mean over the motions; nothing where the structure misses a motion.
std::optional<double> OverOptimum(const std::vector<Run> &runs, const bmr_kds_info *structure,
                                  size_t ratioIndex);

/// What the paper's table says of the number of events, as a power of D/sigma, while n is larger than its
/// square root: "log", "1/2", "1/2 log" (compass hierarchies), "1" or "1 log2"; empty: nothing.
std::string BoundFor(const bmr_kds_info &structure, bool rigid, bool convex);

/// How the number of events grew with D/sigma, and what the paper's bound is.
struct Growth {
    bmr_growth fit = {};
    std::string bound;
};
/// "0.47 <1/2", or "+0.6 <log" for events per doubling.
std::string TextOf(const Growth &growth);
/// Nothing where there are fewer than three ratios with events.
std::optional<Growth> GrowthOf(const std::vector<Run> &runs, const std::string &motion,
                               const bmr_kds_info *structure);

/// The four qualities of a kinetic structure over many runs: the most of what is compact and local, the mean
/// of what is responsive and efficient.
struct QualitySummary {
    bmr_qualities qualities = {};
    double rho = INFINITY; ///< hysteresis: the least change from event to event over the distance
};
QualitySummary QualitiesOver(const std::vector<Run> &runs, const bmr_kds_info *structure);

/// The motions and structures of the runs, each once, in the order they first come in.
std::vector<std::string> MotionsOf(const std::vector<Run> &runs);
std::vector<const bmr_kds_info *> StructuresOf(const std::vector<Run> &runs);

/// A line of headings, and one for each run. What a run does not have, or has as no finite number, is empty.
void WriteCsv(std::ostream &out, const std::vector<Run> &runs);

} // namespace testbed

#endif
