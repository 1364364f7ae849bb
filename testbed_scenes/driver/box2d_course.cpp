// SPDX-License-Identifier: MIT

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <stdexcept>
#include <string>

#include <sys/mman.h>
#include <unistd.h>

#include "theory/course.h"
#include "workers.h"

namespace testbed {
namespace {

/// The least separation in Box2D's metres: ten times the two skins, so that the solver never moves a body.
constexpr double kLeastGap = 0.2;
/// Box2D moves a body by at most 2 metres and half a turn a step; at a tenth of that it resolves the course.
constexpr double kMetresPerStep = 0.2, kRadiansPerStep = 0.1;
constexpr int kMostSteps = 20000, kFewestSteps = 60;
constexpr double kTimeStep = 1.0 / 60.0;
/// Poses looked at to tell how long the way is.
constexpr int kProbes = 4096;

bmr_pose PoseOf(const Course &course, int body, double part) {
    return bmr_motion_pose(course.Motion(body), part, nullptr, nullptr);
}

double TurnBetween(const bmr_pose &from, const bmr_pose &to) {
    return std::atan2(from.c * to.s - from.s * to.c, from.c * to.c + from.s * to.s);
}

int StepsFor(const Course &course, double scale) {
    double way = 0.0, turn = 0.0;
    for (int body = 0; body < 2; ++body) {
        bmr_pose last = PoseOf(course, body, 0.0);
        for (int i = 1; i <= kProbes; ++i) {
            const bmr_pose now = PoseOf(course, body, static_cast<double>(i) / kProbes);
            way += scale * std::hypot(now.position.x - last.position.x, now.position.y - last.position.y);
            turn += std::fabs(TurnBetween(last, now));
            last = now;
        }
    }
    const double steps = std::max(way / kMetresPerStep, turn / kRadiansPerStep);
    return static_cast<int>(
        std::clamp(steps, static_cast<double>(kFewestSteps), static_cast<double>(kMostSteps)));
}

void WriteCourse(const Course &course, double scale, int steps, const std::string &path) {
    std::ofstream out(path);
    out << std::setprecision(9) << "course " << steps << ' ' << kTimeStep << '\n';
    for (int body = 0; body < 2; ++body) {
        const std::vector<bmr_vec2> vertices = course.BodyOf(body).Vertices();
        out << "polygon " << vertices.size();
        for (const bmr_vec2 &vertex : vertices)
            out << ' ' << scale * vertex.x << ' ' << scale * vertex.y;
        out << '\n';
    }
    double angles[2] = {};
    bmr_pose last[2];
    for (int step = 0; step <= steps; ++step) {
        for (int body = 0; body < 2; ++body) {
            const bmr_pose pose = PoseOf(course, body, static_cast<double>(step) / steps);
            angles[body] =
                step == 0 ? std::atan2(pose.s, pose.c) : angles[body] + TurnBetween(last[body], pose);
            last[body] = pose;
            out << scale * pose.position.x << ' ' << scale * pose.position.y << ' ' << angles[body]
                << (body == 0 ? ' ' : '\n');
        }
    }
    if (!out.flush())
        throw std::runtime_error("writing " + path + " failed");
}

} // namespace

Box2DCalls RunInBox2D(const Course &course, const Workers &workers) {
    if (course.BodyOf(0).Polygon()->count < 3 || course.BodyOf(1).Polygon()->count < 3)
        throw std::runtime_error("Box2D has no body that is a point");
    if (!workers.CanCount())
        throw WorkerError("the counting library is missing: build boomerang-count");
    const double scale = std::max(1.0, kLeastGap / course.Separation());
    // A file without a place, which the workers have open, too.
    const int file = memfd_create("course", 0);
    WorkerRequest request;
    request.course = "/dev/fd/" + std::to_string(file);
    request.mode = "count";
    request.steps = StepsFor(course, scale);
    WriteCourse(course, scale, static_cast<int>(request.steps), request.course);

    Box2DCalls calls = {};
    for (size_t i = 0; i < 2; ++i) {
        request.side = i == 0 ? Side::Stock : Side::Plugin;
        const nlohmann::json summary = workers.Run(request, {});
        if (i == 0)
            calls[0] = summary.at("steps").get<double>();
        size_t place = 1 + 3 * i;
        for (const char *count : {"polygon_tests", "toi_calls", "distance_calls"})
            calls[place++] = summary.at(count).get<double>();
        for (const char *kind : {"push", "stab", "roll", "contact", "leave"})
            if (i == 1)
                calls[7] += summary.at("plugin").at("events").at(kind).get<double>();
    }
    close(file);
    return calls;
}

} // namespace testbed
