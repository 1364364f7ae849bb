// SPDX-License-Identifier: MIT
//
//   islands [STEPS [SEEDS [control]]]
//
// Plays each scene of the testbed for so many steps, a wall of bricks, and so many worlds of the actor's,
// where each island is solved by Box2D and by ours (checked_world.cpp). Exit status 0: all had the same bits.
// `control`: one bit is turned once.
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <sys/wait.h>
#include <unistd.h>

#include "actor.h"
#include "checked_world.h"
#include "scene.h"

using namespace box2d_builds;

namespace {

void Play(const testbed::SceneInfo &info, int steps) {
    const auto scene = info.create();
    testbed::Stage stage(*scene, info.seed, nullptr);
    stage.SetPolygons(info.polygons);
    scene->Build(stage, info.size);
    if (!scene->Listens())
        stage.World().SetContactListener(nullptr); // islands are solved together, too
    for (int step = 0; step < steps; ++step) {
        scene->BeforeStep(stage, step);
        stage.World().Step(info.timeStep, info.velocityIterations, info.positionIterations);
    }
}

constexpr int kBricks = 25;

/// Two rows of bricks on a ground: one island. Each step has another number of iterations. At last one
/// brick's velocity overflows, which Box2D hands on to all that stand on the ground.
void PlayBricks(int fastest) {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2PolygonShape ground, brick;
    ground.SetAsBox(30.0f, 1.0f, b2Vec2(0.0f, -1.0f), 0.0f);
    brick.SetAsBox(0.5f, 0.25f);
    const b2BodyDef fixed;
    world.CreateBody(&fixed)->CreateFixture(&ground, 0.0f);
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.allowSleep = false;
    b2Body *fast = nullptr;
    for (int i = 0; i < kBricks; ++i) {
        const float column = static_cast<float>(i / 2), row = static_cast<float>(i % 2);
        def.position.Set(column + 0.5f * row, 0.25f + 0.5f * row);
        b2Body *const body = world.CreateBody(&def);
        body->CreateFixture(&brick, 1.0f);
        if (i == fastest)
            fast = body;
    }
    constexpr int kSteps = 20;
    for (int step = 0; step < kSteps; ++step) {
        if (step == kSteps - 3)
            fast->SetLinearVelocity(b2Vec2(0.0f, -3e38f));
        world.Step(1.0f / 60.0f, 1 + step * 5 % 17, 3);
    }
}

/// The actor's world of this seed, in a process of its own. False if an assertion of Box2D's ended it.
bool PlaysToItsEnd(uint32_t seed) {
    const pid_t child = fork();
    if (child == 0) {
        const auto bytes = actor::BytesOf(seed);
        actor::Actor player(bytes.data(), bytes.size());
        for (actor::Record record; player.PlayOn(&record);) {
        }
        std::_Exit(EXIT_SUCCESS);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child)
        std::abort();
    const bool asserts = WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT && !checked.isInOurs;
    if (!asserts && status != 0) {
        std::printf("FAILED: seed %u ends with status %d\n", seed, status);
        std::exit(EXIT_FAILURE);
    }
    return !asserts;
}

} // namespace

int main(int argc, char **argv) {
    const int steps = argc > 1 ? std::atoi(argv[1]) : 40;
    const int seeds = argc > 2 ? std::atoi(argv[2]) : 12;
    checked.turnsABitIn = argc > 3 ? 1000 : 0;
    for (const testbed::SceneInfo &info : testbed::AllScenes())
        if (std::strcmp(info.group, "any-size") != 0 && std::strcmp(info.group, "outlines") != 0)
            Play(info, steps);
    for (int i = 0; i < kBricks; ++i)
        PlayBricks(i);
    int asserted = 0;
    for (int seed = 1; seed <= seeds; ++seed)
        asserted += PlaysToItsEnd(static_cast<uint32_t>(seed)) ? 0 : 1;
    std::printf("%ld islands with %ld contacts and %ld joints, %ld of them after an impact, %ld with others: "
                "same bits; Box2D's assertions ended %d of %d worlds\n",
                checked.islands, checked.contacts, checked.joints, checked.impacts, checked.together,
                asserted, seeds);
    const bool enough = checked.contacts > 1000 && checked.joints > 100 && checked.impacts > 100 &&
                        checked.together > 1000 && asserted * 20 <= seeds;
    std::puts(enough ? "passed" : "FAILED: too few");
    return enough ? EXIT_SUCCESS : EXIT_FAILURE;
}
