// SPDX-License-Identifier: MIT
#include "theory/event_tables.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace testbed {
namespace {

std::vector<bmr_vec2> OutlinePoints(bmr_ngon outline, size_t n, uint64_t seed) {
    std::vector<bmr_vec2> points(n);
    Require(bmr_ngon_points(outline, n, seed, points.data()), "the outline");
    return points;
}

/// One of the two bodies of an experiment, for a seed.
std::shared_ptr<const Body> MakeBody(const Experiment &experiment, int index, uint64_t seed) {
    if (index == 1 && experiment.point)
        return std::make_shared<Body>(std::vector<bmr_vec2>{{0.0, 0.0}});
    const std::vector<std::string> &files = experiment.polygonFiles;
    if (!files.empty())
        return std::make_shared<Body>(ReadPolygonFile(index == 0 ? files.front() : files.back()));
    return std::make_shared<Body>(
        OutlinePoints(experiment.outlines[index], experiment.n, 2 * seed + static_cast<uint64_t>(index)));
}

/// Twice as fine changes the bounds by less than the seeds do.
constexpr double kOptimumResolution = 0.02;

/// What all runs on a course have in common.
void Describe(const Course &course, bool optimum, Run *common) {
    common->rigid = course.IsRigid();
    common->convex = course.IsConvex();
    common->n = course.BodyOf(0).Polygon()->count;
    common->ratio = course.Separation() > 0.0 ? course.Diameter() / course.Separation() : INFINITY;
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
    const bool ownMotion = !experiment.motionFile.empty();
    std::vector<Job> jobs;
    if (ownMotion)
        jobs.push_back({0, 0, 0});
    else
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
        common.wantedRatio = ownMotion ? 0.0 : experiment.ratios[job.ratio];
        std::unique_ptr<Course> course;
        if (ownMotion) {
            common.motion = experiment.motionFile;
            course = std::make_unique<Course>(a, b, ReadMotionFile(experiment.motionFile));
        } else {
            const bmr_family family = experiment.motions[job.motion];
            common.motion = bmr_family_name(family);
            progress(common.motion, done, total);
            course = std::make_unique<Course>(
                a, b, bmr_family_def{family, experiment.ratios[job.ratio], job.seed, 0, 0});
        }
        Describe(*course, experiment.optimum, &common);
        for (const bmr_kds_info *structure : experiment.structures) {
            progress(common.motion + ", " + structure->name, done++, total);
            if (!Takes(*structure, *course))
                continue;
            Run run = common;
            run.structure = structure;
            run.outcome = Follow(*course, *structure, DefFor(*course), experiment.audit);
            runs.push_back(std::move(run));
        }
        if (experiment.onCourse)
            experiment.onCourse(*course, common.motion, job.ratio, job.seed);
    }
    return runs;
}

} // namespace testbed
