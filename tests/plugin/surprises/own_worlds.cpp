// SPDX-License-Identifier: MIT
#include "own_worlds.h"

#include <memory>
#include <new>
#include <thread>

#include "watching.h"

namespace surprises {

namespace {

constexpr float kTimeStep = 1.0f / 60.0f;

/// A world with its crowd; `Step` adds what was seen to `hash`.
struct OwnWorld {
    OwnWorld() : world({0.0f, 0.0f}), watching(&world), crowd(&world, {0.0f, 0.0f}) {}
    void Step(int steps) {
        for (int i = 0; i < steps; ++i) {
            crowd.Tick(step++);
            StepWorld();
        }
    }
    void StepWorld() {
        world.Step(kTimeStep, 4, 2);
        hash.Add(world);
    }
    /// The left ones go to the right ones.
    void Push() {
        for (Pair &pair : crowd.pairs)
            pair.a->SetLinearVelocity({5.0f, 0.0f});
    }
    b2World world;
    Watching watching;
    Crowd crowd;
    Hash hash;
    int step = 0;
};

void PrintBoth(const char *name, const OwnWorld &place) {
    Print((std::string(name) + " bodies").c_str(), place.hash);
    Print((std::string(name) + " events").c_str(), place.watching.hash);
}

/// A world goes with all its contacts; in the same memory another one is built, of the same layout, whose
/// pairs overlap or not.
void PlayRebuilt() {
    alignas(OwnWorld) static unsigned char memory[sizeof(OwnWorld)];
    for (int round = 0; round < 6; ++round) {
        auto *place = new (memory) OwnWorld;
        if (round % 2 == 1)
            for (Pair &pair : place->crowd.pairs)
                pair.a->SetTransform(pair.a->GetPosition() + b2Vec2(0.15f, 0.0f), 0.0f);
        place->Step(15 + round);
        PrintBoth("rebuilt", *place);
        place->~OwnWorld();
    }
}

/// Two worlds in turn, and later each steps the other in its callbacks, and itself by no time.
void PlayInterleaved() {
    auto one = std::make_unique<OwnWorld>(), two = std::make_unique<OwnWorld>();
    for (int i = 0; i < 12; ++i) {
        one->Step(1);
        two->Step(1 + i % 2);
    }
    for (const Place place : {kBeginFirst, kEndLast, kPreImpact, kPostFirst, kFilterLast})
        for (OwnWorld *here : {one.get(), two.get()}) {
            OwnWorld *there = here == one.get() ? two.get() : one.get();
            here->watching.At(place, [there] {
                there->Push();
                there->Step(2);
            });
            here->Step(3);
            here->watching.At(kBeginFirst, [here] { here->world.Step(0.0f, 1, 1); });
            here->Step(3);
        }
    PrintBoth("interleaved", *one);
    PrintBoth("interleaved", *two);
}

/// Needles that turn by next to nothing in each step, until they meet: what is lost in each is lost often.
void PlaySlow(float out) {
    b2World world({0.0f, 0.0f});
    Watching watching(&world);
    Hash hash;
    for (int i = 0; i < 12; ++i) {
        b2PolygonShape needle;
        needle.SetAsBox(1.0f, 0.02f);
        for (const float side : {0.0f, 0.1f}) {
            b2BodyDef def;
            def.type = b2_dynamicBody;
            def.allowSleep = false;
            def.position.Set(out + 3.0f * static_cast<float>(i), side);
            def.angularVelocity = (side > 0.0f ? -0.0006f : 0.0006f) * static_cast<float>(i + 1);
            AddFixture(world.CreateBody(&def), needle);
        }
    }
    for (int i = 0; i < 4000; ++i) {
        world.Step(kTimeStep, 4, 2);
        hash.Add(world);
    }
    Print("slow bodies", hash);
    Print("slow events", watching.hash);
}

/// The same on two threads at once.
void PlayThreads() {
    Hash hashes[2];
    std::thread threads[2];
    for (int i = 0; i < 2; ++i)
        threads[i] = std::thread([&hash = hashes[i], i] {
            for (int round = 0; round < 3; ++round) {
                OwnWorld place;
                place.Step(15);
                place.watching.At(i == 0 ? kBeginFirst : kPostImpact, [&place] { place.Push(); });
                place.Step(8);
                for (const Hash &had : {place.hash, place.watching.hash})
                    hash.Add(static_cast<uint32_t>(had.Value() >> 16));
            }
        });
    for (std::thread &thread : threads)
        thread.join();
    for (const Hash &hash : hashes)
        Print("threads", hash);
}

} // namespace

const std::vector<std::string> &OwnWorlds() {
    static const std::vector<std::string> names = {"rebuilt", "interleaved", "slow", "slow-far-out",
                                                   "threads"};
    return names;
}

bool PlayOwnWorld(const std::string &name) {
    if (name == "rebuilt")
        PlayRebuilt();
    else if (name == "interleaved")
        PlayInterleaved();
    else if (name == "slow" || name == "slow-far-out")
        PlaySlow(name == "slow" ? 0.0f : 600.0f);
    else if (name == "threads")
        PlayThreads();
    else
        return false;
    return true;
}

} // namespace surprises
