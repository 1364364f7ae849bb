// SPDX-License-Identifier: MIT
//
//   differential_stock  FIRST COUNT STEPS [dump SEED STEP | perturb SEED STEP | end SEED STEP]
//   differential_plugin FIRST COUNT STEPS STRUCTURE on|off|told [dump SEED STEP]
//
// Runs the random worlds of COUNT seeds, from FIRST on, and prints a line for every step: seed, step, and for
// each of the seed's worlds (every other seed has two at once) the hashes of bodies, contacts, events and
// probes. `dump` prints the whole state after one step instead, `perturb` changes one velocity by one unit in
// the last place after one step, `end` ends the process there as a failed assertion would: the controls. On
// stderr: how often listeners meddled with impacts.
#include <cfloat>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "plugin.h"
#include "random_world.h"
#include "state/snapshot.h"

using namespace testbed;

namespace {

constexpr int kSize = 12; // to 24 bodies

struct Request {
    long first = 0, count = 0, steps = 0;
    long dumpSeed = -1, dumpStep = -1, perturbSeed = -1, perturbStep = -1, endSeed = -1, endStep = -1;
};

struct World {
    World(unsigned long seed) : stage(scene, seed, &recorder) {
        recorder.StartStep(false);
        scene.Build(stage, kSize);
    }

    void Step(int step, bool perturb, bool inWords) {
        recorder.StartStep(inWords);
        scene.BeforeStep(stage, step);
        stage.World().Step(scene.TimeStep(), 8, 3);
        if (perturb)
            Perturb();
    }

    void Perturb() {
        b2Body *body = stage.World().GetBodyList();
        while (body != nullptr && !(body->GetType() == b2_dynamicBody && body->IsAwake()))
            body = body->GetNext();
        if (body == nullptr)
            return;
        const b2Vec2 v = body->GetLinearVelocity();
        body->SetLinearVelocity({std::nextafter(v.x, FLT_MAX), v.y});
    }

    differential::RandomWorld scene;
    EventRecorder recorder;
    Stage stage;
};

void Add(differential::Meddling *sum, const differential::Meddling &more) {
    sum->sensors += more.sensors;
    sum->solids += more.solids;
    sum->bullets += more.bullets;
    sum->asleep += more.asleep;
    sum->disabled += more.disabled;
    sum->spent += more.spent;
}

void RunSeed(const Request &request, long seed, differential::Meddling *meddling) {
    const int worlds = seed % 2 == 0 ? 1 : 2;
    std::unique_ptr<World> all[2];
    for (int i = 0; i < worlds; ++i)
        all[i] = std::make_unique<World>(static_cast<unsigned long>(1000003 * i + seed));
    const bool dumping = request.dumpSeed == seed;
    for (int step = 0; step < request.steps; ++step) {
        if (request.endSeed == seed && request.endStep == step) {
            std::fprintf(stderr, "told to end\n");
            std::abort();
        }
        const bool dump = dumping && request.dumpStep == step;
        if (!dumping)
            std::printf("%ld %d", seed, step);
        for (int i = 0; i < worlds; ++i) {
            World &world = *all[i];
            world.Step(step, request.perturbSeed == seed && request.perturbStep == step && i == 0, dump);
            const StateHashes h = HashState(world.stage.World(), world.recorder);
            if (dump)
                std::printf("%s", DescribeState(world.stage.World(), world.recorder).c_str());
            else if (!dumping)
                std::printf(" %016" PRIx64 " %016" PRIx64 " %016" PRIx64 " %016" PRIx64, h.bodies, h.contacts,
                            h.events, world.scene.ProbeHash());
        }
        if (!dumping)
            std::printf("\n");
    }
    for (int i = 0; i < worlds; ++i)
        Add(meddling, all[i]->scene.InImpacts());
    std::fflush(stdout); // a crash of the next seed shall not take this one's lines with it
}

int Usage() {
    std::fprintf(stderr, "usage: FIRST COUNT STEPS%s [dump SEED STEP | perturb SEED STEP | end SEED STEP]\n",
                 std::strcmp(differential::Kind(), "stock") == 0 ? "" : " STRUCTURE on|off|told");
    return 2;
}

} // namespace

int main(int argc, char **argv) {
    Request request;
    int at = 4;
    if (argc < at)
        return Usage();
    request.first = std::atol(argv[1]);
    request.count = std::atol(argv[2]);
    request.steps = std::atol(argv[3]);
    if (std::strcmp(differential::Kind(), "plugin") == 0) {
        const bool off = argc > at + 1 && std::strcmp(argv[at + 1], "off") == 0,
                   told = argc > at + 1 && std::strcmp(argv[at + 1], "told") == 0;
        if (argc < at + 2 || !differential::InstallPlugin(argv[at], !off, told))
            return Usage();
        at += 2;
    }
    for (; at + 2 < argc; at += 3) {
        const auto is = [what = argv[at]](const char *name) { return std::strcmp(what, name) == 0; };
        const long seed = std::atol(argv[at + 1]), step = std::atol(argv[at + 2]);
        if (is("dump")) {
            request.dumpSeed = seed;
            request.dumpStep = step;
        } else if (is("perturb")) {
            request.perturbSeed = seed;
            request.perturbStep = step;
        } else if (is("end")) {
            request.endSeed = seed;
            request.endStep = step;
        } else {
            return Usage();
        }
    }
    if (at != argc)
        return Usage();
    differential::Meddling m;
    for (long seed = request.first; seed < request.first + request.count; ++seed)
        if (request.dumpSeed < 0 || request.dumpSeed == seed)
            RunSeed(request, seed, &m);
    std::fprintf(
        stderr,
        "while impacts were solved: sensors %lu solids %lu bullets %lu asleep %lu disabled %lu spent %lu\n",
        m.sensors, m.solids, m.bullets, m.asleep, m.disabled, m.spent);
    return 0;
}
