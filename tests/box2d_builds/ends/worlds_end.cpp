// SPDX-License-Identifier: MIT
//
//   worlds_end          exit status 0 where worlds that have ended left no memory behind, 1 where they did
//   worlds_end keeps    the control: the worlds do not end, and 1 is right
//
// Each world has a table of pairs. (Its memory would still be reachable: a leak checker says nothing.)
#include <cstdio>
#include <new>

#include <box2d/box2d.h>
#include <malloc.h>

namespace {

constexpr int kWorlds = 50, kRounds = 3, kSteps = 5;

/// A place for each: one that ended is not known again by its address.
alignas(b2World) char places[kRounds * kWorlds][sizeof(b2World)];

void Fill(b2World *world) {
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    b2BodyDef def;
    def.type = b2_dynamicBody;
    for (int i = 0; i < 100; ++i) {
        def.position.Set(1.05f * static_cast<float>(i % 10), 1.05f * static_cast<float>(i / 10));
        world->CreateBody(&def)->CreateFixture(&box, 1.0f);
    }
}

/// Bytes that the process has of its heap afterwards.
size_t Play(int round, bool keeps) {
    for (int i = 0; i < kWorlds; ++i) {
        auto *world = new (places[round * kWorlds + i]) b2World(b2Vec2(0.0f, -10.0f));
        Fill(world);
        for (int step = 0; step < kSteps; ++step)
            world->Step(1.0f / 60.0f, 8, 3);
        if (world->GetContactCount() < 100)
            std::puts("too few contacts for a table");
        if (!keeps)
            world->~b2World();
    }
    return mallinfo2().uordblks;
}

} // namespace

int main(int argc, char **) {
    Play(0, argc > 1); // what is there once for all is there then
    const size_t before = Play(1, argc > 1), after = Play(2, argc > 1);
    std::printf("%zu bytes, then %zu\n", before, after);
    return after > before + 4096 ? 1 : 0;
}
