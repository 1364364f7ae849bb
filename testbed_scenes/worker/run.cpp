// SPDX-License-Identifier: MIT
#include "worker/options.h"

#include <cfloat>
#include <chrono>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "state/snapshot.h"
#include "worker/frame_maker.h"
#include "worker/listener.h"
#include "worker/summary.h"

namespace testbed {
namespace {

// Often enough that a reader who stops at the first difference need not wait, rare enough to cost nothing.
constexpr int stepsPerFlush = 16;

void PrintHashes(int step, const StateHashes &hashes) {
    std::printf("step %d %016" PRIx64 " %016" PRIx64 " %016" PRIx64 "\n", step, hashes.bodies,
                hashes.contacts, hashes.events);
    if (step % stepsPerFlush == stepsPerFlush - 1)
        std::fflush(stdout);
}

/// The control for comparisons: the least change there is. To the first awake dynamic body, for one that
/// sleeps would be forgotten; after the step, for inside it the change could be rounded away.
void Perturb(b2World &world) {
    b2Body *chosen = nullptr;
    for (b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        if (body->GetType() != b2_dynamicBody)
            continue;
        if (chosen == nullptr || (body->IsAwake() && !chosen->IsAwake()))
            chosen = body;
    }
    if (chosen == nullptr)
        throw std::runtime_error("no dynamic body to perturb");
    const b2Vec2 velocity = chosen->GetLinearVelocity();
    chosen->SetLinearVelocity({std::nextafter(velocity.x, FLT_MAX), velocity.y});
}

/// For the scenes that use no random numbers: with a seed that is not their own they differ a little too.
void Shake(Stage &stage) {
    constexpr float speed = 0.05f, angle = 0.001f;
    for (b2Body *body = stage.World().GetBodyList(); body != nullptr; body = body->GetNext()) {
        if (body->GetType() != b2_dynamicBody)
            continue;
        body->SetTransform(body->GetPosition(), body->GetAngle() + stage.Rng().Uniform(-angle, angle));
        body->SetLinearVelocity(body->GetLinearVelocity() + stage.Rng().Direction(0.0f, speed));
    }
}

long TimeStep(const SceneInfo &info, b2World &world) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    world.Step(info.timeStep, info.velocityIterations, info.positionIterations);
    return static_cast<long>(std::chrono::nanoseconds(Clock::now() - start).count());
}

} // namespace

void RunScene(const SceneInfo &info, const Options &options) {
    std::optional<FrameMaker> frames;
    if (options.frames)
        frames.emplace(*options.frames, info.name);
    InstallPlugin(options.plugin, options.mode == Mode::Count, frames ? &*frames : nullptr);
    EventRecorder recorder;
    EventObserver *const observer = options.mode == Mode::Hash ? &recorder : nullptr;
    const std::unique_ptr<Scene> played = info.create();
    ListenedScene listened(*played, options.listening);
    const bool records = options.listening == Listening::Records;
    Scene &scene = options.listening == Listening::None || records ? *played : listened;
    RecordedWorld recorded;
    const unsigned long seed = options.seed.value_or(info.seed);
    Stage stage(scene, seed, observer);
    stage.SetPolygons(PolygonsOf(info, options));
    b2World &world = stage.World();
    const int steps = options.steps.value_or(info.steps);
    Summary summary(info, options);

    recorder.StartStep(options.dump == 0);
    scene.Build(stage, options.size.value_or(info.size));
    if (seed != info.seed)
        Shake(stage);
    if (records)
        recorded.ListenTo(world);
    for (int step = 0; step < steps; ++step) {
        scene.BeforeStep(stage, step);
        if (frames)
            frames->BeginStep(step);
        const long nanoseconds = TimeStep(info, world);
        if (records)
            recorded.AfterStep();
        if (options.perturb == step)
            Perturb(world);
        summary.AddStep(world, nanoseconds);
        if (frames) {
            if (frames->Range().Has(step)) // whether it could be written is asked at the end
                std::puts(shown::PrintFrame(frames->Take(world)).c_str());
            if (step == frames->Range().last)
                break;
            continue;
        }
        if (options.dump == step) {
            std::fputs(DescribeState(world, recorder).c_str(), stdout);
            break;
        }
        if (options.mode == Mode::Hash) {
            const StateHashes hashes = HashState(world, recorder);
            summary.AddHashes(hashes);
            if (!options.dump)
                PrintHashes(step, hashes);
            recorder.StartStep(options.dump == step + 1);
        }
    }
    nlohmann::json json = summary.ToJson(world);
    if (options.listening != Listening::None)
        json["listener"] = records ? recorded.ToJson() : listened.ToJson();
    std::printf("summary %s\n", json.dump().c_str());
    if (std::fflush(stdout) != 0)
        throw std::runtime_error("the output could not be written");
}

} // namespace testbed
