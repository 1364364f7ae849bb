// SPDX-License-Identifier: MIT
#include "worker/options.h"

#include <algorithm>
#include <cfloat>
#include <chrono>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <map>
#include <stdexcept>

#include <dlfcn.h>

#include "count/count.h"
#include "state/snapshot.h"

namespace testbed {
namespace {

/// Calls since the process began, by name; none where the counting library is not preloaded.
std::map<std::string, uint64_t> ReadCounts() {
    const auto read =
        reinterpret_cast<decltype(&boomerang_count_read)>(dlsym(RTLD_DEFAULT, "boomerang_count_read"));
    if (read == nullptr)
        return {};
    boomerang_counts counts = {};
    read(&counts);
    return {{"polygon_tests", counts.polygon_tests},
            {"polygon_tests_apart", counts.polygon_tests_apart},
            {"toi_calls", counts.toi_calls},
            {"distance_calls", counts.distance_calls}};
}

/// Gathers, step by step, what the last line of a run says.
class Summary {
public:
    Summary(const SceneInfo &info, const Options &options) : m_info(info), m_options(options) {}

    void AddStep(const b2World &world, long nanoseconds) {
        ++m_steps;
        m_contacts += world.GetContactCount();
        m_nanoseconds += nanoseconds;
        m_collide += static_cast<double>(world.GetProfile().collide);
    }
    void AddHashes(const StateHashes &hashes) {
        m_hash.Field("bodies", hashes.bodies);
        m_hash.Field("contacts", hashes.contacts);
        m_hash.Field("events", hashes.events);
    }

    /// In every mode: scene, program, size, seed, steps (done), bodies, contacts (mean per step). Hash: hash.
    /// Time: step_ns_total, collide_ms_total. Count: those of ReadCounts, if any; plugin (null for stock).
    /// Scenes with polygons to choose: vertices, kind.
    nlohmann::json ToJson(const b2World &world) const;

private:
    const SceneInfo &m_info;
    const Options &m_options;
    long m_steps = 0;
    long m_contacts = 0;
    HashSink m_hash;
    long m_nanoseconds = 0;
    double m_collide = 0.0; ///< of Box2D's profile, in milliseconds
    /// The plugin makes some calls when it is installed.
    const std::map<std::string, uint64_t> m_callsBefore = ReadCounts();
};

nlohmann::json Summary::ToJson(const b2World &world) const {
    const double steps = static_cast<double>(std::max(m_steps, 1L));
    nlohmann::json json = {{"scene", m_info.name},
                           {"program", PluginName()},
                           {"size", m_options.size.value_or(m_info.size)},
                           {"seed", m_options.seed.value_or(kSeed)},
                           {"steps", m_steps},
                           {"bodies", world.GetBodyCount()},
                           {"contacts", static_cast<double>(m_contacts) / steps}};
    if (const PolygonChoice polygons = PolygonsOf(m_info, m_options); polygons.vertices > 0) {
        json["vertices"] = polygons.vertices;
        json["kind"] = NameOf(polygons.bodies);
    }
    switch (m_options.mode) {
    case Mode::Hash: {
        char text[17];
        std::snprintf(text, sizeof text, "%016" PRIx64, m_hash.Value());
        json["hash"] = text;
        break;
    }
    case Mode::Count:
        for (const auto &[name, calls] : ReadCounts())
            json[name] = calls - m_callsBefore.at(name);
        json["plugin"] = PluginStatistics();
        break;
    case Mode::Time:
        json["step_ns_total"] = m_nanoseconds;
        json["collide_ms_total"] = m_collide;
        break;
    }
    return json;
}

/// A number for a contact and a step that hangs on no address: what the listener does, hangs on it.
uint32_t Mix(b2Contact &contact, int step) {
    uint32_t mixed = static_cast<uint32_t>(step);
    for (const b2Fixture *fixture : {contact.GetFixtureA(), contact.GetFixtureB()})
        mixed = (mixed * 31u + NumberOf(*fixture->GetBody())) * 31u + NumberOf(*fixture);
    // The multiplier of Knuth's multiplicative hashing; the low bits are the poorest, so they go.
    return mixed * 2654435761u >> 8;
}

double SumOf(const b2Vec2 &v) {
    return static_cast<double>(v.x) + static_cast<double>(v.y);
}

double SumOf(const b2Manifold &manifold) {
    if (manifold.pointCount == 0)
        return 0.0; // the rest was perhaps never written
    double sum =
        static_cast<double>(manifold.type) + SumOf(manifold.localNormal) + SumOf(manifold.localPoint);
    for (int i = 0; i < manifold.pointCount; ++i)
        sum += SumOf(manifold.points[i].localPoint) + static_cast<double>(manifold.points[i].normalImpulse) +
               static_cast<double>(manifold.points[i].tangentImpulse) + manifold.points[i].id.key;
    return sum;
}

void Push(b2Body *body) {
    if (body->GetType() == b2_dynamicBody)
        body->ApplyLinearImpulse({0.0f, 0.2f * body->GetMass()}, body->GetPosition(), true);
}

/// A scene with a listener: all that the scene does, and what the listener does ahead of it.
class ListenedScene final : public Scene {
public:
    ListenedScene(Scene &scene, Listening listening) : m_scene(scene), m_listening(listening) {}

