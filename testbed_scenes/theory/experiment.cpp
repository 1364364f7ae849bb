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

/// The bodies of an experiment, made once for each seed.
struct Bodies {
    std::shared_ptr<const Body> a, b;
};

Bodies MakeBodies(const Experiment &experiment, uint64_t seed) {
    Bodies bodies;
    const std::vector<std::string> &files = experiment.polygonFiles;
    bodies.a =
        std::make_shared<Body>(files.empty() ? OutlinePoints(experiment.outlines[0], experiment.n, 2 * seed)
                                             : ReadPolygonFile(files.front()));
    if (experiment.point)
        bodies.b = std::make_shared<Body>(std::vector<bmr_vec2>{{0.0, 0.0}});
    else
        bodies.b = std::make_shared<Body>(
            files.empty() ? OutlinePoints(experiment.outlines[1], experiment.n, 2 * seed + 1)
                          : ReadPolygonFile(files.back()));
    return bodies;
}

/// Twice as fine changes the bounds by less than the seeds do.
constexpr double kOptimumResolution = 0.02;

/// Everything that is run on one course.
class CourseRuns {
public:
    CourseRuns(const Experiment &experiment, const Course &course, Run common, std::vector<Run> &runs)
        : m_experiment(experiment), m_course(course), m_common(std::move(common)), m_runs(runs) {
        m_common.rigid = course.IsRigid();
        m_common.convex = course.IsConvex();
        m_common.n = course.BodyOf(0).Polygon()->count;
        if (experiment.optimum) {
            const bmr_course followed = course.AsCourse();
            bmr_optimum optimum = {};
            Require(bmr_offline_optimum(&followed, DefFor(course).margin, kOptimumResolution, nullptr, 0,
                                        &optimum),
                    "the offline optimum");
            m_common.optimum = optimum;
        }
        m_common.ratio = course.Separation() > 0.0 ? course.Diameter() / course.Separation() : INFINITY;
    }

    void Perform(const bmr_kds_info &structure) {
        Run run = m_common;
        run.structure = &structure;
        run.outcome = Follow(m_course, structure, DefFor(m_course), m_experiment.audit);
        m_runs.push_back(std::move(run));
    }

private:
    const Experiment &m_experiment;
    const Course &m_course;
    Run m_common;
    std::vector<Run> &m_runs;
};

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
        const Bodies bodies = MakeBodies(experiment, job.seed);
        Run common;
        common.seed = job.seed;
        common.ratioIndex = job.ratio;
        common.wantedRatio = ownMotion ? 0.0 : experiment.ratios[job.ratio];
        MotionFile file;
        std::unique_ptr<Course> course;
        if (ownMotion) {
            file = ReadMotionFile(experiment.motionFile);
            common.motion = experiment.motionFile;
            course = std::make_unique<Course>(bodies.a, bodies.b, file);
        } else {
            const bmr_family family = experiment.motions[job.motion];
            common.motion = bmr_family_name(family);
            progress(common.motion, done, total);
            course = std::make_unique<Course>(
                bodies.a, bodies.b, bmr_family_def{family, experiment.ratios[job.ratio], job.seed, 0, 0});
        }
        CourseRuns courseRuns(experiment, *course, common, runs);
        for (const bmr_kds_info *structure : experiment.structures) {
            progress(common.motion + ", " + structure->name, done++, total);
            if (Takes(*structure, *course))
                courseRuns.Perform(*structure);
        }
        if (experiment.onCourse)
            experiment.onCourse(*course, common.motion, job.ratio, job.seed);
    }
    return runs;
}

} // namespace testbed
