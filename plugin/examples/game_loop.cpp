// SPDX-License-Identifier: MIT
// A game of sixty lines with Boomerang: two of them are its own. Rocks fall through a field of slanted planks
// into a goal. If you want a window, draw where the comment says so. Build it on an installed Boomerang with
//
//     c++ -std=c++17 game_loop.cpp $(pkg-config --cflags --libs boomerang-box2d) -o game_loop
//
// and see what BOOMERANG=off and BOOMERANG=verify change: the time, and nothing.
#include <chrono>
#include <cstdio>

#include <boomerang/box2d.h>
#include <box2d/box2d.h>

namespace {

constexpr float kTimeStep = 1.0f / 60.0f;
constexpr int kFrames = 900, kRows = 8, kColumns = 16, kRocks = 150;

/// A rock that enters the goal counts, once.
class Goal : public b2ContactListener {
public:
    void BeginContact(b2Contact *contact) override {
        score += contact->GetFixtureA()->IsSensor() || contact->GetFixtureB()->IsSensor();
    }
    int score = 0;
};

b2Fixture *Add(b2World &world, b2BodyType type, b2Vec2 at, float angle, const b2Shape &shape) {
    b2BodyDef def;
    def.type = type;
    def.position = at;
    def.angle = angle;
    return world.CreateBody(&def)->CreateFixture(&shape, 1.0f);
}

} // namespace

int main() {
    bmr::Install(); // before the first step: all that Boomerang asks for

    b2World world(b2Vec2(0.0f, -10.0f));
    Goal goal;
    world.SetContactListener(&goal);
    b2PolygonShape plank, rock, floor;
    plank.SetAsBox(1.2f, 0.1f);
    floor.SetAsBox(40.0f, 0.5f);
    const b2Vec2 corners[] = {{0.3f, 0.0f}, {0.15f, 0.26f}, {-0.15f, 0.26f}, {-0.3f, 0.0f}, {0.0f, -0.3f}};
    rock.Set(corners, 5);
    for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < kColumns; ++column)
            Add(world, b2_staticBody, {3.0f * (column - 7.5f) + (row % 2) * 1.5f, 2.5f * row},
                row % 2 == 0 ? 0.6f : -0.6f, plank);
    Add(world, b2_staticBody, {0.0f, -4.0f}, 0.0f, floor)->SetSensor(true);

    const auto start = std::chrono::steady_clock::now();
    for (int frame = 0; frame < kFrames; ++frame) {
        if (frame < kRocks)
            Add(world, b2_dynamicBody, {0.25f * (frame % 80 - 40), 2.5f * kRows + 2.0f}, 0.1f * frame, rock);
        world.Step(kTimeStep, 8, 3);
        // Draw here.
    }
    const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
    std::printf("score %d\n", goal.score);
    std::fprintf(stderr, "%.3f ms a step, Boomerang %s\n", spent.count() / kFrames,
                 bmr::IsInstalled() ? "at work" : "off");
}
