// SPDX-License-Identifier: MIT
//
// How long a step of a small world takes in a game that draws between two steps: the renderer has put the
// world, Box2D and this library's code out of the caches. To be run by cold_steps.sh, with nothing but Box2D
// and with libboomerang_box2d.so preloaded. Nothing of this project is called here.
//
//     bench_cold_steps WORLD SIZE STEPS [warm]
//
// Prints the median of the steps' nanoseconds, and how many contacts the world had on average. A step is what
// the game does to the world (Scene::BeforeStep) and b2World::Step. With "warm" nothing is evicted.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>
#include <vector>

#include "scene.h"
#include "shapes.h"

namespace {

using namespace testbed;

/// One of many functions, each on a line of the caches of its own and with a branch of its own.
template <std::size_t I> __attribute__((noinline, aligned(512))) uint32_t Stray(uint32_t x) {
    return (x & 1) != 0 ? x * (2 * I + 1) : x + 3 * I;
}

template <std::size_t... I> constexpr auto Strays(std::index_sequence<I...>) {
    return std::array<uint32_t (*)(uint32_t), sizeof...(I)>{Stray<I>...};
}

/// What a renderer does to the caches, the translations of addresses and the predictions of branches: calls a
/// megabyte of code, then writes to more memory than a core has to itself.
uint32_t Render(std::vector<uint32_t> &memory) {
    constexpr std::size_t kFunctions = 2048, kWordsOfLine = 16;
    static constexpr auto strays = Strays(std::make_index_sequence<kFunctions>());
    uint32_t x = memory[0];
    for (const auto &stray : strays)
        x = stray(x);
    for (std::size_t i = 0; i < memory.size(); i += kWordsOfLine)
        memory[i] += x;
    return x;
}

/// A small game of platforms: a runner of a box and a circle jumps along a row of them, crates lie about, a
/// lift goes up and down, and coins are sensors. The runner comes through platforms from below: in each step
/// the game gives each platform the filter that lets it pass or holds it.
class Platforms final : public Scene {
    static constexpr uint16 kHolds = 0xffff, kLetsPass = 0x0002, kRunner = 0x0004;
    static constexpr float kLift = 3.0f, kAcross = 4.0f;

    void Build(Stage &stage, int size) override {
        b2Body *ground = stage.AddBody(b2_staticBody, {0.0f, 0.0f});
        for (int i = -1; i <= size; ++i)
            stage.AddFixture(ground,
                             MakeEdge({kAcross * static_cast<float>(i), 0.0f},
                                      {kAcross * static_cast<float>(i + 1), 0.0f}),
                             0.0f);
        for (int i = 0; i < size; ++i) {
            const float x = kAcross * static_cast<float>(i), y = 1.2f + 0.8f * static_cast<float>(i % 3);
            m_platforms.push_back(
                stage.AddFixture(stage.AddBody(b2_staticBody, {x, y}), MakeBox(1.2f, 0.15f), 0.0f));
            stage.AddFixture(AddAwake(stage, {x + 0.5f, y + 0.5f}), MakeBox(0.3f, 0.3f), 1.0f);
            b2FixtureDef coin = Material(0.0f);
            coin.isSensor = true;
            stage.AddFixture(stage.AddBody(b2_staticBody, {x - 0.7f, y + 0.6f}), coin, MakeBox(0.2f, 0.2f));
        }
        m_lift = stage.AddBody(b2_kinematicBody, {-kAcross, kLift});
        stage.AddFixture(m_lift, MakeBox(1.0f, 0.1f), 0.0f);
        m_runner = AddAwake(stage, {0.0f, 5.0f});
        m_runner->SetFixedRotation(true);
        b2FixtureDef flesh = Material(1.0f, 0.1f);
        flesh.filter.categoryBits = kRunner;
        stage.AddFixture(m_runner, flesh, MakeBox(0.25f, 0.4f));
        stage.AddFixture(m_runner, flesh, MakeCircle(0.25f, {0.0f, -0.4f}));
        m_end = kAcross * static_cast<float>(size - 1);
    }

    void BeforeStep(Stage &, int step) override {
        constexpr int kJump = 50;
        const b2Vec2 feet = m_runner->GetPosition();
        m_speed = feet.x > m_end ? -3.0f : feet.x < 0.0f ? 3.0f : m_speed;
        m_runner->SetLinearVelocity({m_speed, step % kJump == 0 ? 8.0f : m_runner->GetLinearVelocity().y});
        m_lift->SetLinearVelocity({0.0f, step / kJump % 2 == 0 ? 1.0f : -1.0f});
        for (b2Fixture *platform : m_platforms) {
            b2Filter filter = platform->GetFilterData();
            const bool above = feet.y - 0.6f > platform->GetBody()->GetPosition().y;
            filter.maskBits = above ? kHolds : static_cast<uint16>(kHolds & ~kRunner);
            platform->SetFilterData(filter);
        }
    }

    static b2Body *AddAwake(Stage &stage, b2Vec2 place) {
        b2Body *body = stage.AddBody(b2_dynamicBody, place);
        body->SetSleepingAllowed(false);
        return body;
    }

    std::vector<b2Fixture *> m_platforms;
    b2Body *m_runner = nullptr, *m_lift = nullptr;
    float m_speed = 3.0f, m_end = 0.0f;
};

const SceneInfo platforms = {"platforms", "a small game of platforms", "games", "platforms", 5,
                             600,         CreateScene<Platforms>};

} // namespace

int main(int argc, char **argv) {
    const bool wantsPlatforms = argc > 1 && std::strcmp(argv[1], platforms.name) == 0;
    const SceneInfo *info = wantsPlatforms ? &platforms : argc > 1 ? FindScene(argv[1]) : nullptr;
    const int size = argc > 3 ? std::atoi(argv[2]) : 0, steps = argc > 3 ? std::atoi(argv[3]) : 0;
    if (info == nullptr || size < 1 || steps < 1) {
        std::fprintf(
            stderr,
            "usage: bench_cold_steps WORLD SIZE STEPS [warm]; the worlds are platforms and the testbed's\n");
        return 2;
    }
    const bool cold = argc < 5;
    constexpr std::size_t kWords = std::size_t{1} << 20;
    std::vector<uint32_t> memory(cold ? kWords : 1);
    const auto scene = info->create();
    Stage stage(*scene, info->seed, nullptr);
    scene->Build(stage, size);
    b2World &world = stage.World();
    std::vector<long> times;
    long contacts = 0;
    uint32_t seen = 0;
    for (int step = 0; step < steps; ++step) {
        if (cold)
            seen += Render(memory);
        const auto begun = std::chrono::steady_clock::now();
        scene->BeforeStep(stage, step);
        world.Step(info->timeStep, info->velocityIterations, info->positionIterations);
        times.push_back(static_cast<long>((std::chrono::steady_clock::now() - begun).count()));
        contacts += world.GetContactCount();
    }
    std::nth_element(times.begin(), times.begin() + steps / 2, times.end());
    std::printf("%ld %.1f%s\n", times[static_cast<std::size_t>(steps / 2)],
                static_cast<double>(contacts) / steps, seen == 0 && cold ? " " : "");
}