    /// Calls of each kind, and the sum of all numbers that were read.
    nlohmann::json ToJson() const {
        return {{"begins", m_begins},
                {"ends", m_ends},
                {"pre_solves", m_preSolves},
                {"post_solves", m_postSolves},
                {"read", m_read}};
    }

private:
    void Build(Stage &stage, int size) override { m_scene.Build(stage, size); }
    void BeforeStep(Stage &stage, int step) override {
        m_step = step;
        m_scene.BeforeStep(stage, step);
    }
    bool Listens() const override { return true; }
    void OnBegin(b2Contact &contact) override {
        ++m_begins;
        if (Reads())
            Read(contact);
        if (Acts() && Mix(contact, m_step) % 4 == 0)
            Push(contact.GetFixtureB()->GetBody());
        m_scene.OnBegin(contact);
    }
    void OnEnd(b2Contact &contact) override {
        ++m_ends;
        if (Reads())
            Read(contact);
        m_scene.OnEnd(contact);
    }
    void OnPreSolve(b2Contact &contact, const b2Manifold &old) override {
        ++m_preSolves;
        if (Reads()) {
            Read(contact);
            m_read += SumOf(old);
        }
        if (Acts()) {
            const uint32_t mixed = Mix(contact, m_step);
            if (mixed % 16 == 0)
                contact.SetEnabled(false);
            else if (mixed % 16 == 1)
                contact.SetFriction(0.1f * static_cast<float>(mixed % 7));
        }
        m_scene.OnPreSolve(contact, old);
    }
    void OnPostSolve(b2Contact &contact, const b2ContactImpulse &impulse) override {
        ++m_postSolves;
        if (Reads()) {
            Read(contact);
            for (int i = 0; i < impulse.count; ++i)
                m_read += static_cast<double>(impulse.normalImpulses[i]) +
                          static_cast<double>(impulse.tangentImpulses[i]);
        }
        if (Acts() && Mix(contact, m_step) % 64 == 0)
            Push(contact.GetFixtureA()->GetBody());
        m_scene.OnPostSolve(contact, impulse);
    }

    bool Reads() const { return m_listening >= Listening::Reads; }
    bool Acts() const { return m_listening == Listening::Acts; }
    void Read(b2Contact &contact) {
        m_read += SumOf(*contact.GetManifold()) + static_cast<double>(contact.GetFriction()) +
                  (contact.IsTouching() ? 1.0 : 0.0) + (contact.IsEnabled() ? 1.0 : 0.0);
        for (b2Fixture *fixture : {contact.GetFixtureA(), contact.GetFixtureB()}) {
            const b2Body &body = *fixture->GetBody();
            m_read += SumOf(body.GetPosition()) + static_cast<double>(body.GetAngle()) +
                      SumOf(body.GetLinearVelocity()) + static_cast<double>(body.GetAngularVelocity());
        }
    }

    Scene &m_scene;
    const Listening m_listening;
    int m_step = -1;
    long m_begins = 0, m_ends = 0, m_preSolves = 0, m_postSolves = 0;
    double m_read = 0.0;
};

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
    world.Step(info.timeStep, 8, 3);
    return static_cast<long>(std::chrono::nanoseconds(Clock::now() - start).count());
}

} // namespace

void RunScene(const SceneInfo &info, const Options &options) {
    std::optional<FrameMaker> frames;
    if (options.frames)
        frames.emplace(*options.frames, info.name);
    InstallPlugin(options.structure, options.mode == Mode::Count, frames ? &*frames : nullptr);
    EventRecorder recorder;
    const std::unique_ptr<Scene> played = info.create();
    ListenedScene listened(*played, options.listening);
    Scene &scene = options.listening == Listening::None ? *played : listened;
    const unsigned long seed = options.seed.value_or(kSeed);
    Stage stage(scene, seed, options.mode == Mode::Hash ? &recorder : nullptr);
    stage.SetPolygons(PolygonsOf(info, options));
    b2World &world = stage.World();
    const int steps = options.steps.value_or(info.steps);
    Summary summary(info, options);

    recorder.StartStep(options.dump == 0);
    scene.Build(stage, options.size.value_or(info.size));
    if (seed != kSeed)
        Shake(stage);
    for (int step = 0; step < steps; ++step) {
        scene.BeforeStep(stage, step);
        if (frames)
            frames->BeginStep(step);
        const long nanoseconds = TimeStep(info, world);
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
        json["listener"] = listened.ToJson();
    std::printf("summary %s\n", json.dump().c_str());
    if (std::fflush(stdout) != 0)
        throw std::runtime_error("the output could not be written");
}

} // namespace testbed
