// SPDX-License-Identifier: MIT
#include "box2d_gas.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>

#include "recorded_run.h"
#include "temporary_file.h"

namespace testbed {
namespace {

constexpr double kSpeed = 10.0, kStep = 1.0 / 60.0;

/// Seconds of Box2D's for a unit of the world's time.
double Slowness(const WorldSetup &setup) {
    return setup.choice.speed / kSpeed;
}

int64_t StepsFor(const WorldSetup &setup, double seconds) {
    return std::max<int64_t>(2, std::llround(seconds / Box2DTimeStep(setup)));
}

void Write(const WorldSetup &setup, const GasMoment &from, int64_t steps, const std::string &path) {
    std::ofstream out(path);
    out << std::setprecision(9) << "gas " << steps << ' ' << kStep << ' ' << setup.bodies.size() << '\n';
    if (setup.choice.boundary == BMR_WALLED)
        out << "box " << setup.low.x << ' ' << setup.low.y << ' ' << setup.high.x << ' ' << setup.high.y
            << '\n';
    else
        out << "open\n";
    const double faster = 1.0 / Slowness(setup);
    for (size_t i = 0; i < setup.bodies.size(); ++i) {
        const std::vector<bmr_vec2> vertices = setup.bodies[i].polygon->Vertices();
        out << "body " << vertices.size();
        for (const bmr_vec2 &vertex : vertices)
            out << ' ' << vertex.x << ' ' << vertex.y;
        const bmr_pose &pose = from.poses[i];
        out << ' ' << pose.position.x << ' ' << pose.position.y << ' ' << std::atan2(pose.s, pose.c) << ' '
            << faster * from.velocities[i].x << ' ' << faster * from.velocities[i].y << ' '
            << faster * from.spins[i] << '\n';
    }
    if (!out.flush())
        throw std::runtime_error("writing " + path + " failed");
}

} // namespace

GasMoment MomentOf(const WorldRun &run, const WorldSetup &setup) {
    GasMoment moment;
    moment.time = run.Time();
    for (size_t i = 0; i < setup.bodies.size(); ++i) {
        const bmr_body_state state = run.StateOf(i);
        moment.poses.push_back(state.pose);
        moment.velocities.push_back(state.velocity);
        moment.spins.push_back(state.spin);
    }
    return moment;
}

double Box2DTimeStep(const WorldSetup &setup) {
    return kStep / Slowness(setup);
}

std::vector<GasContact> FindBegins(const WorldSetup &setup, const GasMoment &from, double seconds,
                                   const Workers &workers) {
    const TemporaryFile file;
    RecordRequest request;
    request.gas = file.Path();
    request.side = Side::Stock;
    request.last = StepsFor(setup, seconds) - 1;
    request.every = request.last; // the second frame has the events of all steps between
    Write(setup, from, request.last + 1, file.Path());
    std::vector<GasContact> begins;
    RunRecorded(workers, request, [&](const recording::Head & /*head*/, const recording::Frame &frame) {
        for (const recording::Event &event : frame.events)
            if (event.kind == "begin")
                begins.push_back({std::min(event.a, event.b), std::max(event.a, event.b),
                                  from.time + static_cast<double>(event.step + 1) * Box2DTimeStep(setup)});
    });
    return begins;
}

Box2DGas RunGas(const WorldSetup &setup, const GasMoment &from, double seconds, const Workers &workers) {
    Box2DGas result;
    result.steps = StepsFor(setup, seconds);
    result.timeStep = Box2DTimeStep(setup);
    const TemporaryFile file;
    Write(setup, from, result.steps, file.Path());
    WorkerRequest request;
    request.gas = file.Path();
    request.steps = result.steps;
    request.mode = "count";
    const nlohmann::json counted = workers.Summarise(request, {}).at("behaviour");
    const double start = counted.at("energy_start").get<double>();
    result.energyChange = (counted.at("energy").get<double>() - start) / start;
    result.mostGain = counted.at("energy_gain").get<double>() / start;
    result.deepest = counted.at("overlap_deepest").get<double>();
    request.mode = "time";
    result.clock = workers.Summarise(request, {}).at("steps_processor_s").get<double>();
    result.begins = FindBegins(setup, from, seconds, workers);
    return result;
}

} // namespace testbed
