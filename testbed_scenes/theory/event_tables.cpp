// SPDX-License-Identifier: MIT
#include "theory/event_tables.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <memory>

namespace testbed {
namespace {

std::vector<bmr_vec2> PointsOf(bmr_ngon kind, size_t n, uint64_t seed) {
    std::vector<bmr_vec2> points(n);
    Require(bmr_ngon_points(kind, n, seed, points.data()), bmr_ngon_name(kind));
    return points;
}

/// One of the two bodies of an experiment, for a seed.
std::shared_ptr<const Body> MakeBody(const Experiment &experiment, int index, uint64_t seed) {
    if (index == 1 && experiment.point)
        return std::make_shared<Body>(std::vector<bmr_vec2>{{0.0, 0.0}});
    return std::make_shared<Body>(
        PointsOf(experiment.ngons[index], experiment.n, 2 * seed + static_cast<uint64_t>(index)));
}

/// Twice as fine changes the bounds by less than the seeds do.
constexpr double kOptimumResolution = 0.02;

/// What all runs on a course have in common.
void Describe(const Course &course, bool optimum, Run *common) {
    common->rigid = course.IsRigid();
    common->convex = course.IsConvex();
    common->n = course.BodyOf(0).Polygon()->count;
    common->ratio = course.Diameter() / course.Separation();
    if (!optimum)
        return;
    const bmr_course followed = course.AsCourse();
    common->optimum.emplace();
    Require(bmr_offline_optimum(&followed, DefFor(course).margin, kOptimumResolution, nullptr, 0,
                                &*common->optimum),
            "the offline optimum");
}

} // namespace

std::vector<Run> Perform(const Experiment &experiment, const ExperimentProgress &progress) {
    struct Job {
        size_t motion, ratio;
        uint64_t seed;
    };
    std::vector<Job> jobs;
    for (size_t motion = 0; motion < experiment.motions.size(); ++motion)
        for (size_t ratio = 0; ratio < experiment.ratios.size(); ++ratio)
            for (const uint64_t seed : experiment.seeds)
                jobs.push_back({motion, ratio, seed});

    std::vector<Run> runs;
    const size_t total = jobs.size() * experiment.structures.size();
    size_t done = 0;
    for (const Job &job : jobs) {
        const auto a = MakeBody(experiment, 0, job.seed), b = MakeBody(experiment, 1, job.seed);
        Run common;
        common.seed = job.seed;
        common.ratioIndex = job.ratio;
        common.wantedRatio = experiment.ratios[job.ratio];
        const bmr_family family = experiment.motions[job.motion];
        common.motion = bmr_family_name(family);
        progress(common.motion, done, total);
        const Course course(a, b, bmr_family_def{family, experiment.ratios[job.ratio], job.seed, 0, 0});
        Describe(course, experiment.optimum, &common);
        for (const bmr_kds_info *structure : experiment.structures) {
            progress(common.motion + ", " + structure->name, done++, total);
            if (!Takes(*structure, course))
                continue;
            Run run = common;
            run.structure = structure;
            run.outcome = Follow(course, *structure, DefFor(course), experiment.audit);
            runs.push_back(std::move(run));
        }
        if (experiment.onCourse)
            experiment.onCourse(course, common.motion, job.ratio, job.seed);
    }
    return runs;
}

double EventsOf(const Run &run) {
    return static_cast<double>(run.outcome.events);
}

double LinesOf(const Run &run) {
    return static_cast<double>(run.outcome.lines);
}

std::optional<double> MeanOver(const std::vector<Run> &runs, const std::string &motion,
                               const bmr_kds_info *structure, size_t ratioIndex, Count count) {
    double sum = 0.0;
    int found = 0;
    for (const Run &run : runs)
        if (run.motion == motion && run.structure == structure && run.ratioIndex == ratioIndex) {
            sum += count(run);
            ++found;
        }
    if (found == 0)
        return std::nullopt;
    return sum / found;
}

std::optional<double> MeanOptimum(const std::vector<Run> &runs, const std::string &motion,
                                  size_t ratioIndex) {
    // Every structure of a course carries the same optimum: one of them is enough.
    if (runs.front().optimum)
        for (const bmr_kds_info *structure : StructuresOf(runs))
            if (const auto mean = MeanOver(runs, motion, structure, ratioIndex, [](const Run &run) {
                    return static_cast<double>(run.optimum->least);
                }))
                return mean;
    return std::nullopt;
}

std::optional<double> OverOptimum(const std::vector<Run> &runs, const bmr_kds_info *structure,
                                  size_t ratioIndex) {
    double logs = 0.0;
    int count = 0;
    for (const std::string &motion : MotionsOf(runs)) {
        const std::optional<double> lines = MeanOver(runs, motion, structure, ratioIndex, LinesOf),
                                    optimum = MeanOptimum(runs, motion, ratioIndex);
        if (!lines || !optimum)
            return std::nullopt;
        logs += std::log(std::max(1.0, *lines) / std::max(1.0, *optimum - 1.0));
        ++count;
    }
    if (count == 0)
        return std::nullopt;
    return std::exp(logs / count);
}

std::string BoundFor(const bmr_kds_info &structure, bool rigid, bool convex) {
    if (structure.role == BMR_KDS_RIVAL)
        return "";
    const std::string factor = structure.hierarchy == BMR_HIERARCHY_COMPASS ? " log" : "";
    const bool point = structure.domain == BMR_KDS_POINT;
    if (!point && rigid)
        return "1" + factor + (factor.empty() ? "" : "2");
    // Table 1: on convex paths the Dudley hierarchies of two polygons may cost the square root.
    if (convex && (point || structure.hierarchy != BMR_HIERARCHY_DUDLEY))
        return "log";
    return "1/2" + factor;
}

std::optional<Growth> GrowthOf(const std::vector<Run> &runs, const std::string &motion,
                               const bmr_kds_info *structure) {
    std::vector<double> ratios, values;
    Growth growth;
    for (const Run &run : runs)
        if (run.motion == motion && run.structure == structure) {
            ratios.push_back(run.ratio);
            values.push_back(EventsOf(run));
            growth.bound = BoundFor(*structure, run.rigid, run.convex);
        }
    std::vector<double> different = ratios;
    std::sort(different.begin(), different.end());
    // Ratios are as measured: seeds differ a little.
    const auto isNear = [](double a, double b) { return b < 1.5 * a; };
    different.erase(std::unique(different.begin(), different.end(), isNear), different.end());
    if (different.size() < 3 ||
        bmr_fit_growth(ratios.data(), values.data(), ratios.size(), &growth.fit) != BMR_OK)
        return std::nullopt;
    return growth;
}

std::string TextOf(const Growth &growth) {
    char number[32];
    if (growth.bound == "log")
        std::snprintf(number, sizeof number, "+%.1f", growth.fit.slope);
    else
        std::snprintf(number, sizeof number, "%.2f", growth.fit.exponent);
    return number + (growth.bound.empty() ? "" : " <" + growth.bound);
}

QualitySummary QualitiesOver(const std::vector<Run> &runs, const bmr_kds_info *structure) {
    QualitySummary summary;
    bmr_qualities &all = summary.qualities;
    int count = 0;
    for (const Run &run : runs) {
        if (run.structure != structure)
            continue;
        const bmr_qualities &its = run.outcome.qualities;
        all.conditions = std::max(all.conditions, its.conditions);
        all.bytes = std::max(all.bytes, its.bytes);
        all.touched += its.touched;
        all.touched_most = std::max(all.touched_most, its.touched_most);
        all.replanned = std::max(all.replanned, its.replanned);
        all.efficiency += its.efficiency;
        summary.rho = std::min(summary.rho, run.outcome.hysteresis.both);
        ++count;
    }
    all.touched /= std::max(count, 1);
    all.efficiency /= std::max(count, 1);
    return summary;
}

namespace {

/// What the runs have as a member, each once, in the order in which it first comes.
template <typename T> std::vector<T> Distinct(const std::vector<Run> &runs, T Run::*member) {
    std::vector<T> found;
    for (const Run &run : runs)
        if (std::find(found.begin(), found.end(), run.*member) == found.end())
            found.push_back(run.*member);
    return found;
}

} // namespace

std::vector<std::string> MotionsOf(const std::vector<Run> &runs) {
    return Distinct(runs, &Run::motion);
}

std::vector<const bmr_kds_info *> StructuresOf(const std::vector<Run> &runs) {
    return Distinct(runs, &Run::structure);
}

void WriteCsv(std::ostream &out, const std::vector<Run> &runs) {
    constexpr int kDigits = 9;
    out << "motion,structure,n,ratio,seed,events,lines,touched,failure_times,external,conditions,"
           "bytes,hysteresis,optimum,wanted_ratio";
    for (int kind = 0; kind < BMR_KDS_NONE; ++kind)
        out << ',' << bmr_kds_event_name(static_cast<bmr_kds_event_kind>(kind));
    out << '\n' << std::setprecision(kDigits);
    for (const Run &run : runs) {
        const bmr_simulation_counts &counts = run.outcome.counts;
        out << run.motion << ',' << run.structure->name << ',' << run.n << ',' << run.ratio << ',' << run.seed
            << ',' << run.outcome.events << ',' << run.outcome.lines << ',' << counts.touched << ','
            << counts.failure_times << ',' << counts.external << ',' << counts.conditions << ','
            << counts.bytes << ',';
        if (std::isfinite(run.outcome.hysteresis.both))
            out << run.outcome.hysteresis.both;
        out << ',';
        if (run.optimum)
            out << run.optimum->least;
        out << ',' << run.wantedRatio;
        for (int kind = 0; kind < BMR_KDS_NONE; ++kind)
            out << ',' << counts.events[kind];
        out << '\n';
    }
}

} // namespace testbed
